/// What decides of the positions that pruning leaves: the remaining look-ups, rho (docs/algorithm/fast-engine.md, step
/// 7); for each instruction set, as scan_kernels-inl.h.

#if defined(SPECTRALPACK_CPU_EVALUATOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPECTRALPACK_CPU_EVALUATOR_INL_H
#undef SPECTRALPACK_CPU_EVALUATOR_INL_H
#else
#define SPECTRALPACK_CPU_EVALUATOR_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/cpu/scan/layer_limits.hpp"
#include "search/cpu/scan/orientation_search.hpp"
#include "search/cpu/scan/proximity.hpp"
#include "search/cpu/scan/pruner-inl.h"
#include "search/cpu/scan/scan_kernels-inl.h"
#include "search/cpu/tables/block_bits.hpp"
#include "search/cpu/tuning.hpp"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

constexpr int kBlock = TrayTables::kBlock;
constexpr int kQuad = SumLayout::kQuad.y;  // positions of a quad along y and along z
static_assert(SumLayout::kQuad == Extent{1, kQuad, kQuad} && kQuad == 2);

/// A brick of which blocks are left, the least of whose bounds is `bound`.
struct Survivor {
    std::uint32_t bound = 0;
    int bx = 0, by = 0;
    OpenPair* open = nullptr;
    std::size_t pruned = 0;
    std::uint16_t within[kBlocksY] = {};
    std::uint16_t pooled[kBlocksY] = {};  // of these whose bounds are sums over blocks, from the lowest layer on
};

/// One thread's decisions on what is left of one orientation.
class Evaluator {
  public:
    Evaluator(const OrientationTask& task, LayerLimits& limits)
        : t_(task), context_(task.context), state_(task.state), limits_(limits) {}

    /// Offers the best free positions of brick layer bz's survivors to the incumbent.
    void EvaluateAll(int bz, std::vector<Survivor>& survivors) {
        // Without anything to beat, the most promising come first; later, neighbours do.
        if (context_.incumbent.generation() == 0) {
            std::sort(survivors.begin(), survivors.end(),
                      [](const Survivor& a, const Survivor& b) { return a.bound < b.bound; });
        }
        chosen_.resize(survivors.size());
        if (context_.quads != nullptr) ChooseByQuads(bz, survivors);
        for (std::size_t i = 0; i < survivors.size(); ++i) {
            EvaluateBrick(survivors[i], bz, chosen_[i]);
        }
    }

    /// Offers a candidate if it is free.
    void EvaluateOne(const VoxelIndex& q) {
        limits_.look(q.z / kBrickZ);
        const std::int64_t limit = limits_.of(q.z % kBrickZ);
        if (limit < 0) return;
        alignas(64) std::uint64_t asked[kBrickY] = {}, live[kBrickY] = {};
        Bounds bounds = {};
        asked[q.y % kBrickY] = std::uint64_t{1} << q.x % kBrickX;
        EvaluateTile(q.x / kBrickX, q.y / kBrickY, q.z, 0, limit, live, asked, bounds);
    }

  private:
    using Bounds = std::uint32_t[kBlocksY][kBlocksX];
    /// What is to be evaluated of a brick, and bounds of the blocks in which other positions are live.
    struct alignas(64) Chosen {
        BrickWords free;
        Bounds bound;
    };
    /// Quads side by side along x, of positions of which the first is at x, y, z.
    struct StretchOfQuads {
        int x, y, z;
        std::uint32_t lanes;
        std::uint64_t* free;   // row y of layer z of their tile
        std::uint32_t* bound;  // of their row of blocks
    };
    /// Of a row of a tile; stretches may begin anywhere in it.
    using RowSums = std::uint32_t[kBrickX + kStretch];
    /// A free position of a tile and its rho.
    struct Found {
        std::uint32_t sum;
        int x, y;
    };

    /// Clears what the look-ups of batches [begin, end) find to collide.
    void Block(std::size_t begin, std::size_t end, int bx, int by, int z, std::uint64_t* words) const {
        const BitTables& bits = context_.tables.bits();
        const LookupList& list = t_.lists.lookups.of_positions;
        PruneTile(bits.tile(bx, kBrickY * by, z), bits.next(), list, begin, std::min(end, list.batches.size()), words);
    }

    /// Decides every position of the brick that could be the answer, of those that quads have `chosen` where they are
    /// asked. What was learnt of the others is for further copies only.
    void EvaluateBrick(const Survivor& survivor, int bz, Chosen& chosen) {
        const auto& [bound_then, bx, by, open, pruned, within, pooled] = survivor;
        limits_.look(bz);
        if (limits_.most() < 0 || bound_then > limits_.reach()) return;
        if (context_.quads == nullptr) ChooseByBlocks(survivor, bz, chosen);
        const int half = bx % kPair;
        for (int i = 0; i < kBrickZ; ++i) {
            const std::uint64_t* asked = chosen.free + kBrickY * i;
            if (std::all_of(asked, asked + kBrickY, [](std::uint64_t word) { return word == 0; })) continue;
            limits_.look(bz);
            EvaluateTile(bx, by, kBrickZ * bz + i, pruned, limits_.of(i), open->live[half] + kBrickY * i, asked,
                         chosen.bound);
        }
        if (!state_.keeps()) return;
        for (int j = 0; j < kBlocksY; ++j) {
            std::copy_n(chosen.bound[j], kBlocksX, open->bound[j] + half * kBlocksX);
        }
    }

    /// Chooses of a brick the positions whose blocks are not ruled out by cells and within their layer's limit.
    void ChooseByBlocks(const Survivor& survivor, int bz, Chosen& chosen) const {
        const int half = survivor.bx % kPair;
        const std::uint32_t lowest_rise = limits_.rise(state_.lowest_layer(bz));
        for (int j = 0; j < kBlocksY; ++j) {
            const std::uint32_t* before = survivor.open->bound[j] + half * kBlocksX;
            // What sums over blocks say of rho they say of all layers alike.
            const std::uint32_t pooled = survivor.pooled[j];
            std::uint32_t* bound = chosen.bound[j];
            std::fill_n(bound, kBlocksX, kDead);
            std::uint32_t bounded = 0;
            std::uint64_t left = 0;
            for (int z = 0; z < kBrickZ; ++z) {
                const std::int64_t limit = limits_.of(z);
                const std::uint32_t rise = limits_.rise(z);
                std::uint32_t blocks = 0;
                if (limit >= 0) {
                    const std::uint32_t most = lane_limit(limit);
                    blocks = AtMost(before, raised(most, rise));
                    if (rise != lowest_rise) {
                        blocks = (blocks & ~pooled) | (AtMost(before, raised(most, lowest_rise)) & pooled);
                    }
                }
                const std::uint64_t within = widened(blocks & survivor.within[j]);
                const std::uint64_t* live = survivor.open->live[half] + kBrickY * z;
                for (int y = kBlock * j; y < kBlock * (j + 1); ++y) {
                    chosen.free[kBrickY * z + y] = live[y] & within;
                    left |= live[y] & ~within;
                }
                if (z + 1 < kBrickZ && limits_.rise(z + 1) == rise) continue;
                // Of the layers of which something is left the lowest has the least bound.
                const std::uint32_t newly = every_fourth(any_of_block(left)) & ~bounded;
                for (std::uint32_t bits = newly; bits != 0; bits &= bits - 1) {
                    const int i = std::countr_zero(bits);
                    bound[i] = pooled >> i & 1 ? raised(before[i] - lowest_rise, rise) : std::max(before[i], rise);
                    if (before[i] == 0) bound[i] = 0;  // it has none yet
                }
                bounded |= newly;
            }
        }
    }

    /// Chooses what is to be evaluated of all survivors of brick layer bz: the positions that are in a block and in a
    /// quad within the limit. One sum for the four positions of a quad rules out nineteen in twenty of those that
    /// blocks left.
    void ChooseByQuads(int bz, const std::vector<Survivor>& survivors) {
        quads_.clear();
        for (std::size_t i = 0; i < survivors.size(); ++i) {
            ChooseByBlocks(survivors[i], bz, chosen_[i]);
            ListQuads(survivors[i], bz, chosen_[i]);
        }
        SumUp<true>(
            t_.lists.exact, std::span<const StretchOfQuads>(quads_),
            [&](const StretchOfQuads& quads) { return context_.quads->base(quads.x, quads.y, quads.z); },
            limits_.stop_above(limits_.most()),
            [&](const StretchOfQuads& quads, const std::uint32_t* sums) {
                for (int i = 0; i < kQuad; ++i) {
                    const int layer = quads.z % kBrickZ + i;
                    const std::int64_t limit = limits_.of(layer);
                    const std::uint32_t above = limit < 0 ? 0 : quads.lanes & ~AtMost(sums, lane_limit(limit));
                    const std::uint64_t out = static_cast<std::uint64_t>(above) << quads.x % kBrickX;
                    std::uint64_t* rows = quads.free + kBrickY * i;
                    if (state_.keeps()) {
                        for (std::uint64_t left = out & (rows[0] | rows[1]); left != 0; left &= left - 1) {
                            const int x = std::countr_zero(left);
                            std::uint32_t& bound = quads.bound[x / kBlock];
                            bound = std::min(bound, raised(sums[x - quads.x % kBrickX], limits_.rise(layer)));
                        }
                    }
                    rows[0] &= ~out;
                    rows[1] &= ~out;
                }
            });
    }

    void ListQuads(const Survivor& survivor, int bz, Chosen& chosen) {
        for (int z = 0; z < kBrickZ; z += kQuad) {
            for (int y = 0; y < kBrickY; y += kQuad) {
                std::uint64_t *rows = chosen.free + kBrickY * z + y, *above = rows + kBrickY;
                for_each_stretch(rows[0] | rows[1] | above[0] | above[1], [&](int x, std::uint32_t lanes) {
                    quads_.push_back({kBrickX * survivor.bx + x, kBrickY * survivor.by + y, kBrickZ * bz + z, lanes,
                                      rows, chosen.bound[y / kBlock]});
                });
            }
        }
    }

    /// Evaluates the positions of a tile that are `asked` about.
    void EvaluateTile(int bx, int by, int z, std::size_t first_batch, std::int64_t limit, std::uint64_t* live,
                      const std::uint64_t* asked, Bounds& after) {
        alignas(64) std::uint64_t free[kBrickY];
        std::copy_n(asked, kBrickY, free);
        const std::size_t begin = LookUpFurther(first_batch, bx, by, z, free);
        alignas(64) std::uint64_t close[kBrickY];
        RowSums sums[kBrickY];
        if (SumUpRho(bx, by, z, free, limit, close, sums, after)) Decide(begin, bx, by, z, sums, close, free, after);
        if (!state_.keeps()) return;
        for (int y = 0; y < kBrickY; ++y) {
            live[y] &= free[y] | ~asked[y];
        }
    }

    /// Look-ups from batch `begin` on, as long as they are few beside the loads of weighing what they leave: of that
    /// most is free and too far off, and rho decides sooner. Returns the first batch that was not made.
    std::size_t LookUpFurther(std::size_t begin, int bx, int by, int z, std::uint64_t* free) const {
        const std::vector<LookupList::Batch>& batches = t_.lists.lookups.of_positions.batches;
        const auto loads = static_cast<std::int64_t>(t_.lists.exact.loads.size());
        std::int64_t made = 0;
        for (std::size_t b = begin; b < batches.size(); ++b) {
            const std::int64_t sums = SumsFor(free);
            if (sums == 0) break;
            if (b >= tuning::kLeastPruning && tuning::kLoadsPerLookup * made > sums * loads) return b;
            Block(b, b + 1, bx, by, z, free);
            made += batches[b].lookups;
        }
        return batches.size();
    }

    /// How many sums of two stretches it takes to weigh these positions.
    static int SumsFor(const std::uint64_t* free) {
        int stretches = 0;
        for (int y = 0; y < kBrickY; ++y) {
            for_each_stretch(free[y], [&](int, std::uint32_t) { ++stretches; });
        }
        return (stretches + 1) / 2;
    }

    /// The remaining look-ups for the `close` positions, whose rho is within the limit: clears in `free` those that
    /// collide or are not admitted, offers the best of the others.
    void Decide(std::size_t begin, int bx, int by, int z, const RowSums* sums, const std::uint64_t* close,
                std::uint64_t* free, Bounds& after) {
        alignas(64) std::uint64_t left[kBrickY];
        std::copy_n(close, kBrickY, left);
        Block(begin, t_.lists.lookups.of_positions.batches.size(), bx, by, z, left);
        found_.clear();
        for (int y = 0; y < kBrickY; ++y) {
            free[y] &= left[y] | ~close[y];
            for (std::uint64_t bits = left[y]; bits != 0; bits &= bits - 1) {
                const int x = std::countr_zero(bits);
                std::uint32_t& bound = after[y / kBlock][x / kBlock];
                bound = std::min(bound, raised(sums[y][x], limits_.rise(z % kBrickZ)));
                found_.push_back({sums[y][x], x, y});
            }
        }
        std::ranges::stable_sort(found_, {}, &Found::sum);
        for (const Found& found : found_) {
            const VoxelIndex q{kBrickX * bx + found.x, kBrickY * by + found.y, z};
            const bool exact = found.sum != kSumLimit;  // else each for itself: it is more than lanes hold
            if (!Offer(q, exact ? found.sum : proximity_at(context_.tables, t_.runs.solid, q))) {
                t_.state.note_refused(q);
                free[found.y] &= ~(std::uint64_t{1} << found.x);
            } else if (exact) {
                break;
            }
        }
    }

    /// Sums up rho of a tile's `free` positions: `close` become those where it is within the limit, which it is in
    /// `sums`; bounds of the others' blocks are lowered to theirs, or to something less that rules them out too.
    /// True if any are close.
    bool SumUpRho(int bx, int by, int z, const std::uint64_t* free, std::int64_t limit, std::uint64_t* close,
                  RowSums* sums, Bounds& bounds) const {
        Stretches<kBrickY * kBrickX> stretches;
        for (int y = 0; y < kBrickY; ++y) {
            close[y] = 0;
            stretches.add(y, free[y]);
        }
        const std::uint32_t most = lane_limit(limit), rise = limits_.rise(z % kBrickZ);
        bool any = false;
        context_.tables.visit_sums([&](const auto& tables) {
            SumUp<false>(
                t_.lists.exact, stretches.all(),
                [&](const Stretch& row) { return tables.exact.base(kBrickX * bx + row.x, kBrickY * by + row.y, z); },
                limits_.stop_above(limit),
                [&](const Stretch& row, const std::uint32_t* rho) {
                    const std::uint32_t within = row.lanes & AtMost(rho, most);
                    std::uint32_t above = state_.keeps() ? row.lanes & ~within : 0;
                    for (; above != 0; above &= above - 1) {
                        const int i = std::countr_zero(above);
                        std::uint32_t& bound = bounds[row.y / kBlock][(row.x + i) / kBlock];
                        bound = std::min(bound, raised(rho[i], rise));
                    }
                    if (within == 0) return;
                    close[row.y] |= static_cast<std::uint64_t>(within) << row.x;
                    std::copy_n(rho, kStretch, sums[row.y] + row.x);
                    any = true;
                });
        });
        return any;
    }

    /// False where the position would be the best so far but is not admitted.
    bool Offer(const VoxelIndex& position, std::int64_t proximity) {
        const ScoredPosition placed{
            cost_of(context_.model, position.z, t_.layers, context_.reference_layers, proximity), t_.index, position,
            proximity};
        if (t_.admits && context_.incumbent.improved_by(placed) && !(*t_.admits)(t_.index, position)) return false;
        context_.incumbent.offer(placed);
        return true;
    }

    const OrientationTask& t_;
    SearchContext& context_;
    const PositionState& state_;
    LayerLimits& limits_;
    std::vector<Chosen> chosen_;  // of each survivor
    std::vector<StretchOfQuads> quads_;
    std::vector<Found> found_;
};

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#endif
