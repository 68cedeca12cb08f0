#include "geometry/box_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace spectralpack {
namespace {

TEST(BoxIndex, FindsEveryBoxThatMeetsAlsoOutsideTheRegionAndAfterRemovals) {
    RandomStream random(1);
    const auto box = [&] {
        const Vec3 low{60 * random.unit() - 10, 40 * random.unit() - 10, 30 * random.unit() - 10};
        return Box{low, low + Vec3{9 * random.unit(), 9 * random.unit(), 9 * random.unit()}};
    };
    BoxIndex index({{0, 0, 0}, {40, 20, 10}});
    std::vector<Box> boxes;
    for (int i = 0; i < 200; ++i) {
        boxes.push_back(box());
        index.add(i, boxes.back());
    }
    for (int i = 0; i < 200; i += 3) {
        index.remove(i, boxes[static_cast<std::size_t>(i)]);
    }
    std::size_t found = 0;
    for (int query = 0; query < 300; ++query) {
        const Box around = box();
        const std::vector<std::int64_t> near = index.near(around);
        found += near.size();
        EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
        EXPECT_EQ(std::adjacent_find(near.begin(), near.end()), near.end());
        for (int i = 0; i < 200; ++i) {
            const bool there = std::binary_search(near.begin(), near.end(), i);
            if (i % 3 == 0) {
                EXPECT_FALSE(there);
            } else if (meet(around, boxes[static_cast<std::size_t>(i)])) {
                EXPECT_TRUE(there);
            }
        }
    }
    EXPECT_LT(found, 300u * 130u / 2);  // it does leave out most of what is far
}

TEST(BoxIndex, OfAFlatRegionHasCells) {
    BoxIndex index({{0, 0, 0}, {10, 0, 0}});
    index.add(7, {{1, 0, 0}, {2, 0, 0}});
    EXPECT_EQ(index.near({{0, 0, 0}, {1.5, 0, 0}}), std::vector<std::int64_t>{7});
    EXPECT_TRUE(index.near(Box{}).empty());
}

}  // namespace
}  // namespace spectralpack
