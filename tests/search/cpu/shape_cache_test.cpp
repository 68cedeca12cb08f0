// What the fast engine keeps from search to search.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/random.hpp"
#include "core/zeroed.hpp"
#include "search/cpu/scan/incumbent.hpp"
#include "search/cpu/scan/reaching_blocks.hpp"
#include "search/cpu/shape_cache.hpp"
#include "search/random_scene.hpp"

namespace spectralpack {
namespace {

ScoredPosition placed(double cost, int x) { return {.cost = {cost, 0}, .index = 0, .position = {x, 0, 0}}; }

TEST(Incumbent, RemembersTheBestOfThoseThatLost) {
    Incumbent incumbent;
    EXPECT_TRUE(incumbent.beaten().empty());
    RandomStream random(1);
    std::vector<int> costs(100);
    for (int i = 0; i < 100; ++i) {
        costs[static_cast<std::size_t>(i)] = i;
    }
    for (std::size_t i = 0; i < costs.size(); ++i) {
        std::swap(costs[i], costs[i + random.below(costs.size() - i)]);
        incumbent.offer(placed(costs[i], costs[i]));
        const std::vector<ScoredPosition> beaten = incumbent.beaten();
        std::vector<int> expected(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(i + 1));
        std::ranges::sort(expected);
        EXPECT_EQ(incumbent.get()->position.x, expected[0]);
        ASSERT_EQ(beaten.size(), std::min<std::size_t>(i, 8));
        for (std::size_t k = 0; k < beaten.size(); ++k) {
            EXPECT_EQ(beaten[k].position.x, expected[k + 1]);
        }
    }
}

TEST(ZeroedVector, IsZeroAlsoWhereMemoryWasUsedBefore) {
    for (const std::size_t size : {3u, 1000u, 3'000'000u}) {
        for (int round = 0; round < 3; ++round) {
            ZeroedVector<std::uint16_t> zeros(size);
            EXPECT_TRUE(std::ranges::all_of(zeros, [](std::uint16_t value) { return value == 0; }));
            std::memset(zeros.data(), 255, size * sizeof(std::uint16_t));
            const ZeroedVector<std::uint16_t> copy = zeros;
            EXPECT_EQ(copy, zeros);
        }
    }
}

/// Calls visit(bx, by, bz) for all pairs of bricks.
template <class Visit>
void for_each_pair(const PositionState& state, const Visit& visit) {
    for (int bz = 0; bz < state.bricks().z; ++bz) {
        for (int by = 0; by < state.bricks().y; ++by) {
            for (int bx = 0; bx < state.bricks().x; bx += kPair) {
                visit(bx, by, bz);
            }
        }
    }
}

/// One orientation's state with some pairs opened.
class OpenState : public testing::Test {
  protected:
    static constexpr Extent kCount{200, 20, 10};

    void SetUp() override {
        for_each_pair(state, [&](int bx, int by, int bz) {
            OpenPair& pair = state.open(bx, by, bz);
            for (auto& words : pair.live) {
                std::ranges::fill(words, 0);
            }
            for (auto& row : pair.bound) {
                std::ranges::fill(row, 7u);
            }
            pair.bound[0][1] = kDead;
            state.set_least_bound(bx, by, bz, 5);
        });
    }

    PositionState state{kCount, true};
};

TEST_F(OpenState, FindsLayersInWhichNothingIsLive) {
    state.open_pair(2, 1, 1).live[1][kBrickY * 2 + 5] = 1;
    state.open_pair(0, 0, 2).live[0][0] = 1;
    EXPECT_EQ(state.dead_layers(1), 0);
    state.look_for_dead_layers(1);
    EXPECT_EQ(state.dead_layers(1), 0b1011);
    EXPECT_EQ(state.dead_layers(0), 0);
    EXPECT_EQ(state.dead_layers(2), 0);
    PositionState fresh(kCount, true);
    fresh.look_for_dead_layers(0);  // where nobody has looked anything may be live
    EXPECT_EQ(fresh.dead_layers(0), 0);
}

TEST_F(OpenState, ForgetsWhatAChangeOfPhiMayHaveMadeWrong) {
    // A row of pairs that are fresh, open and dead by turns, with bounds on each.
    PositionState row({6 * 128, 8, 4}, true);
    for (int i = 0; i < 6; ++i) {
        const int bx = kPair * i;
        if (i % 3 == 1) {
            for (auto& bounds : row.open(bx, 0, 0).bound) {
                std::ranges::fill(bounds, 7u);
            }
        }
        row.set_least_bound(bx, 0, 0, 7);
        if (i % 3 == 2) row.close(bx, 0, 0);
    }
    const std::vector<VoxelBox> fallen{{{128 + 40, 3, 2}, {128 * 3 + 1, 4, 3}}};
    row.forget(blocks_reaching(blocks_of(fallen, 0, {6 * 128, 8, 4}), {10, 3, 3}));
    for (int i = 0; i < 6; ++i) {
        const bool touched = i >= 1 && i <= 3;
        EXPECT_EQ(row.least_bound(kPair * i, 0, 0), i % 3 == 2 ? kDead : touched ? 0 : 7) << i;
        if (!row.is_open(kPair * i, 0, 0)) continue;
        const auto& bound = row.open_pair(kPair * i, 0, 0).bound;
        for (std::size_t x = 0; x < kPair * kBlocksX; ++x) {
            const bool reaches = i == 1 && 4 * x + 3 + 9 >= 40;
            EXPECT_EQ(bound[0][x], reaches ? 0 : 7) << i << ", " << x;
            EXPECT_EQ(bound[1][x], 7) << i << ", " << x;
        }
    }
}

TEST_F(OpenState, ReopensTheBlocksThatReachIntoWhatWentAndNoOthers) {
    const std::vector<VoxelBox> freed{{{150, 5, 9}, {155, 6, 10}}};
    state.close(0, 1, 2);
    state.reopen(blocks_reaching(blocks_of(freed, 2, {208, 25, 14}), {9, 6, 5}));
    for_each_pair(state, [&](int bx, int by, int bz) {
        const bool is_dead = bx == 0 && by == 1 && bz == 2;
        EXPECT_EQ(state.is_dead(bx, by, bz), is_dead);
        if (is_dead) return;
        ASSERT_TRUE(state.is_open(bx, by, bz));
        std::uint32_t reopened = 0;
        for (int j = 0; j < kBlocksY; ++j) {
            for (int x = 0; x < kPair * kBlocksX; ++x) {
                const VoxelIndex q{4 * (bx * kBlocksX + x), kBrickY * by + 4 * j, kBrickZ * bz};
                const VoxelBox reached{q - VoxelIndex{2, 2, 2}, q + VoxelIndex{3 + 9 + 2, 3 + 6 + 2, 3 + 5 + 2}};
                const bool reaches = !intersection(reached, freed.front()).empty() && q.x < 200 && q.y < 20;
                const std::uint32_t bit = state.is_reopened(bx, by, bz) ? state.reopened(bx, by, bz, j) >> x & 1 : 0;
                if (reaches) {
                    EXPECT_EQ(bit, 1u) << q.x << ' ' << q.y << ' ' << q.z;
                }
                reopened += bit;
                EXPECT_EQ(state.open_pair(bx, by, bz).bound[j][x] == kReopened, bit == 1);
            }
        }
        EXPECT_EQ(state.least_bound(bx, by, bz), reopened > 0 ? 0u : 5u);
    });
    EXPECT_TRUE(state.is_reopened(2, 0, 2));
    EXPECT_FALSE(state.is_reopened(0, 0, 0));
    // What was not admitted may be.
    state.note_refused({3, 2, 1});
    state.reopen(BitGrid({52, 7, 4}));
    EXPECT_TRUE(state.is_fresh(0, 0, 0));
    EXPECT_FALSE(state.is_fresh(2, 0, 0));
}

/// A tray that something small comes into, and what is kept of a shape in it.
class CacheInTheOpen : public testing::Test {
  protected:
    static constexpr std::uint32_t kBound = 7;

    CacheInTheOpen() : tray(test::box_tray({150, 80, 70})) {
        BitGrid solid({8, 6, 5});
        solid.fill(true);
        shape = {1, 0, {test::plain_shape(std::make_shared<const BitGrid>(std::move(solid)))}};
    }
    ShapeCache::Entry& follow(double penalty) {
        tables.follow(tray, 0, Workers(2));
        tables.raise(70, Workers(2));
        return cache.at(shape, tray, tables, {.height_penalty = penalty}, Workers(2));
    }
    /// Follows, bounds everything, adds a crumb in the middle and follows again.
    PositionState& state_after(double penalty = 4) {
        PositionState& before = follow(4).states.front();
        for_each_pair(before, [&](int bx, int by, int bz) {
            for (auto& row : before.open(bx, by, bz).bound) {
                std::ranges::fill(row, kBound);
            }
        });
        for (int z = 0; z < 70; ++z) {
            for (int y = 0; y < 80; ++y) {
                for (int x = 0; x < 150; ++x) {
                    phi.push_back(tables.phi().at(x, y, z));
                }
            }
        }
        const auto crumb = std::make_shared<BitGrid>(Extent{2, 2, 2});
        crumb->fill(true);
        tray.add({crumb, {70, 38, 34}});
        return follow(penalty).states.front();
    }
    /// Whether phi changed anywhere that the shape reaches from a block.
    bool changed(const VoxelIndex& block) const {
        for (int z = 4 * block.z; z < std::min(70, 4 * block.z + 8); ++z) {
            for (int y = 4 * block.y; y < std::min(80, 4 * block.y + 9); ++y) {
                for (int x = 4 * block.x; x < std::min(150, 4 * block.x + 11); ++x) {
                    if (phi[static_cast<std::size_t>((z * 80 + y) * 150 + x)] != tables.phi().at(x, y, z)) return true;
                }
            }
        }
        return false;
    }
    /// How many blocks' bounds are kept, none of which may be where phi changed.
    int kept(PositionState& state) {
        int count = 0;
        for_each_pair(state, [&](int bx, int by, int bz) {
            const OpenPair& pair = state.open_pair(bx, by, bz);
            for (int j = 0; j < kBlocksY; ++j) {
                for (int i = 0; i < kPair * kBlocksX; ++i) {
                    const VoxelIndex block{bx * kBlocksX + i, by * kBlocksY + j, bz};
                    if (pair.bound[j][i] == 0 || 4 * block.x >= state.count().x || 4 * block.y >= state.count().y)
                        continue;
                    ++count;
                    EXPECT_FALSE(changed(block)) << block.x << ' ' << block.y << ' ' << block.z;
                }
            }
        });
        return count;
    }
    Tray tray;
    Shape shape;
    TrayTables tables;
    ShapeCache cache{1'000'000'000};
    std::vector<int> phi;
};

TEST_F(CacheInTheOpen, KeepsBoundsWhereNothingChanged) { EXPECT_GT(kept(state_after()), 1000); }

TEST_F(CacheInTheOpen, KeepsWithinItsBudgetWhatItUsesAgainToo) {
    tables.follow(tray, 0, Workers(1));
    const std::int64_t room = PositionState::bytes_for(tray.candidates(shape.orientations.front().reach), true);
    for (const double entries : {0.5, 1.5, 2.9}) {
        const auto budget = static_cast<std::int64_t>(entries * 1.1 * static_cast<double>(room));
        ShapeCache small(budget);
        for (std::uint64_t id = 1; id < 6; ++id) {
            shape.id = id;
            EXPECT_EQ(small.at(shape, tray, tables, {}, Workers(1)).hits, 0);
            EXPECT_GE(small.bytes(), room) << entries << ", " << id;
            EXPECT_LE(small.bytes(), std::max(budget, room * 11 / 10)) << entries << ", " << id;
        }
        shape.id = 4;
        EXPECT_EQ(small.at(shape, tray, tables, {}, Workers(1)).hits, entries > 2 ? 1 : 0);
    }
}

TEST_F(CacheInTheOpen, KeepsNoBoundsForAnotherPenalty) { EXPECT_EQ(kept(state_after(5)), 0); }

}  // namespace
}  // namespace spectralpack
