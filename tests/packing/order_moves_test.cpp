#include "packing/improve/order_moves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace spectralpack {
namespace {

std::vector<Copy> copies_of(const std::vector<int>& parts) {
    std::vector<Copy> copies;
    std::map<int, int> next;
    for (const int part : parts) {
        copies.push_back({part, next[part]++});
    }
    return copies;
}

OrderMoves any_moves() {
    return {[](std::size_t place) { return static_cast<double>(place); }, 3,
            [](const Copy&, const Copy&) { return true; }};
}

TEST(OrderMoves, KeepTheCopiesAndTheirNumbers) {
    const std::vector<Copy> order = copies_of({0, 1, 0, 2, 2, 3, 0, 1, 4});
    RandomStream random(3);
    int changed = 0;
    for (int i = 0; i < 300; ++i) {
        const std::vector<Copy> moved = moved_order(order, any_moves(), random);
        ASSERT_EQ(std::set<Copy>(moved.begin(), moved.end()), std::set<Copy>(order.begin(), order.end()));
        std::map<int, int> next;
        for (const Copy& copy : moved) {
            ASSERT_EQ(copy.number, next[copy.part]++) << "copies of a part are out of turn";
        }
        changed += moved != order ? 1 : 0;
    }
    EXPECT_GT(changed, 200);
}

TEST(OrderMoves, TakeNoCopyPastAnotherThatItMayNotPass) {
    std::vector<int> parts(40);
    for (int i = 0; i < 40; ++i) {
        parts[static_cast<std::size_t>(i)] = i;
    }
    const std::vector<Copy> order = copies_of(parts);
    OrderMoves moves = any_moves();
    moves.may_pass = [](const Copy& a, const Copy& b) { return a.part / 10 == b.part / 10; };
    RandomStream random(5);
    int changed = 0;
    for (int i = 0; i < 300; ++i) {
        const std::vector<Copy> moved = moved_order(order, moves, random);
        for (std::size_t k = 0; k < moved.size(); ++k) {
            ASSERT_EQ(moved[k].part / 10, static_cast<int>(k) / 10);
        }
        changed += moved != order ? 1 : 0;
    }
    EXPECT_GT(changed, 200);
}

TEST(OrderMoves, PreferTheCopyThatUrgesMost) {
    const std::vector<Copy> order = copies_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    OrderMoves moves = any_moves();
    moves.noise = 0;
    moves.urge = [](std::size_t place) { return place == 7 ? 1.0 : 0.0; };
    RandomStream random(7);
    int earlier = 0;
    for (int i = 0; i < 200; ++i) {
        const std::vector<Copy> moved = moved_order(order, moves, random);
        earlier += std::ranges::find(moved, Copy{7, 0}) - moved.begin() < 7 ? 1 : 0;
    }
    EXPECT_GT(earlier, 100);
}

TEST(OrderMoves, OfOneCopyThereIsOneOrder) {
    RandomStream random(1);
    EXPECT_EQ(moved_order({{0, 0}}, any_moves(), random), (std::vector<Copy>{{0, 0}}));
    EXPECT_TRUE(moved_order({}, any_moves(), random).empty());
}

}  // namespace
}  // namespace spectralpack
