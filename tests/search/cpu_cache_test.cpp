// What the fast engine keeps from search to search.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/random.hpp"
#include "core/zeroed.hpp"
#include "search/cpu/incumbent.hpp"
#include "search/cpu/position_cache.hpp"

namespace spectralpack {
namespace {

Placed placed(double cost, int x) { return {.cost = {cost, 0}, .index = 0, .position = {x, 0, 0}}; }

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
        const std::vector<Placed> beaten = incumbent.beaten();
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

/// One orientation's state with some pairs opened.
class OpenState : public testing::Test {
  protected:
    static constexpr Extent kCount{200, 20, 10};

    void SetUp() override {
        state.reset(kCount, kCount, true);
        for (int bz = 0; bz < state.bricks().z; ++bz) {
            for (int by = 0; by < state.bricks().y; ++by) {
                for (int bx = 0; bx < state.bricks().x; bx += kPair) {
                    OpenPair& pair = state.open(bx, by, bz);
                    for (auto& words : pair.live) {
                        std::ranges::fill(words, 0);
                    }
                    for (auto& row : pair.bound) {
                        std::ranges::fill(row, 7u);
                    }
                    pair.bound[0][1] = kDead;
                    state.set_least_bound(bx, by, bz, 5);
                }
            }
        }
    }
    PositionState state;
};

TEST_F(OpenState, FindsLayersInWhichNothingIsLive) {
    state.open_pair(2, 1, 1).live[1][kBrickY * 2 + 5] = 1;
    state.open_pair(0, 0, 2).live[0][0] = 1;
    EXPECT_EQ(state.dead_layers(1), 0);
    state.look_for_dead_layers(1);
    EXPECT_EQ(state.dead_layers(1), 0b1011);
    EXPECT_EQ(state.dead_layers(0), 0);
    EXPECT_EQ(state.dead_layers(2), 0);
    PositionState fresh;
    fresh.reset(kCount, kCount, true);
    fresh.look_for_dead_layers(0);  // where nobody has looked anything may be live
    EXPECT_EQ(fresh.dead_layers(0), 0);
}

TEST_F(OpenState, ForgetsWhatAChangeOfPhiMayHaveMadeWrong) {
    // A row of pairs that are fresh, open and dead by turns, with bounds on each.
    PositionState row;
    const Extent count{6 * 128, 8, 4};
    row.reset(count, count, true);
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
    row.forget({{0, 3, 2}, {128 * 3 + 1, 4, 3}}, {10, 3, 3});
    for (int i = 0; i < 6; ++i) {
        const bool touched = i <= 3;
        EXPECT_EQ(row.least_bound(kPair * i, 0, 0), i % 3 == 2 ? kDead : touched ? 0 : 7) << i;
        if (!row.is_open(kPair * i, 0, 0)) continue;
        EXPECT_EQ(row.open_pair(kPair * i, 0, 0).bound[0][5], touched ? 0 : 7) << i;
    }
}

}  // namespace
}  // namespace spectralpack
