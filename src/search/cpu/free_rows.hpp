#pragma once
/// Free positions of a shape among the objects of Omega_move, some words of bits at a time (for flood
/// fill and re-insertion, paper sections 4.1 and 4.3).

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/cpu/dilated_rows.hpp"
#include "search/cpu/runs.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

/// A run of 2^k voxels or more, up to twice as many, is two look-ups in the tray's rows dilated by 2^k. They are made in
/// an order that spreads over the solid and end as soon as all 64 positions of a word are known to collide: in a full
/// tray most words take a few of them.
class FreeRows final : public FreeRowReader {
  public:
    /// Positions origin + (x, y, z) with 0 <= (x, y, z) < extent of the returned rows; origin = -(a
    /// - 1) - padding per axis, extent = n + a - 1 + 2 padding. `tray` stays as it is, and `rows` follows it. O(runs of
    /// `solid`) to build, and for query.without O(its box).
    FreeRows(const Tray& tray, std::shared_ptr<DilatedRows> rows, const FreeQuery& query, const BitGrid& solid);

    const VoxelIndex& origin() const override { return origin_; }
    const Extent& extent() const override { return extent_; }

    /// O(runs x count) at most.
    void words(int y, int z, int first, int count, std::uint64_t* free) override;
    /// O(runs) at most; less where all that is wanted collides.
    Told tell(int y, int z, int word, std::uint64_t wanted) override;

  private:
    struct Look {
        int y, z;        // of the row, from the position's
        int level;       // of the table
        int begin, end;  // bits of it, from the position's x: 64 positions from there on
    };

    std::vector<Look> looks_for(const BitGrid& voxels) const;
    const BitGrid::Word* row(int y, int z);

    const Tray& tray_;
    std::shared_ptr<DilatedRows> rows_;
    VoxelIndex origin_;
    Extent extent_;
    std::vector<Look> looks_;
    VoxelBox around_;     // of the object that is out; empty where none is
    BitGrid without_it_;  // Omega_move in the rows of that box
    std::vector<std::vector<BitGrid::Word>> own_;  // tables of those rows; empty: not yet made
};

}  // namespace spectralpack
