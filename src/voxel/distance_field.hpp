#pragma once
/// phi (equation 3) with the Manhattan distance in voxels (appendix A.1): 0 on occupied voxels.

#include <cstdint>

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// What lies beyond the grid: everything outside is occupied, except above an open top.
enum class Ceiling { closed, open };

/// Manhattan distance of every voxel to the nearest occupied voxel, those outside the grid included
/// (the voxel layer next to a wall has distance 1). One forward and one backward sweep per axis;
/// O(voxels). Exact.
Grid<std::int32_t> manhattan_distance(const BitGrid& occupied, Ceiling ceiling);

}  // namespace spectralpack
