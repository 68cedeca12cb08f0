#pragma once
/// Some of a solid's rows, which stand for it where a walk through free positions is asked for: what some of it cannot
/// do, all of it cannot, and fewer rows take fewer look-ups.

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// The rows along x with y + z a multiple of n, where n grows with the voxels along the solid: all rows of one up to
/// 2 rows_along - 1 long. What is as thick as n voxels, or half of that both ways, cannot slip between them.
BitGrid row_sample(const BitGrid& solid, int rows_along);

}  // namespace spectralpack
