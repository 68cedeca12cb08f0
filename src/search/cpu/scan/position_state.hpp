#pragma once
/// What is known about the positions of a shape's orientations from earlier searches in the same
/// tray, so that further copies only look at what could have changed.
///
/// Positions lie in bricks of 64 x 8 x 4 (a tile for each of 4 layers) and blocks of 4 x 4 x 4.
/// Invariants, as objects are added, and after forget() and reopen() of what came and went:
///   live: a clear bit is a position that collides or is not admitted. A set bit may or may not be free.
///   bound: rho(q) + rise(q) >= bound for every free position q of the block, as of `version`, the rise being that of
///   its layer (layer_limits.hpp); kDead: none of the block is free; kReopened: nothing is known of the block, whatever
///   its live bits say.
/// Forgetting any of this costs time, never the answer.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "search/cpu/scan/patience.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

inline constexpr int kBrickX = 64, kBrickY = 8, kBrickZ = 4;
inline constexpr int kBlocksX = kBrickX / TrayTables::kBlock;  ///< blocks of a brick along x
inline constexpr int kBlocksY = kBrickY / TrayTables::kBlock;
inline constexpr int kPair = 2;  ///< bricks
inline constexpr std::uint32_t kDead = 0xFFFFFFFFu, kReopened = 0xFFFFFFFEu;
/// A brick's 4 tiles of 8 words.
using BrickWords = std::uint64_t[kBrickY * kBrickZ];

/// What is known of a pair: its bricks' live bits, and the bounds of its rows of blocks, from the left brick's first
/// block on.
struct alignas(64) OpenPair {
    BrickWords live[kPair];
    std::uint32_t bound[kBlocksY][kPair * kBlocksX];
};

class PositionState {
  public:
    /// Of no positions.
    PositionState() = default;
    /// `count` candidate positions per axis, of which nothing is known. Not `keeps`: of pairs that are opened nothing
    /// will be kept, and they have no place here.
    PositionState(const Extent& count, bool keeps);
    bool keeps() const { return keeps_; }
    std::size_t pairs_in_layer() const { return place_in(1); }

    const Extent& count() const { return count_; }
    const Extent& bricks() const { return bricks_; }

    /// Bricks are looked at in pairs along x. A pair is fresh until it is first of interest; then it is opened with
    /// what the first look-ups leave of its candidates, or is dead where that is nothing: so what is never looked at
    /// costs nothing, and of most others nothing is written but that they are dead.
    bool is_fresh(int bx, int by, int bz) const { return place_[pair(bx, by, bz)] == kFresh; }
    bool is_dead(int bx, int by, int bz) const { return place_[pair(bx, by, bz)] == kNothing; }
    bool is_open(int bx, int by, int bz) const { return place_[pair(bx, by, bz)] >= 0; }
    /// Of brick bx's pair, which is open.
    OpenPair& open_pair(int bx, int by, int bz) {
        return open_[place_in(bz) + static_cast<std::size_t>(place_[pair(bx, by, bz)])];
    }
    /// The candidates of a brick's lowest layer in its `alive` blocks (bits along x, by row of blocks): a tile. Those
    /// of the others are the same, as far as there are layers.
    void candidates(int bx, int by, const std::uint32_t (&alive)[kBlocksY], std::uint64_t* tile) const;
    /// Layers of positions in brick layer bz.
    int layers(int bz) const { return std::min(kBrickZ, count_.z - kBrickZ * bz); }
    /// Of a fresh pair, where keeps(); it is to be set. Pairs of different brick layers may be opened by different
    /// threads at once.
    OpenPair& open(int bx, int by, int bz);
    /// Nothing of a fresh pair is live. Likewise.
    void close(int bx, int by, int bz) { close(pair(bx, by, bz)); }

    /// A bound of all the blocks of a pair, open or fresh; kDead where nothing is live. All of these are small, so that
    /// a search passes over the pairs of which nothing is wanted without reading what is known of each.
    std::uint32_t least_bound(int bx, int by, int bz) const { return least_[pair(bx, by, bz)]; }
    void set_least_bound(int bx, int by, int bz, std::uint32_t least) { least_[pair(bx, by, bz)] = least; }

    /// All positions but those in one of these boxes are blocked, or not admitted: what is fresh of them dies.
    void leave_only(const std::vector<VoxelBox>& positions);
    /// Objects are gone from all that the shape at positions of other blocks than `blocks` could meet: nothing is known
    /// of these any more. What bounds say of the others holds, since phi only rose. Nor is anything known of pairs with
    /// positions that were not admitted, which may be now. False: nothing is known of any position.
    bool reopen(const BitGrid& blocks);
    /// True where blocks of an open pair are reopened.
    bool is_reopened(int bx, int by, int bz) const { return keeps_ && (marks_[pair(bx, by, bz)] & kHasReopened) != 0; }
    /// Which blocks of a row are (bits along x).
    std::uint32_t reopened(int bx, int by, int bz, int row);
    /// None are any more.
    void note_looked_at(int bx, int by, int bz) {
        marks_[pair(bx, by, bz)] &= static_cast<std::uint8_t>(~kHasReopened);
    }
    /// A position was not admitted. Those of different brick layers may be noted by different threads at once.
    void note_refused(const VoxelIndex& q) {
        if (keeps_) marks_[pair(q.x / kBrickX, q.y / kBrickY, q.z / kBrickZ)] |= kHasRefused;
    }
    bool all_dead() const;

    /// Layers (bit i: the i-th) of brick layer bz in which nothing is live any more, as far as anybody looked.
    std::uint8_t dead_layers(int bz) const { return dead_layers_[static_cast<std::size_t>(bz)]; }
    /// The lowest of the others, counted likewise; kBrickZ where there is none.
    int lowest_layer(int bz) const { return std::countr_one(dead_layers(bz)); }
    /// Looks, less often where it was in vain.
    void look_for_dead_layers(int bz);

    /// phi may have fallen where the shape reaches from `blocks`: what these, and their pairs, are bounded by becomes
    /// 0.
    void forget(const BitGrid& blocks);

    /// Bytes that one takes at most: pages that nothing is written to are counted too.
    static std::int64_t bytes_for(const Extent& count, bool keeps);

  private:
    /// Where brick layer bz's open pairs begin.
    std::size_t place_in(int bz) const {
        return static_cast<std::size_t>(bz) * static_cast<std::size_t>(bricks_.y) * static_cast<std::size_t>(pairs_);
    }
    std::size_t pair(int bx, int by, int bz) const {
        return place_in(bz) + static_cast<std::size_t>(by) * static_cast<std::size_t>(pairs_) +
               static_cast<std::size_t>(bx / kPair);
    }

    /// Calls visit(pair, brick layer, which blocks of each row) for the pairs that hold any of `blocks`.
    template <class Visit>
    void for_each_pair_of(const BitGrid& blocks, const Visit& visit) const;
    /// The blocks of a row of a pair in which there are positions.
    std::uint32_t blocks_in(std::size_t pair, int row) const;
    void reopen(std::size_t pair, int bz, const std::uint32_t (&blocks)[kBlocksY]);
    void make_fresh(std::size_t pair, int bz);
    OpenPair& open_at(std::size_t pair, int bz);
    void close(std::size_t pair) {
        place_[pair] = kNothing;
        least_[pair] = kDead;
    }

    static constexpr std::uint8_t kHasRefused = 1, kHasReopened = 2;
    static constexpr std::int32_t kFresh = -1, kNothing = -2, kNoSlot = -1;

    Extent count_, bricks_;
    int pairs_ = 0;  // along x
    bool keeps_ = true;
    bool left_only_ = false;  // some were closed by leave_only() and may be admitted once objects go
    // Pairs lie in the order in which they were opened, one brick layer's after the other's: what never is takes no
    // memory from the system and no place in caches.
    std::unique_ptr<OpenPair[]> open_;
    std::vector<std::int32_t> place_;        // of each pair, which one of its layer's open ones it is; kFresh, kNothing
    std::vector<std::int32_t> slot_;         // likewise, which one it is once it is open, or was before it was reopened
    std::vector<std::uint32_t> least_;       // likewise, least_bound()
    std::vector<std::uint8_t> marks_;        // likewise
    std::vector<std::int32_t> opened_;       // by brick layer
    std::vector<std::uint8_t> dead_layers_;  // likewise
    std::vector<Patience> looks_;            // for dead layers, likewise
};

}  // namespace spectralpack
