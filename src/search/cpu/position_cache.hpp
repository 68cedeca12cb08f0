#pragma once
/// What is known about the positions of a shape's orientations from earlier searches in the same
/// tray, so that further copies only look at what could have changed.
///
/// Positions lie in bricks of 64 x 8 x 4 (a tile for each of 4 layers) and blocks of 4 x 4 x 4.
/// Invariants, as long as objects are only added:
///   live: a clear bit is a position that collides or is not admitted. A set bit may or may not be free.
///   bound: rho(q) >= bound for every free position q of the block, as of `version`; kDead: none is
///   free, for good.
/// Forgetting any of this costs time, never the answer.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "search/cpu/plan.hpp"
#include "search/cpu/tray_tables.hpp"
#include "search/shape.hpp"

namespace spectralpack {

inline constexpr int kBrickX = 64, kBrickY = 8, kBrickZ = 4;
inline constexpr int kBlocksX = kBrickX / TrayTables::kBlock;  ///< blocks of a brick along x
inline constexpr int kBlocksY = kBrickY / TrayTables::kBlock;
inline constexpr int kPair = 2;  ///< bricks
inline constexpr std::uint32_t kDead = 0xFFFFFFFFu;
/// A brick's 4 tiles of 8 words.
using BrickWords = std::uint64_t[kBrickY * kBrickZ];

class PositionState {
  public:
    /// `count` candidate positions per axis, of at most `most`, for which room is made so that it serves any shape in
    /// the same tray. Nothing is known.
    void reset(const Extent& count, const Extent& most);

    const Extent& count() const { return count_; }
    const Extent& bricks() const { return bricks_; }

    /// The brick's 4 tiles of 8 words.
    std::uint64_t* live(int bx, int by, int bz) { return live_.get() + brick(bx, by, bz) * (kBrickY * kBrickZ); }
    /// The bounds of row `block_y` of blocks in brick layer bz, from brick bx on.
    std::uint32_t* bound(int bx, int block_y, int bz) {
        return bound_.get() +
               (static_cast<std::size_t>(bz) * static_cast<std::size_t>(bound_rows_) +
                static_cast<std::size_t>(block_y)) *
                   static_cast<std::size_t>(bound_stride_) +
               static_cast<std::size_t>(bx * kBlocksX);
    }
    /// Bricks are looked at in pairs along x. A pair is fresh until it is first of interest; then it is opened with
    /// what the first look-ups leave of its candidates, or is dead where that is nothing: so what is never looked at
    /// costs nothing, and of most others nothing is written but that they are dead.
    bool is_fresh(int bx, int by, int bz) const { return pair_is_[pair(bx, by, bz)] == kFresh; }
    bool is_dead(int bx, int by, int bz) const { return pair_is_[pair(bx, by, bz)] == kNothing; }
    /// The candidates of a brick's lowest layer in its `alive` blocks (bits along x, by row of blocks): a tile. Those
    /// of the others are the same, as far as there are layers.
    void candidates(int bx, int by, const std::uint32_t (&alive)[kBlocksY], std::uint64_t* tile) const;
    /// Layers of positions in brick layer bz.
    int layers(int bz) const { return std::min(kBrickZ, count_.z - kBrickZ * bz); }
    /// Of a fresh pair `words` are live, and the bounds of their blocks are 0. True if there are any. Pairs of
    /// different brick layers may be opened by different threads at once.
    bool open(int bx, int by, int bz, const BrickWords (&words)[kPair]);
    /// Nothing of a fresh pair is live. Likewise.
    void close(int bx, int by, int bz) { pair_is_[pair(bx, by, bz)] = kNothing; }

    /// All positions but those in one of these boxes are blocked, for good: what is fresh of them dies.
    void leave_only(const std::vector<VoxelBox>& positions);
    bool all_dead() const;

    /// phi fell within `changed`: bounds of blocks from which a shape of `extent` reaches into it
    /// become 0.
    void forget(const VoxelBox& changed, const Extent& extent);

    static std::int64_t bytes_for(const Extent& count);

  private:
    std::size_t brick(int bx, int by, int bz) const {
        return (static_cast<std::size_t>(bz) * static_cast<std::size_t>(bricks_.y) + static_cast<std::size_t>(by)) *
                   static_cast<std::size_t>(bricks_.x) +
               static_cast<std::size_t>(bx);
    }
    std::size_t pair(int bx, int by, int bz) const {
        return (static_cast<std::size_t>(bz) * static_cast<std::size_t>(bricks_.y) + static_cast<std::size_t>(by)) *
                   static_cast<std::size_t>(pairs_) +
               static_cast<std::size_t>(bx / kPair);
    }

    Extent count_, bricks_;
    int pairs_ = 0;  // along x
    int bound_rows_ = 0, bound_stride_ = 0;
    // Written when a pair is opened: what never is takes no memory from the system.
    std::unique_ptr<std::uint64_t[]> live_;
    std::unique_ptr<std::uint32_t[]> bound_;
    std::size_t room_for_bricks_ = 0, room_for_bounds_ = 0;
    enum PairIs : std::uint8_t { kFresh, kOpen, kNothing };
    std::vector<PairIs> pair_is_;
};

/// States by shape, within a budget; what was least useful for its size goes first.
class PositionCache {
  public:
    explicit PositionCache(std::int64_t budget) : budget_(budget) {}

    struct Entry {
        std::vector<PositionState> states;   ///< by orientation of the shape
        std::vector<OrientationRuns> runs;   ///< likewise; made when first needed
        std::vector<OrientationPlan> plans;  ///< likewise
        int planned_classes = 0;             ///< that had objects then
        bool planned_narrow = false;         ///< for sums in bytes
        std::uint64_t version = 0;           ///< of the tables the bounds belong to
        std::int64_t state_bytes = 0, bytes = 0;
        std::int64_t hits = 0;
        std::uint64_t last_use = 0;
    };

    /// The shape's entry, brought up to the tables' version; a fresh one where there is none. Stays
    /// until the next call.
    Entry& at(const Shape& shape, const Tray& tray, const TrayTables& tables);

    /// Counts the runs and plans that were made for an entry. It may be over the budget until the next call of at().
    void count(Entry& entry);

    std::int64_t bytes() const { return bytes_; }

  private:
    void make_room(std::int64_t bytes);
    void forget_all();

    std::int64_t budget_;
    std::int64_t bytes_ = 0;
    std::uint64_t epoch_ = 0, uses_ = 0;
    std::unordered_map<std::uint64_t, Entry> entries_;
    std::vector<PositionState> spare_;  // of entries that went: their memory is used again
};

}  // namespace spectralpack
