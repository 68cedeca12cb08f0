#pragma once
/// A set of voxels seen along each axis from both sides: whether two of them can be drawn apart along an axis takes no
/// more than that.

#include <array>
#include <cstdint>
#include <vector>

#include "voxel/bit_grid.hpp"

namespace spectralpack {

class Outlines {
  public:
    /// Of no voxels in a grid of that extent.
    explicit Outlines(const Extent& extent);
    /// O(words + voxels of its surface).
    explicit Outlines(const BitGrid& voxels);

    /// Those of these voxels and of `others`, moved by `at`; lines of theirs that are beside the extent are left out.
    /// O(lines of the others).
    void join(const Outlines& others, const VoxelIndex& at);

    /// Whether these voxels, moved by `at`, leave `others`, which they do not meet there, by going along some axis one
    /// way or the other, however far. O(lines that both have).
    bool leave(const Outlines& others, const VoxelIndex& at) const;

    bool operator==(const Outlines&) const = default;

    std::int64_t bytes() const { return bytes_for(extent_); }
    static std::int64_t bytes_for(const Extent& extent);

  private:
    /// Of the lines along an axis: its first and its last voxel; where a line has none, one beyond all others'.
    struct Ends {
        std::vector<int> first, last;

        bool operator==(const Ends&) const = default;
    };

    static int across(int axis) { return axis == 0 ? 1 : 0; }  ///< the axis along which lines are counted
    static int up(int axis) { return axis == 2 ? 1 : 2; }      ///< and the one after which those come
    bool leave_along(int axis, const Outlines& others, const VoxelIndex& at) const;

    Extent extent_;
    std::array<Ends, 3> along_;  // line (i, j) of axis a is at j * extent_[across(a)] + i
};

}  // namespace spectralpack
