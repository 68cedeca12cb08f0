#include "packing/tray/refinement.hpp"

#include <cmath>
#include <utility>

#include "core/stopwatch.hpp"
#include "geometry/mesh_edges.hpp"

namespace spectralpack {

Refinement::Refinement(const RefineOptions& options, double voxel_size, int detail, PartSurfaces& surfaces,
                       MayStand may_stand, const Workers& workers)
    : options_(options),
      voxel_size_(voxel_size),
      detail_(detail),
      surfaces_(surfaces),
      may_stand_(std::move(may_stand)),
      workers_(workers),
      refiner_(options) {}

Settled Refinement::settle(const Copy& copy, const Shape& shape, const BestPlacement& best) {
    const Stopwatch watch;
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
    Settled settled = settle_on_grid(shape, best, voxel_size_, detail_, options_.wall_gap);
    if (last_ != TurnedPart{copy.part, oriented.orientation}) {
        mesh_ = surfaces_.turned_mesh(copy.part, oriented.orientation);
        if (last_.part != copy.part) closed_ = is_closed(mesh_);
        last_ = {copy.part, oriented.orientation};
    }
    PlacedSurface refined{surfaces_.at(copy.part, oriented.orientation), settled.offset, surfaces_.part(copy.part).gap};
    const Vec3 slid = refiner_.refine(refined, descent(best.neighbours), workers_).offset;
    if (may_stand_(copy.part, oriented.orientation, slid)) refined.offset = slid;
    settled.offset = refined.offset;
    const Vec3 walls{options_.wall_gap, options_.wall_gap, options_.wall_gap};
    StandingVoxels voxels = voxelize_at(mesh_, refined.box().min - walls, voxel_size_ / detail_, closed_, workers_);
    settled.object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, detail_,
                                 shape.gap_class);
    refiner_.add(std::move(refined));
    seconds_ += watch.seconds();
    return settled;
}

}  // namespace spectralpack
