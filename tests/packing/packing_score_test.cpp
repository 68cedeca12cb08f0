#include "packing/order/packing_score.hpp"

#include <gtest/gtest.h>

namespace spectralpack {
namespace {

PlacedCopy at(int part, int copy, double z) {
    PlacedCopy placed;
    placed.copy = {part, copy};
    placed.offset.z = z;
    return placed;
}

const PackingMeasures kMeasures{[](int part) { return part == 0 ? 10.0 : 0.1; },
                                [](const PlacedCopy& placed) { return placed.offset.z + 1; }};
const std::vector<Copy> kItems{{0, 0}, {1, 0}, {1, 1}, {1, 2}};

using Placed = std::vector<PlacedCopy>;

TEST(PackingScore, MatterPlacedComesBeforeTraysAndHeight) {
    const Placed all{at(0, 0, 0), at(1, 0, 1), at(1, 1, 2), at(1, 2, 3)}, low{at(0, 0, 0), at(1, 0, 0)},
        small{at(1, 0, 0), at(1, 1, 0), at(1, 2, 0)};
    const PackingScore whole = score_packing(kItems, {&all}, kMeasures);
    EXPECT_EQ(whole.copies, 0);
    EXPECT_EQ(whole.left_over, 0);
    EXPECT_EQ(whole.top, 4);
    EXPECT_LT(whole, score_packing(kItems, {&low}, kMeasures));
    EXPECT_LT(score_packing(kItems, {&low}, kMeasures), score_packing(kItems, {&small}, kMeasures))
        << "one large copy is more than three small ones";
}

TEST(PackingScore, WhereAllIsPlacedFewerTraysWinThenTheLowerLast) {
    const Placed one{at(0, 0, 5), at(1, 0, 1), at(1, 1, 2), at(1, 2, 3)}, first{at(0, 0, 9)},
        rest{at(1, 2, 1), at(1, 1, 1), at(1, 0, 1)}, lower{at(1, 2, 0), at(1, 1, 0), at(1, 0, 0)};
    EXPECT_LT(score_packing(kItems, {&one}, kMeasures), score_packing(kItems, {&first, &lower}, kMeasures));
    EXPECT_LT(score_packing(kItems, {&first, &lower}, kMeasures), score_packing(kItems, {&first, &rest}, kMeasures));
}

TEST(PackingScore, DoesNotDependOnTheOrderOfPlacing) {
    const Placed one{at(1, 0, 1), at(1, 2, 3)}, other{at(1, 2, 3), at(1, 1, 1)};
    EXPECT_EQ(score_packing(kItems, {&one}, kMeasures), score_packing(kItems, {&other}, kMeasures));
}

}  // namespace
}  // namespace spectralpack
