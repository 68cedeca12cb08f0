#pragma once
/// Blocks of 4^3 voxels of a tray as bits, a word for 256 voxels of a row, and the blocks of positions from which a
/// shape reaches into them: what changed anywhere is so spread to all positions of an orientation at once.

#include <vector>

#include "voxel/bit_grid.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

/// Which blocks of a grid of `extent` hold a voxel that is in one of the boxes or at most `margin` beyond along each
/// axis.
BitGrid blocks_of(const std::vector<VoxelBox>& boxes, int margin, const Extent& extent);

/// From which blocks a shape of `extent` reaches into one of `blocks`, whatever position of the block it stands at (and
/// from some of which it may not quite).
BitGrid blocks_reaching(BitGrid blocks, const Extent& extent);

}  // namespace spectralpack
