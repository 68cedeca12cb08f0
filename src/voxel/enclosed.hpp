#pragma once
/// Third part of a solid voxelisation: closed hollows.

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// Sets every voxel that cannot be reached from outside the grid through voxels that are not set,
/// going from face to face. A flood fill by whole rows: O(words), a few visits each for ordinary
/// parts.
void fill_enclosed(BitGrid& grid);

}  // namespace spectralpack
