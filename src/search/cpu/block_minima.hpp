#pragma once
/// The least phi of each block of the grid, and what one such value says about a whole block of positions: phi is
/// 1-Lipschitz, so if phi(c + q) >= v then phi(x + q) >= v - |x - c| for every voxel x. That is little in a crowd, and
/// rules out the open, where most positions of a large or fine tray lie, for a few loads a block.

#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/distance_grid.hpp"
#include "search/cpu/runs.hpp"

namespace spectralpack {

class BlockMinima {
  public:
    BlockMinima() = default;
    /// Blocks of block^3 voxels from the grid's corner on. Not right before the first update().
    BlockMinima(const Extent& grid, int block);

    /// Makes the minima right after phi changed within `changed`.
    void update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers);

    bool operator==(const BlockMinima&) const = default;

    int block() const { return block_; }
    std::int64_t offset(const VoxelIndex& block) const {
        return (static_cast<std::int64_t>(block.z) * blocks_.y + block.y) * blocks_.x + block.x;
    }
    /// Of a block in the grid, or of the row behind the last; kOverrun values from there on may be read.
    const std::uint16_t* at(const VoxelIndex& block) const { return values_.data() + offset(block); }
    static constexpr int kOverrun = 64;

    std::int64_t bytes() const { return static_cast<std::int64_t>(values_.size() * 2); }

  private:
    Extent blocks_;
    int block_ = 1;
    std::vector<std::uint16_t> values_;
};

/// A part of a solid, a cube's worth of it, seen from one point c: where phi(c + q) >= v, its voxels come to
/// weight * max(0, v - drop) above their least.
struct SolidCell {
    VoxelIndex block;          ///< c's
    std::int64_t offset = 0;   ///< of c's block from the position's block
    std::uint32_t weight = 0;  ///< voxels
    std::uint16_t drop = 0;    ///< their mean distance from c, rounded up, and their least
};

/// The whole solid in a few cells, heaviest first.
struct CellPlan {
    std::int64_t least = 0;  ///< what rho comes to at least at a free position
    std::vector<SolidCell> cells;
};

/// Cells for rho(q) >= least + sum of weight * max(0, v - drop), with v the minimum of the block of c + q. `apart`:
/// phi >= 1 on all voxels of a free solid. `most`: no phi is above it. O(runs).
CellPlan plan_cells(const Runs& solid, const Extent& extent, const BlockMinima& minima, int most, bool apart);

}  // namespace spectralpack
