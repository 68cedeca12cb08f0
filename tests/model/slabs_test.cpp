#include "model/slabs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "core/random.hpp"

namespace spectralpack {
namespace {

Box between(double low, double high) { return {{0, 0, low}, {10, 10, high}}; }

std::vector<std::pair<double, double>> heights(const std::vector<Slab>& slabs) {
    std::vector<std::pair<double, double>> result;
    for (const Slab& slab : slabs) {
        result.emplace_back(slab.high, slab.low);
    }
    return result;
}

TEST(Slabs, AreAboutFiftyMillimetresCutOnFive) {
    std::vector<Box> boxes;
    for (double low = 0; low < 290; low += 10) {
        boxes.push_back(between(low, low + 10));
    }
    boxes.push_back(between(284, 294));
    using Heights = std::vector<std::pair<double, double>>;
    EXPECT_EQ(heights(slabs_of(boxes)), (Heights{{294, 245}, {245, 195}, {195, 145}, {145, 100}, {100, 50}, {50, 0}}));
    EXPECT_EQ(heights(slabs_of({between(0, 12)})), (Heights{{12, 0}}));
    EXPECT_TRUE(slabs_of({}).empty());
}

TEST(Slabs, ThoseWithNothingToTakeAreJoinedToTheNext) {
    using Heights = std::vector<std::pair<double, double>>;
    // Two high copies in the middle of the upper half, others below 45 mm.
    EXPECT_EQ(heights(slabs_of({between(50, 236.8), between(52, 236), between(60, 90), between(0, 40)})),
              (Heights{{236.8, 140}, {140, 45}, {45, 0}}));
}

TEST(Slabs, HoldEveryCopyOnceAndMeet) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        std::vector<Box> boxes;
        for (std::uint64_t i = 0; i < 1 + random.below(30); ++i) {
            const double low = 400 * random.unit();
            boxes.push_back(between(low, low + 1 + 200 * random.unit()));
        }
        const std::vector<Slab> slabs = slabs_of(boxes);
        RC_ASSERT(slabs.size() >= 1 && slabs.size() <= 6);
        std::vector<int> all;
        for (std::size_t i = 0; i < slabs.size(); ++i) {
            RC_ASSERT(slabs[i].low < slabs[i].high);
            RC_ASSERT(!slabs[i].placements.empty());
            if (i > 0) RC_ASSERT(slabs[i].high == slabs[i - 1].low);
            all.insert(all.end(), slabs[i].placements.begin(), slabs[i].placements.end());
        }
        RC_ASSERT(slabs.back().low == 0);
        std::sort(all.begin(), all.end());
        RC_ASSERT(all.size() == boxes.size());
        RC_ASSERT(std::adjacent_find(all.begin(), all.end()) == all.end());
    }));
}

}  // namespace
}  // namespace spectralpack
