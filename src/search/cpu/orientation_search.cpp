#include "search/cpu/orientation_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <span>

#include "search/cpu/block_bits.hpp"
#include "search/cpu/stretches.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/orientation_search.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "search/cpu/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

constexpr int kBlock = TrayTables::kBlock;
constexpr int kQuad = SumLayout::kQuad.y;  // positions of a quad along y and along z
static_assert(SumLayout::kQuad == Extent{1, kQuad, kQuad} && kQuad == 2);
// Bricks are looked at in pairs, whose blocks are what cells are asked for at once; a brick's are a stretch.
static_assert(kPair * kBlocksX == kLanes && kBlocksX == kStretch);
static_assert(kBrickZ <= BitTables::kTileLayers);
// A tile of the crowd tables is that many bricks.
constexpr int kCrowdBricksX = CrowdTables::kTileX / kBlocksX, kCrowdBricksY = CrowdTables::kTileY / kBlocksY;
static_assert(kBrickZ == CrowdTables::kBlock && kBlock == CrowdTables::kBlock && kCrowdBricksX % kPair == 0);
constexpr int kMostSkipped = 24;             // rows between two questions in vain
constexpr int kPatienceWithStacks = 4;       // questions in vain that are asked all the same
constexpr std::int64_t kLoadsPerLookup = 8;  // of what is left, until it is weighed
constexpr int kBeyond = 5;                   // sums for copies go a fifth beyond the limit

/// What SumLanes() can take as a limit: nothing is above kSumLimit.
std::uint32_t LaneLimit(std::int64_t limit) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(limit, 0, kSumLimit));
}

/// One thread's work on some brick layers of one orientation.
class Pass {
  public:
    explicit Pass(OrientationTask& task) : t_(task), context_(task.context), state_(task.state) {
        if (!state_.keeps()) for_now_ = std::make_unique_for_overwrite<OpenPair[]>(state_.pairs_in_layer());
    }

    void Run(int begin, int end) {
        for (int bz = begin; bz < end; ++bz) {
            LookAtLimits(bz);
            if (most_ < 0) continue;
            sifted_.clear();
            for (int by = 0; by < state_.bricks().y; ++by) {
                if (by % kCrowdBricksY == 0) LookAtCrowd(by / kCrowdBricksY, bz);
                for (int bx = 0; bx < state_.bricks().x; bx += kPair) {
                    LookAtLimits(bz);
                    SiftPair(bx, by, bz);
                }
            }
            LookAtLimits(bz);
            BoundPairs(bz);
            // Without anything to beat, the most promising come first; later, neighbours do.
            if (context_.incumbent.generation() == 0) {
                std::sort(survivors_.begin(), survivors_.end(),
                          [](const Survivor& a, const Survivor& b) { return a.bound < b.bound; });
            }
            chosen_.resize(survivors_.size());
            if (context_.quads != nullptr) ChooseByQuads(bz);
            for (std::size_t i = 0; i < survivors_.size(); ++i) {
                Settle(survivors_[i], bz, chosen_[i]);
            }
        }
    }

  private:
    /// A pair of bricks that the sift left something of.
    struct SiftedPair {
        int bx, by;
        OpenPair* open;
        std::size_t sifted[kPair];     // batches that need not be repeated, made in this search
        std::uint32_t near[kBlocksY];  // blocks that Near() left, by row
    };
    /// Blocks side by side that have no bound yet; x and y count blocks of the tray.
    struct UnknownBlocks {
        int x, y;
        std::uint32_t lanes;
        std::uint32_t* bound;  // of the first of them
    };
    struct Survivor {
        std::uint32_t bound = 0;
        int bx = 0, by = 0;
        OpenPair* open = nullptr;
        std::size_t sifted = 0;
        std::uint16_t near[kBlocksY] = {};
    };
    using Bounds = std::uint32_t[kBlocksY][kBlocksX];
    /// What is to be settled of a brick, and bounds of the blocks in which other positions are live.
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

    /// The limits of brick layer bz's four layers, as the incumbent stands now.
    void LookAtLimits(int bz) {
        const std::uint64_t generation = context_.incumbent.generation();
        if (bz == limits_layer_ && generation == limits_generation_) return;
        limits_layer_ = bz;
        limits_generation_ = generation;
        const std::optional<Placed> best = context_.incumbent.get();
        most_ = -1;
        for (int i = 0; i < kBrickZ; ++i) {
            const int z = kBrickZ * bz + i;
            limits_[i] = z < state_.count().z && context_.model.allows(t_.index, z)
                             ? proximity_limit(context_.model, z, t_.layers, context_.reference_layers, best, t_.index)
                             : -1;
            most_ = std::max(most_, limits_[i]);
        }
    }

    /// Which blocks of the crowd tables' tiles in row j have room for anything at all, as far as pairs there are fresh.
    void LookAtCrowd(int j, int bz) {
        const int tiles = (state_.bricks().x + kCrowdBricksX - 1) / kCrowdBricksX;
        room_.assign(static_cast<std::size_t>(tiles * kTileRows), ~std::uint64_t{0});
        if (t_.plan.collision.of_blocks.batches.empty()) return;
        for (int i = 0; i < tiles; ++i) {
            if (AnyFresh(i, j, bz)) SiftBlocks(i, j, bz, room_.data() + i * kTileRows);
        }
    }

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
    void SiftBlocks(int i, int j, int bz, std::uint64_t* room) const {
        const CrowdTables& crowd = context_.tables.crowd();
        const LookupPlan& plan = t_.plan.collision.of_blocks;
        for (std::size_t b = 0; b < plan.batches.size(); ++b) {
            BlockTiles<1>(crowd.tile(i, j, bz), crowd.next(), 0, plan, b, b + 1, room);
            std::uint64_t any = 0, all = ~std::uint64_t{0};
            for (int k = 0; k < kTileRows; ++k) {
                any |= room[k];
                all &= room[k];
            }
            if (any == 0 || all == ~std::uint64_t{0}) return;
        }
    }

    /// Of a fresh pair, what LookAtCrowd() left of a row of blocks.
    std::uint32_t Room(int bx, int by, int row) const {
        const std::size_t tile = static_cast<std::size_t>(bx / kCrowdBricksX * kTileRows);
        const std::size_t word = static_cast<std::size_t>(by % kCrowdBricksY * kBlocksY + row);
        return static_cast<std::uint32_t>(room_[tile + word] >> (bx % kCrowdBricksX * kBlocksX));
    }

    /// What may be asked first and often says nothing, as cells do in a crowd and stacks in the open: where asking was
    /// in vain more than `patience` times, it is not asked as many times again.
    class Patience {
      public:
        explicit Patience(int patience = 0) : patience_(patience) {}
        bool asks() {
            if (skip_ == 0) return true;
            --skip_;
            return false;
        }
        void learn(bool in_vain) {
            vain_ = in_vain ? std::min(vain_ + 1, kMostSkipped) : -patience_;
            skip_ = std::max(0, vain_);
        }

      private:
        int patience_;
        int vain_ = -patience_, skip_ = 0;
    };

    /// Which of a pair's row of blocks are near enough to something that rho could stay within the limit, as far as the
    /// whole solid in large cells tells.
    std::uint32_t Near(int bx, int block_y, int bz, std::uint32_t blocks) {
        if (!near_.asks()) return blocks;
        const std::uint32_t near = Within(t_.cells, bx, block_y, bz, blocks);
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
        const std::uint32_t close = Within(t_.fine_cells, bx, block_y, bz, unknown);
        // A sum takes as long however few of its lanes are wanted, so few that are left are no great gain.
        close_.learn(3 * std::popcount(close) > std::popcount(unknown));
        return close | (blocks & ~unknown);
    }

    std::uint32_t Within(const CellPlan& cells, int bx, int block_y, int bz, std::uint32_t blocks) const {
        return WithinLimit(context_.tables.minima().at({bx * kBlocksX, block_y, bz}), cells, LaneLimit(most_), blocks);
    }

    /// Sifts two bricks side by side.
    void SiftPair(int bx, int by, int bz) {
        if (state_.is_dead(bx, by, bz)) return;
        const std::uint32_t limit = LaneLimit(most_);
        const bool fresh = state_.is_fresh(bx, by, bz);
        OpenPair* open = fresh ? nullptr : &state_.open_pair(bx, by, bz);
        std::uint32_t near[kBlocksY], room[kBlocksY];
        std::uint32_t any = 0;
        for (int j = 0; j < kBlocksY; ++j) {
            room[j] = fresh ? Room(bx, by, j) : 0;
            near[j] = fresh ? room[j] : PairAtMost(open->bound[j], limit);
            if (near[j] != 0) near[j] = Near(bx, by * kBlocksY + j, bz, near[j]);
            any |= near[j];
        }
        if (any == 0) return;
        SiftedPair pair{bx, by, open, {}, {near[0], near[1]}};
        if (fresh) pair.open = Sift(bx, by, bz, room, pair.sifted);
        if (pair.open != nullptr) sifted_.push_back(pair);
    }

    /// Bounds the blocks of the pairs that were sifted, of all together two stretches at a time: a pair alone has one
    /// or two that are near and have no bound yet.
    void BoundPairs(int bz) {
        const std::uint32_t limit = LaneLimit(most_);
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
                    for_each_stretch(pair->near[j] & Unknown(bound), [&](int x, std::uint32_t lanes) {
                        unknown_.push_back({pair->bx * kBlocksX + x, y, lanes, bound + x});
                    });
                }
            }
            first = last;
        }
        context_.tables.visit_sums([&](const auto& tables) {
            SumUp<true>(
                t_.plan.coarse, std::span<const UnknownBlocks>(unknown_),
                [&](const UnknownBlocks& blocks) {
                    return tables.coarse.base(blocks.x, kBlock * blocks.y, kBrickZ * bz);
                },
                StopAbove(most_),
                [&](const UnknownBlocks& blocks, const std::uint32_t* sums) {
                    for (std::uint32_t left = blocks.lanes; left != 0; left &= left - 1) {
                        const int i = std::countr_zero(left);
                        blocks.bound[i] = sums[i];
                    }
                });
        });
        survivors_.clear();
        for (const SiftedPair& pair : sifted_) {
            const auto& bound = pair.open->bound;
            for (int i = 0; i < std::min(kPair, state_.bricks().x - pair.bx); ++i) {
                Survivor survivor{kDead, pair.bx + i, pair.by, pair.open, pair.sifted[i], {}};
                for (int j = 0; j < kBlocksY; ++j) {
                    survivor.near[j] = static_cast<std::uint16_t>(pair.near[j] >> (i * kBlocksX));
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

    /// Opens a fresh pair with what the first batches of look-ups leave of its blocks that have `room`; null if that is
    /// nothing. `sifted` is how many batches each brick went through.
    OpenPair* Sift(int bx, int by, int bz, const std::uint32_t (&room)[kBlocksY], std::size_t (&sifted)[kPair]) {
        alignas(64) BrickWords live[kPair];
        bool left[kPair];
        for (int i = 0; i < kPair; ++i) {
            std::uint32_t alive[kBlocksY];
            for (int j = 0; j < kBlocksY; ++j) {
                alive[j] = room[j] >> (kBlocksX * i) & 0xFFFFu;
            }
            left[i] = std::ranges::any_of(alive, [](std::uint32_t row) { return row != 0; }) &&
                      bx + i < state_.bricks().x && SiftStacks(bx + i, by, bz, alive, live[i]);
            if (!left[i]) continue;
            sifted[i] = SiftLayers(bx + i, by, bz, live[i]);
            left[i] = std::ranges::any_of(live[i], [](std::uint64_t word) { return word != 0; });
        }
        if (!left[0] && !left[1]) {
            state_.close(bx, by, bz);
            return nullptr;
        }
        for (int i = 0; i < kPair; ++i) {
            if (!left[i]) std::fill_n(live[i], kBrickY * kBrickZ, std::uint64_t{0});
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

    /// The candidates of a brick in its `alive` blocks, but for stacks that are found to collide as one. False where
    /// nothing is left.
    bool SiftStacks(int bx, int by, int bz, const std::uint32_t (&alive)[kBlocksY], std::uint64_t* live) {
        state_.candidates(bx, by, alive, live);
        const BitTables& bits = context_.tables.bits();
        const LookupPlan& plan = t_.plan.collision.of_stacks;
        const bool asks = !plan.batches.empty() && stacks_.asks();
        if (asks) {
            BlockTiles<1>(bits.tile(bx, kBrickY * by, kBrickZ * bz), bits.next(), bits.up(), plan, 0,
                          plan.batches.size(), live);
        }
        const bool any = std::any_of(live, live + kBrickY, [](std::uint64_t word) { return word != 0; });
        if (asks) stacks_.learn(any);
        if (!any) return false;
        for (int z = 1; z < kBrickZ; ++z) {
            if (z < state_.layers(bz)) {
                std::copy_n(live, kBrickY, live + kBrickY * z);
            } else {
                std::fill_n(live + kBrickY * z, kBrickY, std::uint64_t{0});
            }
        }
        return true;
    }

    /// The first batches for a brick's layers; the very first of them for all at once, since it leaves out none.
    /// Returns how many batches all that is left went through.
    std::size_t SiftLayers(int bx, int by, int bz, std::uint64_t* live) const {
        const BitTables& bits = context_.tables.bits();
        const LookupPlan& plan = t_.plan.collision.of_positions;
        const std::size_t all = std::min(t_.plan.collision.sift, plan.batches.size());
        const std::size_t first = std::min(CollisionPlan::kForAllLayers, all);
        const std::size_t some = std::min(CollisionPlan::kLeastSift, all);
        std::uint64_t before[kBrickY];  // of any layer that has candidates
        std::copy_n(live, kBrickY, before);
        const std::uint64_t* lowest = bits.tile(bx, kBrickY * by, kBrickZ * bz);
        BlockTiles<kBrickZ>(lowest, bits.next(), bits.up(), plan, 0, first, live);
        std::size_t least = all;
        for (int i = 0; i < kBrickZ; ++i) {
            std::uint64_t* tile = live + kBrickY * i;
            const std::uint64_t* at = lowest + i * bits.up();
            BlockTile(at, bits.next(), plan, first, some, tile);
            if (some == all) continue;
            if (std::equal(tile, tile + kBrickY, before)) {
                least = some;  // in the open, where most of it would be in vain
            } else {
                BlockTile(at, bits.next(), plan, some, all, tile);
            }
        }
        return least;
    }

    /// BlockTiles() of one tile, for many callers.
    static HWY_NOINLINE void BlockTile(const std::uint64_t* tile, std::ptrdiff_t next, const LookupPlan& plan,
                                       std::size_t begin, std::size_t end, std::uint64_t* words) {
        BlockTiles<1>(tile, next, 0, plan, begin, end, words);
    }

    /// Clears what the look-ups of batches [begin, end) find to collide.
    void Block(std::size_t begin, std::size_t end, int bx, int by, int z, std::uint64_t* words) const {
        const BitTables& bits = context_.tables.bits();
        const LookupPlan& plan = t_.plan.collision.of_positions;
        BlockTile(bits.tile(bx, kBrickY * by, z), bits.next(), plan, begin, std::min(end, plan.batches.size()), words);
    }

    /// What sums have to be above to be given up. Copies are likely to be followed by copies, for which the limit is a
    /// little higher: sums that go on beyond it leave bounds that still rule out then.
    std::uint32_t StopAbove(std::int64_t limit) const {
        const std::int64_t least = LaneLimit(limit);
        return LaneLimit(t_.for_copy ? least + least / kBeyond : least);
    }

    /// SumLanes() of a plan for all of some stretches, two at a time: calls each(stretch, its sums). from(stretch) is
    /// the element of its table that the plan's offsets count from.
    template <bool kOfEach, class AnyStretch, class From, class Each>
    static void SumUp(const SumPlan& plan, std::span<const AnyStretch> stretches, const From& from,
                      std::uint32_t stop_above, const Each& each) {
        alignas(64) std::uint32_t sums[kLanes];
        for (std::size_t i = 0; i < stretches.size(); i += 2) {
            const bool both = i + 1 < stretches.size();
            const AnyStretch& low = stretches[i];
            const AnyStretch& high = stretches[both ? i + 1 : i];
            SumLanes<kOfEach>(from(low), from(high), plan.loads.data(), plan.batches.data(), plan.batches.size(),
                              stop_above, low.lanes | (both ? high.lanes << kStretch : 0), LaneLimit(plan.least), sums);
            each(low, sums);
            if (both) each(high, sums + kStretch);
        }
    }

    /// Decides every position of the brick that could be the answer, of those that quads have `chosen` where they are
    /// asked. What was learnt of the others is for further copies only.
    void Settle(const Survivor& survivor, int bz, Chosen& chosen) {
        const auto& [bound_then, bx, by, open, sifted, near] = survivor;
        LookAtLimits(bz);
        if (most_ < 0 || bound_then > LaneLimit(most_)) return;
        if (context_.quads == nullptr) ChooseByBlocks(survivor, chosen);
        const int half = bx % kPair;
        for (int i = 0; i < kBrickZ; ++i) {
            LookAtLimits(bz);
            SettleTile(bx, by, kBrickZ * bz + i, sifted, limits_[i], open->live[half] + kBrickY * i,
                       chosen.free + kBrickY * i, chosen.bound);
        }
        if (!state_.keeps()) return;
        for (int j = 0; j < kBlocksY; ++j) {
            std::copy_n(chosen.bound[j], kBlocksX, open->bound[j] + half * kBlocksX);
        }
    }

    /// Chooses of a brick the positions whose blocks are near and within their layer's limit.
    void ChooseByBlocks(const Survivor& survivor, Chosen& chosen) const {
        const int half = survivor.bx % kPair;
        for (int j = 0; j < kBlocksY; ++j) {
            const std::uint32_t* before = survivor.open->bound[j] + half * kBlocksX;
            std::uint64_t left = 0;
            for (int z = 0; z < kBrickZ; ++z) {
                const std::int64_t limit = limits_[z];
                const std::uint64_t within =
                    limit >= 0 ? widened(AtMost(before, LaneLimit(limit)) & survivor.near[j]) : 0;
                const std::uint64_t* live = survivor.open->live[half] + kBrickY * z;
                for (int y = kBlock * j; y < kBlock * (j + 1); ++y) {
                    chosen.free[kBrickY * z + y] = live[y] & within;
                    left |= live[y] & ~within;
                }
            }
            std::fill_n(chosen.bound[j], kBlocksX, kDead);
            if (state_.keeps()) LowerBounds(any_of_block(left), before, chosen.bound[j]);
        }
    }

    /// Lowers `after` to `before` for the blocks whose lowest bits are set in `blocks`.
    static void LowerBounds(std::uint64_t blocks, const std::uint32_t* before, std::uint32_t* after) {
        for (; blocks != 0; blocks &= blocks - 1) {
            const int i = std::countr_zero(blocks) / kBlock;
            after[i] = std::min(after[i], before[i]);
        }
    }

    /// Chooses what is to be settled of all survivors of brick layer bz: the positions that are in a block and in a
    /// quad within the limit. One sum for the four positions of a quad rules out nineteen in twenty of those that
    /// blocks left.
    void ChooseByQuads(int bz) {
        quads_.clear();
        for (std::size_t i = 0; i < survivors_.size(); ++i) {
            ChooseByBlocks(survivors_[i], chosen_[i]);
            ListQuads(survivors_[i], bz, chosen_[i]);
        }
        SumUp<true>(
            t_.plan.fine, std::span<const StretchOfQuads>(quads_),
            [&](const StretchOfQuads& quads) { return context_.quads->base(quads.x, quads.y, quads.z); },
            StopAbove(most_),
            [&](const StretchOfQuads& quads, const std::uint32_t* sums) {
                for (int i = 0; i < kQuad; ++i) {
                    const std::int64_t limit = limits_[quads.z % kBrickZ + i];
                    const std::uint32_t above = limit < 0 ? 0 : quads.lanes & ~AtMost(sums, LaneLimit(limit));
                    const std::uint64_t out = static_cast<std::uint64_t>(above) << quads.x % kBrickX;
                    std::uint64_t* rows = quads.free + kBrickY * i;
                    if (state_.keeps()) {
                        for (std::uint64_t left = out & (rows[0] | rows[1]); left != 0; left &= left - 1) {
                            const int x = std::countr_zero(left);
                            std::uint32_t& bound = quads.bound[x / kBlock];
                            bound = std::min(bound, sums[x - quads.x % kBrickX]);
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

    /// Settles the positions of a tile that are `asked` about.
    void SettleTile(int bx, int by, int z, std::size_t first_batch, std::int64_t limit, std::uint64_t* live,
                    const std::uint64_t* asked, Bounds& after) {
        if (std::all_of(asked, asked + kBrickY, [](std::uint64_t word) { return word == 0; })) return;
        alignas(64) std::uint64_t free[kBrickY];
        std::copy_n(asked, kBrickY, free);
        const std::size_t begin = SiftFurther(first_batch, bx, by, z, free);
        alignas(64) std::uint64_t close[kBrickY];
        RowSums sums[kBrickY];
        if (Weigh(bx, by, z, free, limit, close, sums, after)) Decide(begin, bx, by, z, sums, close, free, after);
        if (!state_.keeps()) return;
        for (int y = 0; y < kBrickY; ++y) {
            live[y] &= free[y] | ~asked[y];
        }
    }

    /// Look-ups from batch `begin` on, as long as they are few beside the loads of weighing what they leave: of that
    /// most is free and too far off, and rho decides sooner. Returns the first batch that was not made.
    std::size_t SiftFurther(std::size_t begin, int bx, int by, int z, std::uint64_t* free) const {
        const std::vector<LookupPlan::Batch>& batches = t_.plan.collision.of_positions.batches;
        const auto loads = static_cast<std::int64_t>(t_.plan.fine.loads.size());
        std::int64_t made = 0;
        for (std::size_t b = begin; b < batches.size(); ++b) {
            const std::int64_t sums = SumsFor(free);
            if (sums == 0) break;
            if (b >= CollisionPlan::kLeastSift && kLoadsPerLookup * made > sums * loads) return b;
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
        Block(begin, t_.plan.collision.of_positions.batches.size(), bx, by, z, left);
        found_.clear();
        for (int y = 0; y < kBrickY; ++y) {
            free[y] &= left[y] | ~close[y];
            for (std::uint64_t bits = left[y]; bits != 0; bits &= bits - 1) {
                const int x = std::countr_zero(bits);
                std::uint32_t& bound = after[y / kBlock][x / kBlock];
                bound = std::min(bound, sums[y][x]);
                found_.push_back({sums[y][x], x, y});
            }
        }
        std::ranges::stable_sort(found_, {}, &Found::sum);
        for (const Found& found : found_) {
            const VoxelIndex q{kBrickX * bx + found.x, kBrickY * by + found.y, z};
            const bool beyond = found.sum == kSumLimit;  // what lanes hold: each for itself
            if (!Offer(q, beyond ? proximity_at(context_.tables, t_.solid, q) : found.sum)) {
                free[found.y] &= ~(std::uint64_t{1} << found.x);
            } else if (!beyond) {
                break;
            }
        }
    }

    /// Sums up rho of a tile's `free` positions: `close` become those where it is within the limit, which it is in
    /// `sums`; bounds of the others' blocks are lowered to theirs, or to something less that is above the limit too.
    /// True if any are close.
    bool Weigh(int bx, int by, int z, const std::uint64_t* free, std::int64_t limit, std::uint64_t* close,
               RowSums* sums, Bounds& bounds) const {
        Stretches<kBrickY * kBrickX> stretches;
        for (int y = 0; y < kBrickY; ++y) {
            close[y] = 0;
            stretches.add(y, free[y]);
        }
        const std::uint32_t most = LaneLimit(limit);
        bool any = false;
        context_.tables.visit_sums([&](const auto& tables) {
            SumUp<false>(
                t_.plan.fine, stretches.all(),
                [&](const Stretch& row) { return tables.exact.base(kBrickX * bx + row.x, kBrickY * by + row.y, z); },
                StopAbove(limit),
                [&](const Stretch& row, const std::uint32_t* rho) {
                    const std::uint32_t within = row.lanes & AtMost(rho, most);
                    std::uint32_t above = state_.keeps() ? row.lanes & ~within : 0;
                    for (; above != 0; above &= above - 1) {
                        const int i = std::countr_zero(above);
                        std::uint32_t& bound = bounds[row.y / kBlock][(row.x + i) / kBlock];
                        bound = std::min(bound, rho[i]);
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
        const Placed placed{cost_of(context_.model, position.z, t_.layers, context_.reference_layers, proximity),
                            t_.index, position, proximity};
        if (t_.admits && context_.incumbent.improved_by(placed) && !(*t_.admits)(t_.index, position)) return false;
        context_.incumbent.offer(placed);
        return true;
    }

    OrientationTask& t_;
    SearchContext& context_;
    PositionState& state_;
    std::vector<SiftedPair> sifted_;
    std::unique_ptr<OpenPair[]> for_now_;  // those of sifted_, where the state does not keep them
    std::vector<UnknownBlocks> unknown_;
    std::vector<Survivor> survivors_;
    std::vector<Chosen> chosen_;  // of each of them
    std::vector<StretchOfQuads> quads_;
    std::vector<Found> found_;
    std::vector<std::uint64_t> room_;  // by tile of the crowd tables in a row
    int limits_layer_ = -1;
    std::uint64_t limits_generation_ = 0;
    std::int64_t limits_[kBrickZ] = {};
    std::int64_t most_ = -1;
    Patience near_, close_, stacks_{kPatienceWithStacks};
};

void SearchLayers(OrientationTask& task, int begin, int end) { Pass(task).Run(begin, end); }

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {

HWY_EXPORT(SearchLayers);

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
            .layers = shape.solid->extent().z,
            .for_copy = for_copy,
            .admits = admits ? &admits : nullptr};
}

void search_layers(OrientationTask& task, int begin, int end) { HWY_DYNAMIC_DISPATCH(SearchLayers)(task, begin, end); }

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
        const std::uint16_t* value = phi.row(v.y, v.z) + v.x;
        for (int i = v[along]; i < end; ++i, value += steps[along]) {
            sum += *value;
        }
    }
    return sum;
}

}  // namespace spectralpack
#endif
