#pragma once
/// Turns that only exchange and reverse axes, and what they make of grids. Between any two of the 24 rotations of the
/// cube there is such a turn, so one voxelisation serves them all.

#include <array>
#include <optional>

#include "spectralpack/geometry.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

using AxisOrder = std::array<int, 3>;  ///< a permutation of 0, 1, 2: axis i is taken from axis order[i]

/// Axis i is taken from axis order[i], and runs the other way where reversed[i].
struct AxisTurn {
    AxisOrder order{0, 1, 2};
    std::array<bool, 3> reversed{};

    bool reverses() const { return reversed[0] || reversed[1] || reversed[2]; }
    bool operator==(const AxisTurn&) const = default;
};

/// The turn that leads back.
AxisTurn inverse(const AxisTurn& turn);

/// `first`, then `second`.
AxisTurn chained(const AxisTurn& first, const AxisTurn& second);

/// The turn by which rotation `to` follows from rotation `from`, to the last bit, where there is one: row i of `to` is
/// row order[i] of `from`, negated where reversed[i].
std::optional<AxisTurn> axis_turn(const Mat3& from, const Mat3& to);

/// The grid turned: its axis i is axis order[i] of `grid`; reversed along an axis, its last voxel there becomes the
/// first. O(words), some six steps each where x changes its place or is reversed.
BitGrid turned(const BitGrid& grid, const AxisTurn& turn);

/// True if turned() gives back the grid. O(words), but as a rule it ends at the first rows that differ.
bool is_symmetric(const BitGrid& grid, const AxisTurn& turn);

inline Extent turned(const Extent& grid, const AxisTurn& turn) {
    return {grid[turn.order[0]], grid[turn.order[1]], grid[turn.order[2]]};
}

/// Where a box of voxels of a grid with these extents comes to lie as that is turned; it may reach beyond the grid.
inline VoxelBox turned(const VoxelBox& box, const AxisTurn& turn, const Extent& grid) {
    VoxelBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const int from = turn.order[i], low = box.lo[from], high = box.hi[from];
        result.lo[axis] = turn.reversed[i] ? grid[from] - high : low;
        result.hi[axis] = turn.reversed[i] ? grid[from] - low : high;
    }
    return result;
}

/// Where many boxes of one size come to lie: the lowest voxels of them, as turned() boxes have them.
class TurnedCorners {
  public:
    TurnedCorners(const AxisTurn& turn, const Extent& grid, const Extent& box) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int from = turn.order[axis];
            along_[axis] = from == 0 ? &VoxelIndex::x : from == 1 ? &VoxelIndex::y : &VoxelIndex::z;
            step_[axis] = turn.reversed[axis] ? -1 : 1;
            first_[axis] = turn.reversed[axis] ? grid[from] - box[from] : 0;
        }
    }
    VoxelIndex operator()(const VoxelIndex& corner) const { return {at(0, corner), at(1, corner), at(2, corner)}; }

  private:
    int at(std::size_t axis, const VoxelIndex& corner) const {
        return first_[axis] + step_[axis] * corner.*along_[axis];
    }

    std::array<int VoxelIndex::*, 3> along_{};
    std::array<int, 3> step_{}, first_{};
};

/// The box turned about the origin.
Box turned(const Box& box, const AxisTurn& turn);

}  // namespace spectralpack
