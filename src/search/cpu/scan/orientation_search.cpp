#include "search/cpu/scan/orientation_search.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <vector>

#include "search/cpu/scan/layer_limits.hpp"
#include "search/cpu/scan/patience.hpp"
#include "search/cpu/scan/stretches.hpp"
#include "search/cpu/tables/block_bits.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/scan/orientation_search.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "search/cpu/scan/evaluator-inl.h"
#include "search/cpu/scan/pruner-inl.h"
#include "search/cpu/scan/scan_kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

// Bricks are looked at in pairs, whose blocks are what cells are asked for at once; a brick's are a stretch.
static_assert(kPair * kBlocksX == kLanes && kBlocksX == kStretch);

/// One thread's work on some brick layers of one orientation.
class Pass {
  public:
    explicit Pass(OrientationTask& task)
        : t_(task),
          context_(task.context),
          state_(task.state),
          limits_(task),
          pruner_(task),
          evaluator_(task, limits_),
          for_now_(state_.keeps() ? nullptr : std::make_unique_for_overwrite<OpenPair[]>(state_.pairs_in_layer())) {}

    void Run(int begin, int end) {
        for (int bz = begin; bz < end; ++bz) {
            limits_.look(bz);
            if (limits_.most() < 0) continue;
            pruned_.clear();
            for (int by = 0; by < state_.bricks().y; ++by) {
                if (by % kCrowdBricksY == 0) pruner_.LookAtCrowd(by / kCrowdBricksY, bz);
                for (int bx = 0; bx < state_.bricks().x; bx += kPair) {
                    limits_.look(bz);
                    if (state_.least_bound(bx, by, bz) <= limits_.reach()) PrunePair(bx, by, bz);
                }
            }
            limits_.look(bz);
            BoundPairs(bz);
            evaluator_.EvaluateAll(bz, survivors_);
            if (limits_.steep()) state_.look_for_dead_layers(bz);
        }
    }

  private:
    /// A pair of bricks that pruning left something of.
    struct PrunedPair {
        int bx, by;
        OpenPair* open;
        std::size_t pruned[kPair];       // batches that need not be repeated, made in this search
        std::uint32_t within[kBlocksY];  // blocks that WithinByLargeCells() left, by row
        std::uint32_t pooled[kBlocksY];  // of these what BoundPairs() bounded
    };
    /// Blocks side by side that have no bound yet; x and y count blocks of the tray.
    struct UnknownBlocks {
        int x, y;
        std::uint32_t lanes;
        std::uint32_t* bound;  // of the first of them
    };

    /// In which of a pair's row of blocks rho could stay within the limit, as far as the whole solid in large cells
    /// tells: what is near enough to something. Where that is none, `bound` falls to one of all of them.
    std::uint32_t WithinByLargeCells(int bx, int block_y, int bz, std::uint32_t blocks, std::uint32_t& bound) {
        if (!ask_large_cells_.asks()) return blocks;
        std::uint32_t rho = kDead;
        const std::uint32_t within = AskCells(t_.runs.cells, bx, block_y, bz, blocks, rho);
        if (within == 0) bound = std::min(bound, raised(rho, limits_.rise(state_.lowest_layer(bz))));
        ask_large_cells_.learn(within == blocks);
        return within;
    }

    /// Which of a pair's row of blocks have a bound that is not above the limit.
    static std::uint32_t PairAtMost(const std::uint32_t* bound, std::uint32_t limit) {
        return AtMost(bound, limit) | AtMost(bound + kBlocksX, limit) << kBlocksX;
    }
    /// Which have none yet.
    static std::uint32_t Unknown(const std::uint32_t* bound) { return PairAtMost(bound, 0); }

    /// Likewise as far as small cells tell of blocks that have no bound yet.
    std::uint32_t WithinBySmallCells(int bx, int block_y, int bz, std::uint32_t blocks, const std::uint32_t* bound) {
        if (t_.runs.small_cells.cells.empty() || blocks == 0) return blocks;
        const std::uint32_t unknown = blocks & Unknown(bound);
        if (unknown == 0 || !ask_small_cells_.asks()) return blocks;
        std::uint32_t rho = kDead;
        const std::uint32_t within = AskCells(t_.runs.small_cells, bx, block_y, bz, unknown, rho);
        // A sum takes as long however few of its lanes are wanted, so few that are left are no great gain.
        ask_small_cells_.learn(3 * std::popcount(within) > std::popcount(unknown));
        return within | (blocks & ~unknown);
    }

    std::uint32_t AskCells(const CellList& cells, int bx, int block_y, int bz, std::uint32_t blocks,
                           std::uint32_t& rho) const {
        return WithinLimit(context_.tables.minima().at({bx * kBlocksX, block_y, bz}), cells, lane_limit(limits_.most()),
                           limits_.stop_above(limits_.most()), blocks, rho);
    }

    /// The least of a pair's bounds that are above the limit.
    static std::uint32_t LeastAbove(const OpenPair& open, std::uint32_t limit) {
        std::uint32_t least = kDead;
        for (const auto& row : open.bound) {
            for (const std::uint32_t bound : row) {
                if (bound > limit) least = std::min(least, bound);
            }
        }
        return least;
    }

    /// Prunes two bricks side by side.
    void PrunePair(int bx, int by, int bz) {
        const std::uint32_t limit = limits_.reach();
        const bool fresh = state_.is_fresh(bx, by, bz);
        OpenPair* open = fresh ? nullptr : &state_.open_pair(bx, by, bz);
        if (!fresh && state_.is_reopened(bx, by, bz)) LookAtReopened(bx, by, bz, *open);
        std::uint32_t within[kBlocksY], uncrowded[kBlocksY];
        std::uint32_t any = 0, bound = kDead;  // of all blocks, if none is within the limit
        for (int j = 0; j < kBlocksY; ++j) {
            uncrowded[j] = fresh ? pruner_.Uncrowded(bx, by, j) : 0;
            within[j] = fresh ? uncrowded[j] : PairAtMost(open->bound[j], limit);
            if (within[j] != 0) within[j] = WithinByLargeCells(bx, by * kBlocksY + j, bz, within[j], bound);
            any |= within[j];
        }
        if (any == 0) {
            if (!fresh) bound = std::min(bound, LeastAbove(*open, limit));
            state_.set_least_bound(bx, by, bz, std::min(bound, kSumLimit));
            return;
        }
        PrunedPair pair{bx, by, open, {}, {within[0], within[1]}, {}};
        if (fresh) pair.open = Open(bx, by, bz, uncrowded, pair.pruned);
        if (pair.open != nullptr) pruned_.push_back(pair);
    }

    /// Bounds the blocks of the pairs that were pruned, of all together two stretches at a time: a pair alone has one
    /// or two that are within the limit and have no bound yet.
    void BoundPairs(int bz) {
        unknown_.clear();
        // By rows of blocks, since those of one lie in few cache lines.
        for (auto first = pruned_.begin(); first != pruned_.end();) {
            const auto last =
                std::find_if(first, pruned_.end(), [&](const PrunedPair& p) { return p.by != first->by; });
            for (int j = 0; j < kBlocksY; ++j) {
                const int y = first->by * kBlocksY + j;
                for (auto pair = first; pair != last; ++pair) {
                    std::uint32_t* bound = pair->open->bound[j];
                    pair->within[j] = WithinBySmallCells(pair->bx, y, bz, pair->within[j], bound);
                    if (pair->within[j] == 0) continue;
                    pair->pooled[j] = pair->within[j] & Unknown(bound);
                    for_each_stretch(pair->pooled[j], [&](int x, std::uint32_t lanes) {
                        unknown_.push_back({pair->bx * kBlocksX + x, y, lanes, bound + x});
                    });
                }
            }
            first = last;
        }
        const int lowest = kBrickZ * bz + state_.lowest_layer(bz);
        const std::uint32_t rise = limits_.rise(state_.lowest_layer(bz));
        context_.tables.visit_sums([&](const auto& tables) {
            SumUp<true>(
                t_.lists.coarse, std::span<const UnknownBlocks>(unknown_),
                [&](const UnknownBlocks& blocks) { return tables.coarse.base(blocks.x, kBlock * blocks.y, lowest); },
                limits_.stop_above(limits_.most()),
                [&](const UnknownBlocks& blocks, const std::uint32_t* sums) {
                    for (std::uint32_t left = blocks.lanes; left != 0; left &= left - 1) {
                        const int i = std::countr_zero(left);
                        blocks.bound[i] = raised(sums[i], rise);
                    }
                });
        });
        const std::uint32_t limit = limits_.reach();
        survivors_.clear();
        for (const PrunedPair& pair : pruned_) {
            const auto& bound = pair.open->bound;
            for (int i = 0; i < std::min(kPair, state_.bricks().x - pair.bx); ++i) {
                Survivor survivor{kDead, pair.bx + i, pair.by, pair.open, pair.pruned[i], {}, {}};
                for (int j = 0; j < kBlocksY; ++j) {
                    survivor.within[j] = static_cast<std::uint16_t>(pair.within[j] >> (i * kBlocksX));
                    survivor.pooled[j] = static_cast<std::uint16_t>(pair.pooled[j] >> (i * kBlocksX));
                    if (survivor.within[j] == 0) continue;
                    const std::uint32_t* first = bound[j] + i * kBlocksX;
                    for (std::uint32_t left = survivor.within[j] & AtMost(first, limit); left != 0; left &= left - 1) {
                        survivor.bound = std::min(survivor.bound, first[std::countr_zero(left)]);
                    }
                }
                if (survivor.bound <= limit) survivors_.push_back(survivor);
            }
        }
    }

    /// Finds out anew what look-ups leave of an open pair's reopened blocks.
    void LookAtReopened(int bx, int by, int bz, OpenPair& open) {
        std::uint32_t blocks[kBlocksY];
        for (int j = 0; j < kBlocksY; ++j) {
            blocks[j] = state_.reopened(bx, by, bz, j);
        }
        alignas(64) BrickWords live[kPair];
        std::size_t pruned[kPair];
        const bool any = pruner_.Prune(bx, by, bz, state_.layers(bz), blocks, live, pruned);
        for (int i = 0; i < kPair; ++i) {
            for (int j = 0; j < kBlocksY; ++j) {
                const std::uint32_t here = blocks[j] >> (kBlocksX * i) & 0xFFFFu;
                if (here == 0) continue;
                const std::uint64_t positions = widened(here);
                std::uint64_t bits = 0;
                for (int z = 0; z < kBrickZ; ++z) {
                    for (int k = kBrickY * z + kBlock * j; k < kBrickY * z + kBlock * (j + 1); ++k) {
                        open.live[i][k] = (open.live[i][k] & ~positions) | (any ? live[i][k] & positions : 0);
                        bits |= open.live[i][k];
                    }
                }
                const std::uint32_t left = every_fourth(any_of_block(bits));
                std::uint32_t* bound = open.bound[j] + i * kBlocksX;
                for (std::uint32_t k = here; k != 0; k &= k - 1) {
                    const int x = std::countr_zero(k);
                    bound[x] = left >> x & 1 ? 0 : kDead;
                }
            }
        }
        state_.note_looked_at(bx, by, bz);
    }

    /// Opens a fresh pair with what look-ups leave of its blocks that have `uncrowded`; null if that is nothing.
    /// `pruned` is how many batches each brick went through.
    OpenPair* Open(int bx, int by, int bz, const std::uint32_t (&uncrowded)[kBlocksY], std::size_t (&pruned)[kPair]) {
        alignas(64) BrickWords live[kPair];
        // Where nothing is kept, nothing is wanted of layers that cannot win.
        const int all = state_.layers(bz), layers = state_.keeps() ? all : std::min(all, limits_.layers());
        if (!pruner_.Prune(bx, by, bz, layers, uncrowded, live, pruned)) {
            if (layers == all) state_.close(bx, by, bz);
            return nullptr;
        }
        OpenPair& open = state_.keeps() ? state_.open(bx, by, bz) : for_now_[pruned_.size()];
        SetLive(live, open);
        return &open;
    }

    /// `words` are live, and the bounds of their blocks are 0.
    static void SetLive(const BrickWords (&words)[kPair], OpenPair& open) {
        for (int i = 0; i < kPair; ++i) {
            std::copy_n(words[i], kBrickY * kBrickZ, open.live[i]);
            for (int j = 0; j < kBlocksY; ++j) {
                std::uint64_t bits = 0;
                for (int z = 0; z < kBrickZ; ++z) {
                    for (int y = kBlock * j; y < kBlock * (j + 1); ++y) {
                        bits |= words[i][kBrickY * z + y];
                    }
                }
                const std::uint32_t left = every_fourth(any_of_block(bits));
                std::uint32_t* bound = open.bound[j] + i * kBlocksX;
                for (std::uint32_t k = 0; k < kBlocksX; ++k) {
                    bound[k] = left >> k & 1 ? 0 : kDead;
                }
            }
        }
    }

    OrientationTask& t_;
    SearchContext& context_;
    PositionState& state_;
    std::vector<PrunedPair> pruned_;
    std::vector<UnknownBlocks> unknown_;
    std::vector<Survivor> survivors_;
    LayerLimits limits_;
    Pruner pruner_;
    Evaluator evaluator_;
    std::unique_ptr<OpenPair[]> for_now_;  // those of pruned_, where the state does not keep them
    Patience ask_large_cells_, ask_small_cells_;
};

void SearchLayers(OrientationTask& task, int begin, int end) { Pass(task).Run(begin, end); }

void SearchPosition(OrientationTask& task, const VoxelIndex& position) {
    LayerLimits limits(task);
    Evaluator(task, limits).EvaluateOne(position);
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(SearchLayers);
HWY_EXPORT(SearchPosition);

void search_layers(OrientationTask& task, int begin, int end) { HWY_DYNAMIC_DISPATCH(SearchLayers)(task, begin, end); }

void search_position(OrientationTask& task, const VoxelIndex& position) {
    HWY_DYNAMIC_DISPATCH(SearchPosition)(task, position);
}

}  // namespace spectralpack
#endif
