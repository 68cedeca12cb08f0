#pragma once
/// Where a piece of a solid meets something wherever in a block of 4^3 positions it stands: one look-up then rules out
/// 64 x 8 blocks, as many positions as 64 look-ups into the bit tables. In a crowd, where next to nothing is free, that
/// rules out nearly all.
///
/// Invariant, for each table T of the bit tables that it holds, whose voxels (margin included) begin at 0:
///   bit Q of the crowd table = AND over i in [0, 7)^3 of T(4 Q + i), T = 1 beyond its end, where no piece of a
///   candidate lies.
/// Seven, because a piece at displacement 4 D + r of the positions 4 B + [0, 4)^3 lies at 4 (B + D) + r + [0, 4)^3.
///
/// Words hold 64 blocks along x; they lie in the order y, x, z with y fastest, as in the bit tables.

#include <cstdint>
#include <limits>
#include <vector>

#include "core/parallel.hpp"
#include "search/cpu/tables/bit_tables.hpp"

namespace spectralpack {

class CrowdTables {
  public:
    static constexpr int kBlock = 4;
    static constexpr int kTileX = 64, kTileY = 8;  ///< blocks
    /// Only of forms that are large enough to meet something nearly everywhere in a crowd; and with s > 1 not of the
    /// fine layers, since eight or more tables for each form take longer to keep right than they save.
    bool holds(int layer, const Form& form) const { return layer >= first_layer_ && form.voxels() >= 8; }

    CrowdTables() = default;  ///< that hold nothing
    /// For these bit tables, all empty.
    explicit CrowdTables(const BitTables& bits);

    /// Makes the tables of a layer right after bits.refresh() of it.
    void refresh(const BitTables& bits, int layer, const VoxelBox& changed, const Workers& workers);

    bool operator==(const CrowdTables& other) const { return words_ == other.words_; }

    /// Words to the neighbouring tile along x.
    std::ptrdiff_t next() const { return static_cast<std::ptrdiff_t>(column_); }
    /// The tile of blocks (64 i .. 64 i + 63, 8 j .. 8 j + 7, k); displacements are added to it as offsets.
    const std::uint64_t* tile(int i, int j, int k) const {
        return words_.data() + (k * static_cast<std::int64_t>(columns_) + i) * column_ + kTileY * j;
    }
    /// Where what lies at that spot of the bit tables, in a table that is held, lies from a tile.
    BitTables::Place place(const BitTables::Spot& spot) const;

    std::int64_t bytes() const { return static_cast<std::int64_t>(words_.size() * sizeof(std::uint64_t)); }

  private:
    void refresh_table(const BitTables& bits, int table, const VoxelBox& changed);

    Extent voxels_;  // of a bit table
    int first_layer_ = std::numeric_limits<int>::max(), first_table_ = 0;
    int columns_ = 0;          // words along x, one of them a zero at the end
    std::int64_t column_ = 0;  // words along y
    std::int64_t table_ = 0;
    std::vector<std::uint64_t> words_;
};

}  // namespace spectralpack
