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

void Refinement::take_mesh(int part, int orientation, const StopToken& stop) {
    if (last_ == TurnedPart{part, orientation}) return;
    const TurnedPart before = std::exchange(last_, kNone);
    mesh_ = surfaces_.turned_mesh(part, orientation);
    if (before.part != part) closed_ = is_closed(mesh_, stop);
    last_ = {part, orientation};
}

/// `standing` is the mesh taken last.
Settled Refinement::put(PlacedSurface standing, int gap_class) {
    const Vec3 walls{options_.wall_gap, options_.wall_gap, options_.wall_gap};
    StandingVoxels voxels = voxelize_at(mesh_, standing.box().min - walls, voxel_size_ / detail_, closed_, workers_);
    Settled settled{standing.offset, fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)),
                                                 voxels.position, detail_, gap_class)};
    refiner_.add(std::move(standing));
    return settled;
}

Settled Refinement::settle(const Copy& copy, const Shape& shape, const BestPlacement& best, const StopToken& stop) {
    const Stopwatch watch;
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
    const Vec3 on_grid = settle_on_grid(shape, best, voxel_size_, detail_, options_.wall_gap).offset;
    take_mesh(copy.part, oriented.orientation, stop);
    PlacedSurface refined{surfaces_.at(copy.part, oriented.orientation, stop), on_grid, surfaces_.part(copy.part).gap};
    const Vec3 slid = refiner_.refine(refined, descent(best.neighbours), workers_).offset;
    if (may_stand_(copy.part, oriented.orientation, slid)) refined.offset = slid;
    Settled settled = put(std::move(refined), shape.gap_class);
    seconds_ += watch.seconds();
    return settled;
}

Settled Refinement::stand_at(const Copy& copy, int orientation, const Vec3& offset, int gap_class) {
    const Stopwatch watch;
    take_mesh(copy.part, orientation);
    Settled settled = put({surfaces_.at(copy.part, orientation), offset, surfaces_.part(copy.part).gap}, gap_class);
    seconds_ += watch.seconds();
    return settled;
}

void Refinement::stand_still(const PlacedCopy& placed) {
    const int part = placed.copy.part;
    refiner_.add({surfaces_.at(part, placed.orientation), placed.offset, surfaces_.part(part).gap});
}

void Refinement::restart() {
    refiner_ = Refiner(options_);
    for (const PlacedSurface& obstacle : from_start_) {
        refiner_.add(obstacle);
    }
}

}  // namespace spectralpack
