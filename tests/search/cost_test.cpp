#include "search/cost.hpp"

#include <gtest/gtest.h>

namespace spectralpack {
namespace {

TEST(Cost, AddsTheCubicHeightPenalty) {
    const CostModel model{8, HeightAt::bottom};
    EXPECT_EQ(cost_of(model, 0, 3, 10, 5), (Cost{5, 0}));
    EXPECT_EQ(cost_of(model, 5, 3, 10, 5), (Cost{6, 0}));    // 8 (1/2)^3
    EXPECT_EQ(cost_of(model, -5, 3, 10, 5), (Cost{4, 0}));   // below the floor the cube goes on
    EXPECT_EQ(cost_of(model, 20, 3, 10, 5), (Cost{69, 0}));  // above the reference height as well
}

TEST(Cost, IgnoresThePenaltyAtTheTop) {
    const CostModel model{1e8, HeightAt::top};
    EXPECT_EQ(cost_of(model, 5, 3, 10, 7), (Cost{8, 7}));
    EXPECT_LT(cost_of(model, 5, 3, 10, 7), cost_of(model, 6, 3, 10, 0));
    EXPECT_LT(cost_of(model, 5, 3, 10, 6), cost_of(model, 5, 3, 10, 7));
}

TEST(Cost, IsTheTableOfTheDefinition) {
    const CostModel model{1e8, HeightAt::bottom};
    for (int z = 0; z < 101; ++z) {
        const double t = static_cast<double>(z) / 101;
        EXPECT_EQ(height_penalty_at(model, z, 101), 1e8 * t * t * t);
    }
}

}  // namespace
}  // namespace spectralpack
