#pragma once
/// How deep a solid's voxels lie inside it, which bounds phi from below where the solid is free: all voxels nearer to x
/// than delta(x) belong to the solid, so at a free position q none of them is occupied and phi(x + q) >= delta(x).

#include <cstdint>
#include <vector>

#include "search/cpu/runs.hpp"

namespace spectralpack {

inline constexpr int kDeepest = 63;

class Depths {
  public:
    /// delta(x) = min(kDeepest, Manhattan distance from x to the nearest voxel outside `solid`). `runs` are the solid's
    /// own. O(voxels of the solid's grid), a byte for each.
    Depths(const BitGrid& solid, const Runs& runs);

    /// The sum over a run of voxels along `axis`, within the solid's grid; outside the solid delta is 0.
    std::uint32_t sum(const Run& run, int axis) const;
    std::vector<std::uint32_t> sums(const Runs& runs) const;

  private:
    /// Of voxel (0, y, z), in depth_.
    std::ptrdiff_t row(int y, int z) const { return kMargin + step_[2] * z + step_[1] * y; }
    void lower_along_x(int z);
    void lower_from_neighbours(std::ptrdiff_t first, std::ptrdiff_t step, int count, std::ptrdiff_t length);

    static constexpr std::ptrdiff_t kMargin = 32;  // the farthest that is looked along x at once

    Extent extent_;
    std::ptrdiff_t step_[3];  // from a voxel to the next along each axis
    // Rows have a 0 behind their end, and there are zeros before the first and behind the last.
    std::vector<std::uint8_t> depth_;
};

}  // namespace spectralpack
