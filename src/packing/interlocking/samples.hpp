#pragma once
/// What stands for a solid where ways are looked for: some of its rows, and cells of positions. Where a part of a solid
/// cannot go, all of it cannot, and fewer rows take fewer look-ups.
///
/// Cells: positions in blocks of 1 x 2 x 2, in which links are shown sixteen times sooner than position by position.
/// Cell (X, Y, Z) holds positions (X, 2Y + i, 2Z + j), i and j from 0 to 1. Let b' be the voxels v of an object b with
/// all of v + (0, i, j) in b. Where w + (X, 2Y, 2Z) lies in b' for some voxel w of a sample, w + q lies in b for each
/// position q of the cell, so the sample meets b at all four. If it is asked for voxels w at even y and z alone, b' is
/// needed at even ones alone: sample and object are then solids with half as many rows each way, and a walk from cell
/// to cell goes wherever one from position to position can. Where it finds no way out, there is none.

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// The rows along x with y + z a multiple of n, where n grows with the voxels along the solid: all rows of one up to
/// 2 rows_along - 1 long. What is as thick as n voxels, or half of that both ways, cannot slip between them.
BitGrid row_sample(const BitGrid& solid, int rows_along);

/// The rows of a sample at even y and z: extents (x, y / 2, z / 2), rounded up.
BitGrid sample_in_cells(const BitGrid& sample);

/// The rows of b' at even y and z: extents (x, y / 2, z / 2), rounded down, but 1 at least.
BitGrid object_in_cells(const BitGrid& object);

/// The cell that a position lies in.
VoxelIndex cell_of(const VoxelIndex& position);

}  // namespace spectralpack
