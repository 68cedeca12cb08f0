#include "packing/tray/greedy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "packing/first_fit.hpp"

namespace spectralpack {
namespace {

using test::box_shape;
using test::FirstFit;

class Greedy : public testing::Test {
  protected:
    Greedy() : tray_(TraySetup{{4, 4, 2}, 1, 1, {0}, Ceiling::closed, 0, {}, false}) {}

    void pack(const std::vector<Copy>& copies) {
        ShapeStore shapes(
            [](int part, const Workers&) { return box_shape(static_cast<std::uint64_t>(part), part == 0 ? 2 : 3); },
            Workers(2));
        shapes.start_tray(copies);
        const Settle settle = [](const Copy&, const Shape& shape, const BestPlacement& best) {
            return settle_on_grid(shape, best, 1, 1, 0);
        };
        pack_greedily(
            tray_, {{search_, shapes, Workers(2), stop_.token()}, 0, {}, {}, settle}, copies,
            [&](std::size_t) { ++done_; }, result_);
    }

    Tray tray_;
    FirstFit search_;
    StopSource stop_;
    GreedyResult result_;
    int done_ = 0;
};

TEST_F(Greedy, PlacesInOrderAndSkipsCopiesOfAPartThatFoundNoPlace) {
    // Four cubes of 2 fill the 4 x 4 x 2 tray; a cube of 3 never fits.
    pack({{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});
    ASSERT_EQ(result_.placed.size(), 4u);
    EXPECT_EQ(result_.placed[1].copy, (Copy{0, 1}));
    EXPECT_EQ(result_.placed[1].position, (VoxelIndex{2, 0, 0}));
    const std::vector<Copy> left{{1, 0}, {1, 1}, {0, 4}, {0, 5}};
    EXPECT_EQ(result_.left_over, left);
    EXPECT_EQ(result_.searches, 6);  // (1, 1) and (0, 5) are not searched for
    EXPECT_EQ(search_.asked, 6);
    EXPECT_EQ(done_, 8);
    EXPECT_EQ(tray_.occupied(0).count(), 32);
}

TEST_F(Greedy, SharesAreKeptAsLongAsBothPartsFindAPlace) {
    tray_ = Tray(TraySetup{{6, 6, 6}, 1, 1, {0}, Ceiling::closed, 0, {}, false});
    const std::vector<PartShare> shares{{1, 1}, {0, 2}};  // cubes of 3 and of 2, 1 : 2
    const std::vector<Copy> copies{{1, 0}, {0, 0}};
    ShapeStore shapes(
        [](int part, const Workers&) { return box_shape(static_cast<std::uint64_t>(part), part == 0 ? 2 : 3); },
        Workers(2));
    shapes.start_tray(copies);
    const Settle settle = [](const Copy&, const Shape& shape, const BestPlacement& best) {
        return settle_on_grid(shape, best, 1, 1, 0);
    };
    pack_in_shares(
        tray_, {{search_, shapes, Workers(2), stop_.token()}, 0, {}, {}, settle}, shares, {},
        [&](std::size_t) { ++done_; }, result_);
    // 0 lacks more at first (2 of 3), then both lack as much and 1 comes first.
    ASSERT_GE(result_.placed.size(), 6u);
    std::vector<int> parts;
    int counts[2] = {};
    for (const PlacedCopy& placed : result_.placed) {
        parts.push_back(placed.copy.part);
        EXPECT_EQ(placed.copy.number, counts[placed.copy.part]++);
    }
    EXPECT_EQ((std::vector<int>(parts.begin(), parts.begin() + 6)), (std::vector<int>{0, 1, 0, 0, 1, 0}));
    EXPECT_TRUE(result_.left_over.empty());
    // Nothing more of either fits.
    EXPECT_FALSE(search_.best_placement(tray_, *box_shape(0, 2), {}, {}).best);
}

TEST_F(Greedy, AStopLeavesTheRestUntried) {
    stop_.request(StopReason::cancelled);
    pack({{0, 0}, {0, 1}});
    EXPECT_TRUE(result_.placed.empty());
    EXPECT_EQ(result_.untried.size(), 2u);
}

TEST_F(Greedy, WhatWasPlacedSurvivesAnException) {
    search_.fail_at = 3;
    EXPECT_THROW(pack({{0, 0}, {0, 1}, {0, 2}, {0, 3}}), std::runtime_error);
    EXPECT_EQ(result_.placed.size(), 2u);
}

}  // namespace
}  // namespace spectralpack
