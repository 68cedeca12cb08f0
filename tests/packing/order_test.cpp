#include "packing/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace spectralpack {
namespace {

const std::vector<PartSize> kParts{{0, 2, 10}, {1, 1, 30}, {2, 3, 10}, {3, 1, 20}};

TEST(Order, SizePutsLargestFirstAndBreaksTiesByInputThenCopy) {
    const std::vector<PackItem> expected{{1, 0}, {3, 0}, {0, 0}, {0, 1}, {2, 0}, {2, 1}, {2, 2}};
    EXPECT_EQ(order_items(kParts, Order::size, 0), expected);
}

TEST(Order, InputKeepsTheOrderGiven) {
    const std::vector<PackItem> expected{{0, 0}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {3, 0}};
    EXPECT_EQ(order_items(kParts, Order::input, 0), expected);
}

TEST(Order, RandomIsAPermutationThatOnlyTheSeedDecides) {
    const auto first = order_items(kParts, Order::random, 1);
    EXPECT_EQ(first, order_items(kParts, Order::random, 1));
    EXPECT_NE(first, order_items(kParts, Order::random, 2));
    const auto input = order_items(kParts, Order::input, 0);
    EXPECT_TRUE(std::is_permutation(first.begin(), first.end(), input.begin(), input.end()));
}

TEST(HeightPenalty, IsSmallOnlyWhereTheBoxesOverfillTheContainer) {
    // Boxes: 2 x 10 + 30 + 3 x 10 + 20 = 100; the paper's threshold is 1.2.
    EXPECT_EQ(automatic_height_penalty(kParts, 100.0 / 1.2 + 0.1), 1e8);
    EXPECT_EQ(automatic_height_penalty(kParts, 100.0 / 1.2 - 0.1), 4);
}

}  // namespace
}  // namespace spectralpack
