#include "packing/refinement.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace spectralpack {

Refinement::Refinement(const RefineSetup& setup, double voxel_size, int detail, PartOf part_of, MayStand may_stand,
                       const Workers& workers)
    : setup_(setup),
      voxel_size_(voxel_size),
      detail_(detail),
      part_of_(std::move(part_of)),
      may_stand_(std::move(may_stand)),
      workers_(workers),
      refiner_(setup) {}

const Refinement::Turned& Refinement::turned(int part, int orientation) {
    if (part != part_) {
        turned_.clear();
        current_ = part_of_(part);
        surface_ = std::make_unique<Bvh>(current_.mesh);
        part_ = part;
    }
    const auto [entry, fresh] = turned_.try_emplace(orientation);
    if (fresh) {
        const Mat3& turn = (*current_.orientations)[static_cast<std::size_t>(orientation)];
        entry->second = {transformed(current_.mesh, {turn, {}}),
                         std::make_shared<const Bvh>(surface_->turned(turn))};
    }
    return entry->second;
}

Standing Refinement::settle(const PackItem& item, const Shape& shape, const BestPlacement& best) {
    const auto start = std::chrono::steady_clock::now();
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
    Standing standing = stand_on_grid(shape, best, voxel_size_, detail_, setup_.wall_gap);
    const Turned& copy = turned(item.part, oriented.orientation);
    StandingCopy refined{copy.surface, standing.offset, current_.gap};
    const Vec3 slid = refiner_.refine(refined, descent(best.neighbours)).offset;
    if (may_stand_(item.part, oriented.orientation, slid)) refined.offset = slid;
    standing.offset = refined.offset;
    const Vec3 walls{setup_.wall_gap, setup_.wall_gap, setup_.wall_gap};
    StandingVoxels voxels =
        voxelize_at(copy.mesh, refined.offset + oriented.min - walls, voxel_size_ / detail_, workers_);
    standing.object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, detail_,
                                  shape.gap_class);
    refiner_.add(std::move(refined));
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return standing;
}

std::optional<double> Refinement::least_gap() const {
    double least = Box::kInfinity;
    for (Refiner::CopyId id = 0; const StandingCopy* copy = refiner_.find(id); ++id) {
        if (!copy->wall) least = refiner_.clearance(*copy, least, id);
    }
    return std::isfinite(least) ? std::optional(least) : std::nullopt;
}

}  // namespace spectralpack
