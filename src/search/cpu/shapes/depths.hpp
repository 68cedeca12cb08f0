#pragma once
/// How deep a solid's voxels lie inside it, which bounds phi from below where the solid is free: all voxels nearer to x
/// than delta(x) belong to the solid, so at a free position q none of them is occupied and phi(x + q) >= delta(x).

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/cpu/shapes/runs.hpp"
#include "search/shape.hpp"
#include "voxel/axis_turn.hpp"

namespace spectralpack {

inline constexpr int kDeepest = 63;

class Depths {
  public:
    /// delta(x) = min(kDeepest, Manhattan distance from x to the nearest voxel outside `solid`), to be summed up along
    /// `axis`. O(voxels of the solid's grid), eight bytes for each.
    Depths(const BitGrid& solid, int axis);

    /// The sum over a run of voxels along the axis, within the solid's grid; outside the solid
    /// delta is 0. O(1).
    std::uint32_t sum(const Run& run) const {
        const std::size_t first = place(run.start);
        return before_[first + step_ * static_cast<std::size_t>(run.length)] - before_[first];
    }
    std::vector<std::uint32_t> sums(const Runs& runs) const;

  private:
    std::size_t place(const VoxelIndex& v) const { return place(v.x, v.y, v.z); }
    std::size_t place(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(padded_.y) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(padded_.x) +
               static_cast<std::size_t>(x);
    }

    Extent padded_;                      // the solid's, and a layer more along the axis
    std::size_t step_;                   // from a voxel to the next along it
    std::vector<std::uint32_t> before_;  // what lies before each voxel in its row along the axis, summed up
};

/// Depths in the solid, `solid` being its runs, of the voxels that the tray's other objects keep off: with s > 1 those
/// that it fills altogether.
Depths depths_of(const OrientedShape& shape, const Runs& solid, int detail);

/// Depths in a solid that was turned, from those before.
class TurnedDepths {
  public:
    /// `solid`: the extents after the turn. Refers to `depths`.
    TurnedDepths(const Depths& depths, const AxisTurn& turn, const Extent& solid)
        : depths_(depths), back_(inverse(turn), solid, {1, 1, 1}) {}

    /// As Depths::sum(), in the turned solid, whose runs lie along `axis`.
    std::uint32_t sum(const Run& run, int axis) const {
        VoxelIndex last = run.start;
        last[axis] += run.length - 1;
        const VoxelIndex a = back_(run.start), b = back_(last);
        return depths_.sum({{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}, run.length});
    }

  private:
    const Depths& depths_;
    TurnedCorners back_;
};

}  // namespace spectralpack
