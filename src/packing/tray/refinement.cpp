#include "packing/tray/refinement.hpp"

#include <cmath>
#include <utility>

#include "core/stopwatch.hpp"
#include "geometry/mesh_edges.hpp"

namespace spectralpack {

Refinement::Refinement(const RefineSetup& setup, double voxel_size, int detail, PartSurfaces& surfaces,
                       MayStand may_stand, const Workers& workers)
    : setup_(setup),
      voxel_size_(voxel_size),
      detail_(detail),
      surfaces_(surfaces),
      may_stand_(std::move(may_stand)),
      workers_(workers),
      refiner_(setup) {}

Standing Refinement::settle(const PackItem& item, const Shape& shape, const BestPlacement& best) {
    const Stopwatch watch;
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
    Standing standing = stand_on_grid(shape, best, voxel_size_, detail_, setup_.wall_gap);
    if (last_ != TurnedPart{item.part, oriented.orientation}) {
        mesh_ = surfaces_.turned_mesh(item.part, oriented.orientation);
        if (last_.part != item.part) closed_ = is_closed(mesh_);
        last_ = {item.part, oriented.orientation};
    }
    StandingCopy refined{surfaces_.at(item.part, oriented.orientation), standing.offset, surfaces_.part(item.part).gap};
    const Vec3 slid = refiner_.refine(refined, descent(best.neighbours), workers_).offset;
    if (may_stand_(item.part, oriented.orientation, slid)) refined.offset = slid;
    standing.offset = refined.offset;
    const Vec3 walls{setup_.wall_gap, setup_.wall_gap, setup_.wall_gap};
    StandingVoxels voxels = voxelize_at(mesh_, refined.box().min - walls, voxel_size_ / detail_, closed_, workers_);
    standing.object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, detail_,
                                  shape.gap_class);
    refiner_.add(std::move(refined));
    seconds_ += watch.seconds();
    return standing;
}

}  // namespace spectralpack
