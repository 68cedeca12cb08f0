#include "packing/order/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace spectralpack {
namespace {

const std::vector<PartSize> kParts{{0, 2, 10}, {1, 1, 30}, {2, 3, 10}, {3, 1, 20}};

TEST(Order, SizePutsLargestFirstAndBreaksTiesByInputThenCopy) {
    const std::vector<Copy> expected{{1, 0}, {3, 0}, {0, 0}, {0, 1}, {2, 0}, {2, 1}, {2, 2}};
    EXPECT_EQ(order_copies(kParts, Order::size, 0), expected);
}

TEST(Order, InputKeepsTheOrderGiven) {
    const std::vector<Copy> expected{{0, 0}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {3, 0}};
    EXPECT_EQ(order_copies(kParts, Order::input, 0), expected);
}

TEST(Order, RandomIsAPermutationThatOnlyTheSeedDecides) {
    const auto first = order_copies(kParts, Order::random, 1);
    EXPECT_EQ(first, order_copies(kParts, Order::random, 1));
    EXPECT_NE(first, order_copies(kParts, Order::random, 2));
    const auto input = order_copies(kParts, Order::input, 0);
    EXPECT_TRUE(std::is_permutation(first.begin(), first.end(), input.begin(), input.end()));
}

TEST(Order, PriorityThenDueDateComeBeforeSize) {
    std::vector<PartSize> parts{{0, 1, 10},
                                {1, 1, 30},
                                {2, 1, 20, 0, "2026-12-01"},
                                {3, 1, 5, 0, "2026-11-30"},
                                {4, 1, 1, 2},
                                {5, 1, 50, -1, "2020-01-01"}};
    const std::vector<Copy> expected{{4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}, {5, 0}};
    EXPECT_EQ(order_copies(parts, Order::size, 0), expected);
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const auto copies = order_copies(parts, Order::random, seed);
        EXPECT_TRUE(std::equal(copies.begin(), copies.begin() + 3, expected.begin()));
        EXPECT_EQ(copies.back(), expected.back());
    }
}

TEST(Order, VolumeAndMixedPutTheDenserFirst) {
    // Boxes 10, 30, 10, 20; solid volumes 9, 2, 1, 8; geometric means 9.5, 7.7, 3.2, 12.6.
    const std::vector<PartSize> parts{
        {0, 1, 10, 0, "", 9}, {1, 1, 30, 0, "", 2}, {2, 2, 10, 0, "", 1}, {3, 1, 20, 0, "", 8}};
    EXPECT_EQ(order_copies(parts, Order::volume, 0), (std::vector<Copy>{{0, 0}, {3, 0}, {1, 0}, {2, 0}, {2, 1}}));
    EXPECT_EQ(order_copies(parts, Order::mixed, 0), (std::vector<Copy>{{3, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 1}}));
}

TEST(Order, RanksAreThoseOfPriorityAndDueDate) {
    const std::vector<PartSize> parts{{0, 1, 10}, {1, 1, 30}, {3, 1, 20, 0, "2026-12-01"}, {4, 1, 5, 2}, {5, 1, 1, 2}};
    EXPECT_EQ(urgency_ranks(parts), (std::vector<int>{2, 2, 0, 1, 0, 0}));
}

TEST(Order, PerturbedGoesNotFarAndPassesNoOtherRank) {
    std::vector<Copy> copies;
    std::vector<int> ranks;
    for (int part = 0; part < 100; ++part) {
        copies.push_back({part, 0});
        ranks.push_back(part < 30 ? 0 : 1);
    }
    RandomStream random(7), again(7);
    const auto other = perturbed(copies, ranks, random);
    EXPECT_EQ(other, perturbed(copies, ranks, again));
    EXPECT_NE(other, perturbed(copies, ranks, random));
    EXPECT_NE(other, copies);
    EXPECT_TRUE(std::is_permutation(other.begin(), other.end(), copies.begin(), copies.end()));
    for (int i = 0; i < 100; ++i) {
        EXPECT_LE(std::abs(other[static_cast<std::size_t>(i)].part - i), 20);
        EXPECT_EQ(other[static_cast<std::size_t>(i)].part < 30, i < 30);
    }
}

TEST(HeightPenalty, IsSmallOnlyWhereTheBoxesOverfillTheContainer) {
    // Boxes: 2 x 10 + 30 + 3 x 10 + 20 = 100; the paper's threshold is 1.2.
    EXPECT_EQ(automatic_height_penalty(kParts, 100.0 / 1.2 + 0.1), 1e8);
    EXPECT_EQ(automatic_height_penalty(kParts, 100.0 / 1.2 - 0.1), 4);
}

TEST(Order, ServesTheGoal) {
    const std::vector<PartSize> parts{{.part = 0, .count = 1, .box_volume = 100, .volume = 10, .value = 1},
                                      {.part = 1, .count = 1, .box_volume = 50, .volume = 40, .value = 30},
                                      {.part = 2, .count = 2, .box_volume = 10, .volume = 9, .value = 4},
                                      {
                                          .part = 3,
                                          .count = 1,
                                          .box_volume = 20,
                                          .volume = 8,
                                          .value = 0,
                                      }};
    const auto order = [&](Goal goal) {
        std::vector<int> by_part;
        for (const Copy& copy : order_copies(parts, goal)) {
            by_part.push_back(copy.part);
        }
        return by_part;
    };
    EXPECT_EQ(order(Goal::fair), (std::vector<int>{0, 1, 3, 2, 2}));
    EXPECT_EQ(order(Goal::volume), (std::vector<int>{1, 0, 2, 2, 3}));
    EXPECT_EQ(order(Goal::copies), (std::vector<int>{2, 2, 3, 1, 0}));
    EXPECT_EQ(order(Goal::value), (std::vector<int>{1, 2, 2, 0, 3}));
    std::vector<PartSize> urgent = parts;
    urgent[3].priority = 1;
    EXPECT_EQ(order_copies(urgent, Goal::volume).front().part, 3);
}

}  // namespace
}  // namespace spectralpack
