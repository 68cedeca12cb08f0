#pragma once
/// Grids with their axes exchanged.

#include <array>

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// The grid whose axis i is axis `source_axes[i]` of `grid`; source_axes is a permutation of 0,
/// 1, 2.
BitGrid permuted(const BitGrid& grid, const std::array<int, 3>& source_axes);

}  // namespace spectralpack
