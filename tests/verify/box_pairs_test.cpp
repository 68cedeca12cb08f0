#include "verify/box_pairs.hpp"

#include <gtest/gtest.h>

#include <set>

#include "scenes.hpp"

namespace spectralpack::test {
namespace {

TEST(BoxPairs, AreThoseOfAllPairs) {
    RandomStream random(1);
    for (int round = 0; round < 40; ++round) {
        std::vector<Box> boxes;
        for (std::uint64_t i = 0, count = random.below(60); i < count; ++i) {
            const Vec3 low{between(random, 0, 30), between(random, 0, 90), between(random, 0, 20)};
            Box box{low, low + Vec3{between(random, 0, 9), between(random, 0, 9), between(random, 0, 9)}};
            if (round % 2 == 0) {
                for (int axis = 0; axis < 3; ++axis) {
                    box.min[axis] = std::round(box.min[axis]);
                    box.max[axis] = std::round(box.max[axis]);
                }
            }
            boxes.push_back(box);
        }
        const double limits[][2] = {{-1, 0}, {-1, 3}, {0, 2}, {2, 1e9}};
        for (const auto& [from, to] : limits) {
            std::set<std::pair<int, int>> expected, found;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                for (std::size_t j = i + 1; j < boxes.size(); ++j) {
                    const double d = distance(boxes[i], boxes[j]);
                    if (d > from && d <= to) expected.insert({int(i), int(j)});
                }
            }
            const std::vector<BoxPair> pairs = near_pairs(boxes, from, to);
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                found.insert({pairs[k].a, pairs[k].b});
                EXPECT_EQ(pairs[k].distance, distance(boxes[pairs[k].a], boxes[pairs[k].b]));
                EXPECT_LE(pairs[k > 0 ? k - 1 : 0].distance, pairs[k].distance);
            }
            EXPECT_EQ(found, expected);
            EXPECT_EQ(pairs.size(), expected.size());
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
