#include "disassembly/ways/closed_region.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

// Positions along an axis: where there are more, little of the box around is left out.
constexpr int kMostPositions = 16;

/// The voxels within 0 .. by - 1 of those of `grid` along an axis, upwards.
void spread(BitGrid& grid, int axis, int by) {
    for (int reach = 1; reach < by;) {
        VoxelIndex step;
        step[axis] = std::min(reach, by - reach);
        const BitGrid before = grid;
        unite(grid, before, step);
        reach += step[axis];
    }
}

}  // namespace

ClosedRegion::ClosedRegion(const BitGrid& solid, const VoxelBox& positions) {
    const Extent& e = solid.extent();
    box_ = {positions.lo, positions.hi + VoxelIndex{e.x - 1, e.y - 1, e.z - 1}};
    const VoxelIndex range = positions.hi - positions.lo;
    if (std::max({range.x, range.y, range.z}) > kMostPositions) return;
    voxels_ = BitGrid({e.x + range.x - 1, e.y + range.y - 1, e.z + range.z - 1});
    unite(voxels_, solid, {0, 0, 0});
    for (int axis = 0; axis < 3; ++axis) {
        spread(voxels_, axis, range[axis]);
    }
}

bool ClosedRegion::touches(const TrayObject& object) const {
    if (intersection(box_, object.box()).empty()) return false;
    return voxels_.words().empty() || intersects(voxels_, *object.solid, object.position - box_.lo);
}

}  // namespace spectralpack
