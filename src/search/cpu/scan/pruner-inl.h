/// The look-ups that come first, for whole brick layers: crowd tables, stacks, single positions
/// (docs/algorithm/fast-engine.md, step 7); for each instruction set, as scan_kernels-inl.h.

#if defined(SPECTRALPACK_CPU_PRUNER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPECTRALPACK_CPU_PRUNER_INL_H
#undef SPECTRALPACK_CPU_PRUNER_INL_H
#else
#define SPECTRALPACK_CPU_PRUNER_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/cpu/scan/orientation_search.hpp"
#include "search/cpu/scan/patience.hpp"
#include "search/cpu/scan/scan_kernels-inl.h"
#include "search/cpu/tuning.hpp"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

// A tile of the crowd tables is that many bricks.
constexpr int kCrowdBricksX = CrowdTables::kTileX / kBlocksX, kCrowdBricksY = CrowdTables::kTileY / kBlocksY;
static_assert(kBrickZ == CrowdTables::kBlock && TrayTables::kBlock == CrowdTables::kBlock &&
              kCrowdBricksX % kPair == 0);
static_assert(kBrickZ <= BitTables::kTileLayers);

/// PruneTiles() of one tile, for many callers.
static HWY_NOINLINE void PruneTile(const std::uint64_t* tile, std::ptrdiff_t next, const LookupList& list,
                                   std::size_t begin, std::size_t end, std::uint64_t* words) {
    PruneTiles<1>(tile, next, 0, list, begin, end, words);
}

/// One thread's look-ups of whole pairs of bricks of one orientation.
class Pruner {
  public:
    explicit Pruner(const OrientationTask& task) : t_(task), tables_(task.context.tables), state_(task.state) {}

    /// Which blocks of the crowd tables' tiles in row j have room for anything at all, as far as pairs there are fresh.
    void LookAtCrowd(int j, int bz) {
        const int tiles = (state_.bricks().x + kCrowdBricksX - 1) / kCrowdBricksX;
        uncrowded_.assign(static_cast<std::size_t>(tiles * kTileRows), ~std::uint64_t{0});
        if (t_.lists.lookups.of_blocks.batches.empty()) return;
        for (int i = 0; i < tiles; ++i) {
            if (AnyFresh(i, j, bz)) PruneBlocks(i, j, bz, uncrowded_.data() + i * kTileRows);
        }
    }

    /// Of a fresh pair, what LookAtCrowd() left of a row of blocks.
    std::uint32_t Uncrowded(int bx, int by, int row) const {
        const std::size_t tile = static_cast<std::size_t>(bx / kCrowdBricksX * kTileRows);
        const std::size_t word = static_cast<std::size_t>(by % kCrowdBricksY * kBlocksY + row);
        return static_cast<std::uint32_t>(uncrowded_[tile + word] >> (bx % kCrowdBricksX * kBlocksX));
    }

    /// What the first batches of look-ups leave of the lowest `layers` of a fresh pair's blocks that have `uncrowded`;
    /// false if that is nothing. `pruned` is how many batches each brick went through.
    bool Prune(int bx, int by, int bz, int layers, const std::uint32_t (&uncrowded)[kBlocksY],
               BrickWords (&live)[kPair], std::size_t (&pruned)[kPair]) {
        bool left[kPair];
        for (int i = 0; i < kPair; ++i) {
            std::uint32_t alive[kBlocksY];
            for (int j = 0; j < kBlocksY; ++j) {
                alive[j] = uncrowded[j] >> (kBlocksX * i) & 0xFFFFu;
            }
            left[i] = std::ranges::any_of(alive, [](std::uint32_t row) { return row != 0; }) &&
                      bx + i < state_.bricks().x && PruneStacks(bx + i, by, bz, layers, alive, live[i]);
            if (!left[i]) continue;
            pruned[i] = PruneLayers(bx + i, by, bz, layers, live[i]);
            left[i] = std::ranges::any_of(live[i], [](std::uint64_t word) { return word != 0; });
        }
        if (!left[0] && !left[1]) return false;
        for (int i = 0; i < kPair; ++i) {
            if (!left[i]) std::fill_n(live[i], kBrickY * kBrickZ, std::uint64_t{0});
        }
        return true;
    }

  private:
    bool AnyFresh(int i, int j, int bz) const {
        const Extent& bricks = state_.bricks();
        for (int by = kCrowdBricksY * j; by < std::min(kCrowdBricksY * (j + 1), bricks.y); ++by) {
            for (int bx = kCrowdBricksX * i; bx < std::min(kCrowdBricksX * (i + 1), bricks.x); bx += kPair) {
                if (state_.is_fresh(bx, by, bz)) return true;
            }
        }
        return false;
    }

    /// Clears the blocks of a tile of the crowd tables that have no room. Where the first look-ups find no crowd at
    /// all, the others are spared.
    void PruneBlocks(int i, int j, int bz, std::uint64_t* uncrowded) const {
        const CrowdTables& crowd = tables_.crowd();
        const LookupList& list = t_.lists.lookups.of_blocks;
        for (std::size_t b = 0; b < list.batches.size(); ++b) {
            PruneTiles<1>(crowd.tile(i, j, bz), crowd.next(), 0, list, b, b + 1, uncrowded);
            std::uint64_t any = 0, all = ~std::uint64_t{0};
            for (int k = 0; k < kTileRows; ++k) {
                any |= uncrowded[k];
                all &= uncrowded[k];
            }
            if (any == 0 || all == ~std::uint64_t{0}) return;
        }
    }

    /// The candidates of a brick in its `alive` blocks, but for stacks that are found to collide as one. False where
    /// nothing is left.
    bool PruneStacks(int bx, int by, int bz, int layers, const std::uint32_t (&alive)[kBlocksY], std::uint64_t* live) {
        state_.candidates(bx, by, alive, live);
        const BitTables& bits = tables_.bits();
        const LookupList& list = t_.lists.lookups.of_stacks;
        const bool asks = !list.batches.empty() && stacks_.asks();
        if (asks) {
            PruneTiles<1>(bits.tile(bx, kBrickY * by, kBrickZ * bz), bits.next(), bits.up(), list, 0,
                          list.batches.size(), live);
        }
        const bool any = std::any_of(live, live + kBrickY, [](std::uint64_t word) { return word != 0; });
        if (asks) stacks_.learn(any);
        if (!any) return false;
        for (int z = 1; z < kBrickZ; ++z) {
            if (z < layers) {
                std::copy_n(live, kBrickY, live + kBrickY * z);
            } else {
                std::fill_n(live + kBrickY * z, kBrickY, std::uint64_t{0});
            }
        }
        return true;
    }

    /// The first batches for a brick's layers; the very first of them for all at once, since it leaves out none.
    /// Returns how many batches all that is left went through.
    std::size_t PruneLayers(int bx, int by, int bz, int layers, std::uint64_t* live) const {
        const BitTables& bits = tables_.bits();
        const LookupList& list = t_.lists.lookups.of_positions;
        const std::size_t all = std::min(t_.lists.lookups.pruning, list.batches.size());
        const std::size_t first = std::min(tuning::kBatchesForAllLayers, all);
        const std::size_t some = std::min(tuning::kLeastPruning, all);
        std::uint64_t before[kBrickY];  // of any layer that has candidates
        std::copy_n(live, kBrickY, before);
        const std::uint64_t* lowest = bits.tile(bx, kBrickY * by, kBrickZ * bz);
        PruneTiles<kBrickZ>(lowest, bits.next(), bits.up(), list, 0, first, live);
        std::size_t least = all;
        for (int i = 0; i < layers; ++i) {
            std::uint64_t* tile = live + kBrickY * i;
            const std::uint64_t* at = lowest + i * bits.up();
            PruneTile(at, bits.next(), list, first, some, tile);
            if (some == all) continue;
            if (std::equal(tile, tile + kBrickY, before)) {
                least = some;  // in the open, where most of it would be in vain
            } else {
                PruneTile(at, bits.next(), list, some, all, tile);
            }
        }
        return least;
    }

    const OrientationTask& t_;
    const TrayTables& tables_;
    const PositionState& state_;
    std::vector<std::uint64_t> uncrowded_;  // by tile of the crowd tables in a row
    Patience stacks_{tuning::kPatienceWithStacks};
};

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#endif
