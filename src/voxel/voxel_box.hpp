#pragma once
/// A box of voxels, half open: lo <= v < hi on every axis. Empty when some hi <= lo.

#include <algorithm>

#include "spectralpack/grid.hpp"

namespace spectralpack {

struct VoxelBox {
    VoxelIndex lo, hi;

    bool empty() const { return hi.x <= lo.x || hi.y <= lo.y || hi.z <= lo.z; }
    bool operator==(const VoxelBox&) const = default;
};

inline VoxelBox whole(const Extent& extent) { return {{0, 0, 0}, {extent.x, extent.y, extent.z}}; }

/// Its layer z alone.
inline VoxelBox layer_of(VoxelBox box, int z) {
    box.lo.z = z;
    box.hi.z = z + 1;
    return box;
}

inline VoxelBox intersection(const VoxelBox& a, const VoxelBox& b) {
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = std::max(a.lo[axis], b.lo[axis]);
        box.hi[axis] = std::min(a.hi[axis], b.hi[axis]);
    }
    return box;
}

/// The smallest box that holds both; an empty box adds nothing.
inline VoxelBox hull(const VoxelBox& a, const VoxelBox& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = std::min(a.lo[axis], b.lo[axis]);
        box.hi[axis] = std::max(a.hi[axis], b.hi[axis]);
    }
    return box;
}

}  // namespace spectralpack
