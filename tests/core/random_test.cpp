#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace spectralpack {
namespace {

TEST(RandomStream, IsSplitMix64) {
    // The first outputs for seed 1234567 in the reference implementation by Vigna.
    RandomStream random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317u);
    EXPECT_EQ(random.next(), 3203168211198807973u);
}

TEST(RandomStream, BelowIsInRangeAndReachesAll) {
    RandomStream random(1);
    std::array<int, 7> seen{};
    for (int i = 0; i < 7000; ++i) {
        ++seen.at(random.below(7));
    }
    for (const int count : seen) {
        EXPECT_GT(count, 800);  // 1000 expected; 7 standard deviations below
    }
}

TEST(RandomStream, UnitIsInZeroToOne) {
    RandomStream random(2);
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double value = random.unit();
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        sum += value;
    }
    EXPECT_NEAR(sum / 10000, 0.5, 0.02);
}

TEST(Shuffle, KeepsTheItems) {
    std::vector<int> items(50);
    std::iota(items.begin(), items.end(), 0);
    const std::vector<int> sorted = items;
    RandomStream random(3);
    shuffle(items, random);
    EXPECT_NE(items, sorted);
    EXPECT_TRUE(std::is_permutation(items.begin(), items.end(), sorted.begin(), sorted.end()));
}

}  // namespace
}  // namespace spectralpack
