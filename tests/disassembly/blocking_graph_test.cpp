#include "disassembly/graph/blocking_graph.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace spectralpack {
namespace {

using Groups = std::vector<std::vector<std::size_t>>;

TEST(BlockingGraph, ServesBothWaysAlongAnAxis) {
    BlockingGraph graph(3);
    graph.add(0, {2, 1}, 1);
    graph.add(0, {2, 1}, 1);  // known already
    graph.add(2, {2, -1}, 0);
    EXPECT_EQ(graph.blockers(0, {2, 1}), 2);
    EXPECT_EQ(graph.blockers(1, {2, -1}), 1);
    EXPECT_EQ(graph.blockers(2, {2, -1}), 1);
    EXPECT_EQ(graph.blockers(0, {2, -1}), 0);
    EXPECT_EQ(graph.blockers(0, {0, 1}), 0);
    graph.remove(1);
    EXPECT_EQ(graph.blockers(0, {2, 1}), 1);
}

TEST(BlockingGraph, KnowsWhoPassesWhomBothWays) {
    BlockingGraph graph(3);
    graph.add_passed(0, {1, 1}, 2);
    graph.add_passed(1, {1, -1}, 0);
    EXPECT_TRUE(graph.passed(0, {1, 1}, 2));
    EXPECT_TRUE(graph.passed(2, {1, -1}, 0));
    EXPECT_TRUE(graph.passed(0, {1, 1}, 1));
    EXPECT_FALSE(graph.passed(0, {1, -1}, 2));
    EXPECT_FALSE(graph.passed(2, {1, 1}, 0));
    EXPECT_FALSE(graph.passed(0, {2, 1}, 2));
    EXPECT_EQ(graph.blockers(0, {1, 1}), 0);
}

TEST(BlockingGraph, WhoLeavesIsInNobodysWay) {
    BlockingGraph graph(130);
    const AxisDirection up{2, 1}, down{2, -1};
    for (std::size_t i = 0; i < 129; ++i) {
        graph.add(i, up, 129);
        graph.add(129, {0, -1}, i);
    }
    graph.remove(129);
    for (std::size_t i = 0; i < 129; ++i) {
        ASSERT_EQ(graph.blockers(i, up), 0);
        ASSERT_EQ(graph.blockers(i, {0, 1}), 0);
    }
    EXPECT_EQ(graph.blockers(129, down), 0);
}

TEST(BlockingGraph, GroupsAreTheComponentsThatNothingHolds) {
    BlockingGraph graph(7);
    const AxisDirection up{2, 1}, down{2, -1};
    // 0 <-> 1 under 2 <-> 3 -> 4; 5 <-> 6 apart.
    graph.add(0, up, 1), graph.add(1, up, 0);
    graph.add(2, up, 3), graph.add(3, up, 2);
    graph.add(0, up, 2), graph.add(3, up, 4);
    graph.add(5, up, 6), graph.add(6, up, 5);
    EXPECT_EQ(graph.groups(up), (Groups{{5, 6}}));
    EXPECT_EQ(graph.groups(down), (Groups{{0, 1}, {5, 6}}));
    graph.remove(4);
    EXPECT_EQ(graph.groups(up), (Groups{{2, 3}, {5, 6}}));
    EXPECT_EQ(graph.groups({0, 1}), Groups{});
}

TEST(BlockingGraph, GroupsAgreeWithReachability) {
    RandomStream random(7);
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 2 + random.below(9);
        BlockingGraph graph(n);
        std::vector<std::vector<bool>> reach(n, std::vector<bool>(n, false));
        for (std::uint64_t k = random.below(3 * n); k > 0; --k) {
            const std::size_t a = random.below(n), b = random.below(n);
            if (a == b) continue;
            graph.add(a, {1, 1}, b);
            reach[a][b] = true;
        }
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t j = 0; j < n; ++j) {
                    if (reach[i][k] && reach[k][j]) reach[i][j] = true;
                }
            }
        }
        const std::vector<bool> behind = graph.behind({0}, {1, 1});
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_EQ(behind[i], i == 0 || reach[i][0]);
        }
        Groups expected;
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<std::size_t> members;
            bool closed = true;
            for (std::size_t j = 0; j < n; ++j) {
                if (j == i || (reach[i][j] && reach[j][i])) members.push_back(j);
                if (j != i && reach[i][j] && !reach[j][i]) closed = false;
            }
            if (closed && members.size() > 1 && members.size() < n && members.front() == i) expected.push_back(members);
        }
        std::stable_sort(expected.begin(), expected.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
        EXPECT_EQ(graph.groups({1, 1}), expected);
    }
}

TEST(BlockingGraph, KeepsAmongSomeWhatItKnowsOfThem) {
    const AxisDirection up{2, 1}, left{0, -1};
    BlockingGraph graph(5);
    graph.add(1, up, 4);
    graph.add(4, left, 3);
    graph.add(2, up, 1);
    graph.add_passed(3, left, 1);
    graph.add_passed(0, up, 1);
    const BlockingGraph some = graph.among({1, 3, 4});
    ASSERT_EQ(some.count(), 3u);
    EXPECT_EQ(some.blockers(0, up), 1);
    EXPECT_EQ(some.blockers(0, {2, -1}), 0) << "2 is not among them";
    EXPECT_EQ(some.blockers(2, left), 1);
    EXPECT_EQ(some.blockers(1, {0, 1}), 1);
    EXPECT_TRUE(some.passed(1, left, 0));
    EXPECT_TRUE(some.passed(0, {0, 1}, 1));
    EXPECT_FALSE(some.passed(2, left, 0));
}

}  // namespace
}  // namespace spectralpack
