#include "search/cpu/shapes/depths.hpp"

#include <algorithm>

#include "voxel/distance_field.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

/// Of every voxel, 0 outside the solid.
Grid<std::int32_t> distance_to_outside(const BitGrid& solid) {
    BitGrid outside(solid.extent());
    outside.fill(true);
    subtract(outside, solid, {});
    return manhattan_distance(outside, Ceiling::closed);
}

}  // namespace

Depths::Depths(const BitGrid& solid, int axis) : padded_(solid.extent()) {
    const Extent& n = solid.extent();
    ++padded_[axis];
    VoxelIndex next;
    next[axis] = 1;
    step_ = place(next);
    before_.assign(static_cast<std::size_t>(padded_.count()), 0);
    const Grid<std::int32_t> depth = distance_to_outside(solid);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            std::uint32_t* before = before_.data() + place(0, y, z);
            for (int x = 0; x < n.x; ++x) {
                before[static_cast<std::size_t>(x) + step_] =
                    before[x] + static_cast<std::uint32_t>(std::min(kDeepest, depth.at(x, y, z)));
            }
        }
    }
}

Depths depths_of(const OrientedShape& shape, const Runs& solid, int detail) {
    if (detail == 1) return {*shape.solid, solid.axis};
    return {filled_voxels(*shape.fine, {}, detail).voxels, solid.axis};
}

std::vector<std::uint32_t> Depths::sums(const Runs& runs) const {
    std::vector<std::uint32_t> sums;
    sums.reserve(runs.runs.size());
    for (const Run& run : runs.runs) {
        sums.push_back(sum(run));
    }
    return sums;
}

}  // namespace spectralpack
