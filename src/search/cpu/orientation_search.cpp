#include "search/cpu/orientation_search.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <vector>

#include "search/cpu/block_bits.hpp"
#include "search/cpu/layer_limits.hpp"
#include "search/cpu/patience.hpp"
#include "search/cpu/stretches.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/orientation_search.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "search/cpu/kernels-inl.h"
#include "search/cpu/settler-inl.h"
#include "search/cpu/sifter-inl.h"
#include "search/cpu/stretch_sums-inl.h"

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
          sifter_(task),
          settler_(task, limits_),
          for_now_(state_.keeps() ? nullptr : std::make_unique_for_overwrite<OpenPair[]>(state_.pairs_in_layer())) {}

    void Run(int begin, int end) {
        for (int bz = begin; bz < end; ++bz) {
            limits_.look(bz);
            if (limits_.most() < 0) continue;
            sifted_.clear();
            for (int by = 0; by < state_.bricks().y; ++by) {
                if (by % kCrowdBricksY == 0) sifter_.LookAtCrowd(by / kCrowdBricksY, bz);
                for (int bx = 0; bx < state_.bricks().x; bx += kPair) {
                    limits_.look(bz);
                    if (state_.least_bound(bx, by, bz) <= limits_.reach()) SiftPair(bx, by, bz);
                }
            }
            limits_.look(bz);
            BoundPairs(bz);
            settler_.SettleAll(bz, survivors_);
            if (limits_.steep()) state_.look_for_dead_layers(bz);
        }
    }

  private:
    /// A pair of bricks that the sift left something of.
    struct SiftedPair {
        int bx, by;
        OpenPair* open;
        std::size_t sifted[kPair];       // batches that need not be repeated, made in this search
        std::uint32_t near[kBlocksY];    // blocks that Near() left, by row
        std::uint32_t pooled[kBlocksY];  // of these what BoundPairs() bounded
    };
    /// Blocks side by side that have no bound yet; x and y count blocks of the tray.
    struct UnknownBlocks {
        int x, y;
        std::uint32_t lanes;
        std::uint32_t* bound;  // of the first of them
    };

    /// Which of a pair's row of blocks are near enough to something that rho could stay within the limit, as far as the
    /// whole solid in large cells tells.
    /// Where there are none, `bound` falls to one of all of them.
    std::uint32_t Near(int bx, int block_y, int bz, std::uint32_t blocks, std::uint32_t& bound) {
        if (!near_.asks()) return blocks;
        std::uint32_t rho = kDead;
        const std::uint32_t near = Within(t_.cells, bx, block_y, bz, blocks, rho);
        if (near == 0) bound = std::min(bound, raised(rho, limits_.rise(state_.lowest_layer(bz))));
        near_.learn(near == blocks);
        return near;
    }

    /// Which of a pair's row of blocks have a bound that is not above the limit.
    static std::uint32_t PairAtMost(const std::uint32_t* bound, std::uint32_t limit) {
        return AtMost(bound, limit) | AtMost(bound + kBlocksX, limit) << kBlocksX;
    }
    /// Which have none yet.
    static std::uint32_t Unknown(const std::uint32_t* bound) { return PairAtMost(bound, 0); }

    /// Likewise as far as small cells tell, of blocks that have no bound yet.
    std::uint32_t Close(int bx, int block_y, int bz, std::uint32_t blocks, const std::uint32_t* bound) {
        if (t_.fine_cells.cells.empty() || blocks == 0) return blocks;
        const std::uint32_t unknown = blocks & Unknown(bound);
        if (unknown == 0 || !close_.asks()) return blocks;
        std::uint32_t rho = kDead;
        const std::uint32_t close = Within(t_.fine_cells, bx, block_y, bz, unknown, rho);
        // A sum takes as long however few of its lanes are wanted, so few that are left are no great gain.
        close_.learn(3 * std::popcount(close) > std::popcount(unknown));
        return close | (blocks & ~unknown);
    }

    std::uint32_t Within(const CellPlan& cells, int bx, int block_y, int bz, std::uint32_t blocks,
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

    /// Sifts two bricks side by side.
    void SiftPair(int bx, int by, int bz) {
        const std::uint32_t limit = limits_.reach();
        const bool fresh = state_.is_fresh(bx, by, bz);
        OpenPair* open = fresh ? nullptr : &state_.open_pair(bx, by, bz);
        std::uint32_t near[kBlocksY], room[kBlocksY];
        std::uint32_t any = 0, bound = kDead;  // of all blocks, if none is near
        for (int j = 0; j < kBlocksY; ++j) {
            room[j] = fresh ? sifter_.Room(bx, by, j) : 0;
            near[j] = fresh ? room[j] : PairAtMost(open->bound[j], limit);
            if (near[j] != 0) near[j] = Near(bx, by * kBlocksY + j, bz, near[j], bound);
            any |= near[j];
        }
        if (any == 0) {
            if (!fresh) bound = std::min(bound, LeastAbove(*open, limit));
            state_.set_least_bound(bx, by, bz, std::min(bound, kSumLimit));
            return;
        }
        SiftedPair pair{bx, by, open, {}, {near[0], near[1]}, {}};
        if (fresh) pair.open = Open(bx, by, bz, room, pair.sifted);
        if (pair.open != nullptr) sifted_.push_back(pair);
    }

    /// Bounds the blocks of the pairs that were sifted, of all together two stretches at a time: a pair alone has one
    /// or two that are near and have no bound yet.
    void BoundPairs(int bz) {
        unknown_.clear();
        // By rows of blocks, since those of one lie in few cache lines.
        for (auto first = sifted_.begin(); first != sifted_.end();) {
            const auto last =
                std::find_if(first, sifted_.end(), [&](const SiftedPair& p) { return p.by != first->by; });
            for (int j = 0; j < kBlocksY; ++j) {
                const int y = first->by * kBlocksY + j;
                for (auto pair = first; pair != last; ++pair) {
                    std::uint32_t* bound = pair->open->bound[j];
                    pair->near[j] = Close(pair->bx, y, bz, pair->near[j], bound);
                    if (pair->near[j] == 0) continue;
                    pair->pooled[j] = pair->near[j] & Unknown(bound);
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
                t_.plan.coarse, std::span<const UnknownBlocks>(unknown_),
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
        for (const SiftedPair& pair : sifted_) {
            const auto& bound = pair.open->bound;
            for (int i = 0; i < std::min(kPair, state_.bricks().x - pair.bx); ++i) {
                Survivor survivor{kDead, pair.bx + i, pair.by, pair.open, pair.sifted[i], {}, {}};
                for (int j = 0; j < kBlocksY; ++j) {
                    survivor.near[j] = static_cast<std::uint16_t>(pair.near[j] >> (i * kBlocksX));
                    survivor.pooled[j] = static_cast<std::uint16_t>(pair.pooled[j] >> (i * kBlocksX));
                    if (survivor.near[j] == 0) continue;
                    const std::uint32_t* first = bound[j] + i * kBlocksX;
                    for (std::uint32_t left = survivor.near[j] & AtMost(first, limit); left != 0; left &= left - 1) {
                        survivor.bound = std::min(survivor.bound, first[std::countr_zero(left)]);
                    }
                }
                if (survivor.bound <= limit) survivors_.push_back(survivor);
            }
        }
    }

    /// Opens a fresh pair with what the sift leaves of its blocks that have `room`; null if that is nothing. `sifted`
    /// is how many batches each brick went through.
    OpenPair* Open(int bx, int by, int bz, const std::uint32_t (&room)[kBlocksY], std::size_t (&sifted)[kPair]) {
        alignas(64) BrickWords live[kPair];
        // Where nothing is kept, nothing is wanted of layers that cannot win.
        const int all = state_.layers(bz), layers = state_.keeps() ? all : std::min(all, limits_.layers());
        if (!sifter_.Sift(bx, by, bz, layers, room, live, sifted)) {
            if (layers == all) state_.close(bx, by, bz);
            return nullptr;
        }
        OpenPair& open = state_.keeps() ? state_.open(bx, by, bz) : for_now_[sifted_.size()];
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
    std::vector<SiftedPair> sifted_;
    std::vector<UnknownBlocks> unknown_;
    std::vector<Survivor> survivors_;
    LayerLimits limits_;
    Sifter sifter_;
    Settler settler_;
    std::unique_ptr<OpenPair[]> for_now_;  // those of sifted_, where the state does not keep them
    Patience near_, close_;
};

void SearchLayers(OrientationTask& task, int begin, int end) { Pass(task).Run(begin, end); }

void SearchPosition(OrientationTask& task, const VoxelIndex& position) {
    LayerLimits limits(task);
    Settler(task, limits).SettleOne(position);
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(SearchLayers);
HWY_EXPORT(SearchPosition);

OrientationTask make_task(SearchContext& context, PositionState& state, const OrientationRuns& runs,
                          const OrientationPlan& plan, int index, const OrientedShape& shape, bool for_copy,
                          const Admits& admits) {
    return {.context = context,
            .state = state,
            .solid = runs.solid,
            .plan = plan,
            .cells = runs.cells,
            .fine_cells = runs.fine_cells,
            .index = index,
            .layers = shape.solid.extent().z,
            .for_copy = for_copy,
            .admits = admits ? &admits : nullptr};
}

void search_layers(OrientationTask& task, int begin, int end) { HWY_DYNAMIC_DISPATCH(SearchLayers)(task, begin, end); }

void search_position(OrientationTask& task, const VoxelIndex& position) {
    HWY_DYNAMIC_DISPATCH(SearchPosition)(task, position);
}

std::int64_t proximity_at(const TrayTables& tables, const Runs& solid, const VoxelIndex& q) {
    const DistanceGrid& phi = tables.phi();
    const Extent& n = phi.extent();
    const std::ptrdiff_t steps[3] = {1, phi.stride(), static_cast<std::ptrdiff_t>(phi.stride()) * n.y};
    const int along = solid.axis;
    std::int64_t sum = 0;
    for (const Run& run : solid.runs) {
        VoxelIndex v = q + run.start;
        const int end = std::min(v[along] + run.length, n[along]);
        v[along] = std::max(v[along], 0);
        if (v[along] >= end || !n.contains(v)) continue;
        const std::uint16_t* at = phi.row(v.y, v.z) + v.x;
        for (int i = v[along]; i < end; ++i, at += steps[along]) {
            sum += *at;
        }
    }
    return sum;
}

}  // namespace spectralpack
#endif
