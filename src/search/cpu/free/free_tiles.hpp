#pragma once
/// Free positions of a shape among the objects of Omega_move, tiles of bits at a time (for flood
/// fill and re-insertion, paper sections 4.1 and 4.3).

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "search/cpu/free/dilated_layers.hpp"
#include "search/cpu/shapes/runs.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

/// 64 positions side by side, in the tables of a row: what a run of the shape meets, or a part of it.
struct TileLook {
    std::uint16_t y = 0;                ///< of the row, from the group's
    std::uint8_t level = 0, shift = 0;  ///< of the table; of the first bit in its word
};

/// Looks into the same word of rows of a layer, by y.
struct TileLookGroup {
    int word = 0, y = 0, z = 0;      ///< from the tile's word, the position's row and layer
    std::size_t begin = 0, end = 0;  ///< into the looks
};

/// Of a shape: some looks that are spread over it, each a group, which decide most tiles, and the others in the order
/// of memory.
struct TileLooks {
    std::vector<TileLook> looks;
    std::vector<TileLookGroup> spread, others;
};

/// A look at a layer: the tray's rows, but for what an object which is out has something in.
struct TileLayer {
    const DilatedRows* all = nullptr;
    const DilatedRows* without = nullptr;
    /// In rows begin .. end - 1 `without` is to be asked for words from .. to - 1; it knows the rows around, and word
    /// `to`, as well.
    int begin = std::numeric_limits<int>::max(), end = 0;
    int from = 0, to = 0;
};

/// A run of 2^k voxels or more, up to twice as many, is two look-ups in the tray's layers dilated by 2^k, for eight
/// rows of positions at once. They end as soon as all that is wanted is known to collide: in a full tray most tiles
/// take a few of them. A walk that asks about one position of a tile soon asks about most of its rows.
class FreeTiles final : public FreeTileReader {
  public:
    /// Positions origin + (x, y, z) with 0 <= (x, y, z) < extent; origin = -(a - 1) - padding per axis, extent
    /// = n + a - 1 + 2 padding. `tray` stays as it is, and `layers` follow it. For query.without O(its box); O(runs of
    /// `solid`) when first asked.
    FreeTiles(const Tray& tray, std::shared_ptr<DilatedLayers> layers, const FreeQuery& query,
              std::shared_ptr<const BitGrid> solid);

    const VoxelIndex& origin() const override { return origin_; }
    const Extent& extent() const override { return extent_; }

    /// O(runs) at most; less where all that is wanted collides.
    Told tell(int i, int j, int z, const Rows& wanted) override;

  private:
    struct Without {
        std::unique_ptr<DilatedRows::Word[]> words;  // null: not yet made
        DilatedRows rows;
    };

    TileLooks looks_for(const BitGrid& voxels) const;
    void make_layers(int begin, int end);
    void leave_out(TileLayer& layer, int z);

    const Tray& tray_;
    std::shared_ptr<DilatedLayers> shared_;
    VoxelIndex origin_;
    Extent extent_;
    std::shared_ptr<const BitGrid> solid_;
    TileLooks looks_;                // empty: not yet made. Many readers are made of whom few are asked
    std::vector<TileLayer> layers_;  // by z; without `all`: not yet made
    VoxelBox out_;                   // the object that is out, within the tray; empty: none
    VoxelBox read_;                  // what its words hold
    BitGrid voxels_without_;         // Omega_move in that box
    std::vector<Without> without_;   // by z from out_.lo.z on
};

}  // namespace spectralpack
