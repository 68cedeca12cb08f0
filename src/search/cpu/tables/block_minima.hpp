#pragma once
/// The least phi of each block of the grid: a 64th of its size, so it stays in the caches where phi does not.

#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/tables/distance_grid.hpp"

namespace spectralpack {

/// Where in the minima what lies.
class BlockLayout {
  public:
    BlockLayout() = default;
    /// Blocks of block^3 voxels from the grid's corner on.
    BlockLayout(const Extent& grid, int block);

    bool operator==(const BlockLayout&) const = default;

    int block() const { return block_; }
    std::int64_t offset(const VoxelIndex& block) const {
        return (static_cast<std::int64_t>(block.z) * blocks_.y + block.y) * blocks_.x + block.x;
    }

  protected:
    Extent blocks_;
    int block_ = 1;
};

class BlockMinima : public BlockLayout {
  public:
    BlockMinima() = default;
    /// Not right before the first update().
    BlockMinima(const Extent& grid, int block);

    /// Makes the minima right after phi changed within `changed`.
    void update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers);

    bool operator==(const BlockMinima&) const = default;

    /// Of a block in the grid, or of the row behind the last; kOverrun values from there on may be read.
    const std::uint16_t* at(const VoxelIndex& block) const { return values_.data() + offset(block); }
    static constexpr int kOverrun = 64;

    std::int64_t bytes() const { return static_cast<std::int64_t>(values_.size() * 2); }

  private:
    std::vector<std::uint16_t> values_;
};

}  // namespace spectralpack
