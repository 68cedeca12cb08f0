#pragma once
/// A solid cut into cells, cubes around points c. What one value of phi says about a cell holds for a whole block of
/// positions: phi is 1-Lipschitz, so if phi(c + q) >= v then phi(x + q) >= v - |x - c| for every voxel x; and at a free
/// position phi(x + q) >= delta(x), the depth of x. In a crowd that is little. It rules out the open, where most
/// positions of a large or fine tray lie, for a few loads a block, all from a small table.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/cpu/shapes/depths.hpp"
#include "search/cpu/shapes/runs.hpp"
#include "search/cpu/tables/block_minima.hpp"

namespace spectralpack {

/// Of a cell: where phi(c + q) >= v, its voxels come to weight * max(0, v - drop) above their depths.
struct SolidCell {
    VoxelIndex block;          ///< c's
    std::int64_t offset = 0;   ///< of c's block from the position's block
    std::uint32_t weight = 0;  ///< voxels
    std::uint16_t drop = 0;    ///< mean of their distance from c and their depth together, rounded up
};

/// The whole solid in cells, heaviest first.
struct CellList {
    std::int64_t least = 0;  ///< what rho comes to at least at a free position
    std::vector<SolidCell> cells;
};

/// Cells of edge^3 voxels or, where that would be more than `most_cells`, twice that edge and so on, for
/// rho(q) >= least + sum of weight * max(0, v - drop), v being the minimum of the block of c + q. `edge` is a power of
/// two and no less than a block's. `depths`: the solid's. `most`: no phi is above it.
/// O(voxels).
CellList list_cells(const Runs& solid, const Extent& extent, const BlockLayout& blocks, int most, int edge,
                    std::size_t most_cells, const TurnedDepths& depths);

}  // namespace spectralpack
