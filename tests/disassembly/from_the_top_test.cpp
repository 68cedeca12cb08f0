/// Taking a tray apart from the top, between walls that give way where nothing else goes.

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"
#include "disassembly/unpacking.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::placed;

/// A box open at the top, 2 mm thick, whose room is from (2, 2, 2) to (42, 42, 42).
Mesh crate() {
    Mesh mesh = box_mesh({0, 0, 0}, {44, 44, 2});
    mesh = test::merged(mesh, box_mesh({0, 0, 0}, {2, 44, 42}));
    mesh = test::merged(mesh, box_mesh({42, 0, 0}, {44, 44, 42}));
    mesh = test::merged(mesh, box_mesh({0, 0, 0}, {44, 2, 42}));
    return test::merged(mesh, box_mesh({0, 42, 0}, {44, 44, 42}));
}

struct Crate : AssemblyScene {
    explicit Crate(double voxel = 2) : AssemblyScene({44, 44, 44}, voxel) {}

    std::size_t walls() const { return parts().size() - 1; }
    Answer from_the_top(const std::vector<RemovalStep>* told = nullptr) const {
        return disassemble(Disassembler::Rules{.told = told, .unpack = Unpack::top, .walls = walls()});
    }
    /// The steps without walls.
    Answer by_any_way() const {
        std::vector<Body> copies(parts().begin(), parts().end() - 1);
        Disassembler disassembler(setup(), copies, [](int, int) {});
        disassembler.run();
        return {disassembler.steps(), disassembler.stuck(), disassembler.counts()};
    }
};

TEST(FromTheTop, TakesTheUppermostFirst) {
    Crate crate_with;
    const int low = crate_with.add(box_mesh({4, 4, 2}, {12, 12, 10}));
    const int high = crate_with.add(box_mesh({20, 4, 2}, {28, 12, 40}));
    const int middle = crate_with.add(box_mesh({4, 4, 14}, {12, 12, 22}));
    crate_with.add(crate(), true);
    const auto answer = crate_with.from_the_top();
    ASSERT_EQ(answer.steps.size(), 3u);
    EXPECT_EQ(answer.steps[0].placements, std::vector<int>{high});
    EXPECT_EQ(answer.steps[1].placements, std::vector<int>{middle});
    EXPECT_EQ(answer.steps[2].placements, std::vector<int>{low});
    EXPECT_TRUE(answer.through_walls.empty());
    crate_with.replay(answer);
}

TEST(FromTheTop, WhatHasNoWayUpLeavesThroughTheWalls) {
    // A die in a shelf that is open towards +x alone and fills the crate but for the die.
    Crate scene;
    Mesh shelf = box_mesh({2, 2, 2}, {42, 42, 16});
    shelf = test::merged(shelf, box_mesh({2, 2, 24}, {42, 42, 40}));
    shelf = test::merged(shelf, box_mesh({2, 2, 16}, {34, 42, 24}));
    const int held = scene.add(shelf, true);
    const int die = scene.add(box_mesh({34, 18, 16}, {42, 26, 24}));
    scene.add(crate(), true);
    EXPECT_EQ(held, 0);
    const auto answer = scene.from_the_top();
    ASSERT_EQ(answer.steps.size(), 1u);
    EXPECT_EQ(answer.steps[0].placements, std::vector<int>{die});
    EXPECT_EQ(answer.through_walls, std::vector<int>{0});
    scene.replay(answer);
}

TEST(FromTheTop, WaysWithCornersComeInTheirTurn) {
    // A die under a shelf comes out beside it: after what is higher, before what is lower.
    Crate scene;
    const int above = scene.add(box_mesh({4, 30, 30}, {10, 36, 36}));
    scene.add(box_mesh({2, 2, 24}, {30, 20, 26}), true);
    const int die = scene.add(box_mesh({14, 8, 14}, {22, 14, 22}));
    const int below = scene.add(box_mesh({32, 32, 2}, {40, 40, 10}));
    scene.add(crate(), true);
    const auto answer = scene.from_the_top();
    ASSERT_EQ(answer.steps.size(), 3u);
    EXPECT_EQ(answer.steps[0].placements, std::vector<int>{above});
    EXPECT_EQ(answer.steps[1].placements, std::vector<int>{die});
    EXPECT_EQ(answer.steps[1].path.size(), 2u);
    EXPECT_EQ(answer.steps[2].placements, std::vector<int>{below});
    scene.replay(answer);
}

/// The uppermost of those that stand and go straight up, by sweeps alone.
double highest_straight_up(const Subassembly& standing) {
    double highest = -Box::kInfinity;
    for (const std::size_t i : standing.movable()) {
        if (!standing.straight_way({i}, {2, 1}).met) highest = std::max(highest, standing.part(i).box().max.z);
    }
    return highest;
}

class RandomHeaps : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomHeaps, ComeApartFromTheTop) {
    RandomStream random(GetParam());
    Crate scene;
    scene.add_heap(random, 40, {2, 2, 2}, GetParam() % 2 == 0);
    scene.add(crate(), true);
    const auto any = scene.by_any_way();
    const auto top = scene.from_the_top(&any.steps);
    scene.replay(top, 0.5);
    // Whatever leaves by any way, leaves from the top, if through the walls.
    std::size_t singles_any = 0, singles_top = 0;
    for (const RemovalStep& step : any.steps) {
        singles_any += step.placements.size() == 1;
    }
    for (const RemovalStep& step : top.steps) {
        singles_top += step.placements.size() == 1;
    }
    EXPECT_GE(singles_top, singles_any);

    std::vector<int> names(scene.parts().size());
    std::iota(names.begin(), names.end(), 0);
    Subassembly standing(scene.setup(), names, scene.parts());
    std::vector<bool> grouped(scene.parts().size(), false);
    for (std::size_t k = 0; k < top.steps.size(); ++k) {
        const std::vector<int>& who = top.steps[k].placements;
        const auto first = static_cast<std::size_t>(who.front());
        if (grouped[first]) continue;
        const bool through = std::ranges::count(top.through_walls, static_cast<int>(k)) > 0;
        const double highest = highest_straight_up(standing), own = standing.part(first).box().max.z;
        if (through || who.size() > 1) {
            EXPECT_EQ(highest, -Box::kInfinity) << "step " << k << ": another rises";
        } else if (!standing.straight_way({first}, {2, 1}).met) {
            EXPECT_EQ(own, highest) << "step " << k;
        } else {
            EXPECT_GE(standing.part(first).box().min.z, highest) << "step " << k;
        }
        for (const int i : who) {
            grouped[static_cast<std::size_t>(i)] = who.size() > 1;
            standing.remove(static_cast<std::size_t>(i));
        }
    }
    for (const int threads : {1, 3}) {
        scene.setup().workers = Workers(threads);
        const auto again = scene.from_the_top(&any.steps);
        EXPECT_EQ(again.steps, top.steps);
        EXPECT_EQ(again.through_walls, top.through_walls);
    }
}

/// Every step of a smoothed plan is free, and no way has more moves.
TEST_P(RandomHeaps, HaveSmoothWays) {
    RandomStream random(GetParam());
    Crate scene;
    scene.add_heap(random, 40, {2, 2, 2}, GetParam() % 2 == 0);
    scene.add(crate(), true);
    const auto any = scene.by_any_way();
    if (!any.stuck.empty()) GTEST_SKIP() << "interlocked";
    const auto rough = scene.from_the_top(&any.steps);
    Disassembly plan{true, any.steps, {}};
    InterlockCounts counts;
    plan = unpacked(scene.setup(), scene.parts(), {.unpack = Unpack::top, .walls = scene.walls()}, plan, counts);
    EXPECT_EQ(plan.unpack, Unpack::top);
    EXPECT_EQ(plan.through_walls, rough.through_walls);
    scene.replay({plan.steps, {}, counts, plan.through_walls, scene.walls()}, 0.5);
    ASSERT_EQ(plan.steps.size(), rough.steps.size());
    for (std::size_t k = 0; k < plan.steps.size(); ++k) {
        EXPECT_EQ(plan.steps[k].placements, rough.steps[k].placements);
        EXPECT_LE(plan.steps[k].path.size(), rough.steps[k].path.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHeaps, testing::Range<std::uint64_t>(0, 24));

}  // namespace
}  // namespace spectralpack
