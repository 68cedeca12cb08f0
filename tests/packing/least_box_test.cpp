#include "packing/job/least_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace spectralpack {
namespace {

TEST(LeastBox, ComesToTheLeastOfASmoothValley) {
    for (const BaseSize& best : {BaseSize{40, 40}, BaseSize{70, 33}, BaseSize{21, 52}}) {
        std::set<BaseSize> tried;
        BaseSize found;
        double least = 1e300;
        search_bases(40, {1, 1}, {100, 100}, [&](const BaseSize& base) -> std::optional<BoxScore> {
            EXPECT_TRUE(tried.insert(base).second) << "tried twice";
            const double volume = 1000 + std::pow(base.x - best.x, 2) + std::pow(base.y - best.y, 2);
            if (volume < least) {
                least = volume;
                found = base;
            }
            return BoxScore{0, volume};
        });
        EXPECT_EQ(found, best);
        EXPECT_LT(tried.size(), 80u);
    }
}

TEST(LeastBox, StaysWithinTheLimitsAndPrefersBasesThatHoldAll) {
    BaseSize found;
    BoxScore least{1000, 0};
    search_bases(40, {5, 5}, {50, 20}, [&](const BaseSize& base) -> std::optional<BoxScore> {
        EXPECT_GE(std::min(base.x, base.y), 5);
        EXPECT_LE(base.x, 50);
        EXPECT_LE(base.y, 20);
        const BoxScore score{base.x < 48 ? 1 : 0, static_cast<double>(base.x * base.y)};
        if (score < least) {
            least = score;
            found = base;
        }
        return score;
    });
    EXPECT_EQ(least.left_over, 0);
    EXPECT_EQ(found.x, 48);
}

TEST(LeastBox, EndsWhenItIsStopped) {
    int calls = 0;
    search_bases(40, {1, 1}, {100, 100}, [&](const BaseSize&) -> std::optional<BoxScore> {
        return ++calls < 3 ? std::optional(BoxScore{0, 1.0}) : std::nullopt;
    });
    EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace spectralpack
