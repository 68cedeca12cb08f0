#pragma once
/// Free positions of a shape among the objects of Omega_move, a row of bits at a time (for flood
/// fill and re-insertion, paper sections 4.1 and 4.3).

#include <cstdint>
#include <vector>

#include "search/cpu/runs.hpp"
#include "search/placement_search.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

class FreeRows final : public FreeRowReader {
  public:
    /// Positions origin + (x, y, z) with 0 <= (x, y, z) < extent of the returned rows; origin = -(a
    /// - 1) - padding per axis, extent = n + a - 1 + 2 padding. O(words of omega) to build.
    FreeRows(const BitGrid& omega, const BitGrid& solid, int padding);

    const VoxelIndex& origin() const override { return origin_; }
    const Extent& extent() const override { return extent_; }

    /// O(runs x count).
    void words(int y, int z, int first, int count, std::uint64_t* free) const override;

  private:
    Extent grid_;
    VoxelIndex origin_;
    Extent extent_;
    int levels_ = 0;                // tables of pieces of 2^k voxels, k < levels_
    std::vector<BitGrid> dilated_;  // bit X + shift_: something in X .. X + 2^k - 1
    int shift_ = 0;
    Runs runs_;  // along x
};

}  // namespace spectralpack
