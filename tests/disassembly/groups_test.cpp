#include "disassembly/disassembler.hpp"

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::placed;

using Sets = std::vector<std::vector<int>>;

/// A square tube along x, fixed, and in it a tongue in a groove that come apart only along y, which the tube forbids.
AssemblyScene tongue_and_groove() {
    AssemblyScene scene({120, 40, 40});
    Mesh tube = box_mesh({0, 0, 0}, {60, 24, 3});
    tube = test::merged(tube, box_mesh({0, 0, 19}, {60, 24, 22}));
    tube = test::merged(tube, box_mesh({0, 0, 0}, {60, 3, 22}));
    tube = test::merged(tube, box_mesh({0, 21, 0}, {60, 24, 22}));
    scene.add(placed(tube, {10, 5, 5}), true);
    // The groove: a C around the tongue's head along z, open in y only.
    Mesh groove = box_mesh({0, 0, 0}, {8, 16, 14});
    groove = test::merged(groove, box_mesh({8, 0, 0}, {20, 16, 3}));
    groove = test::merged(groove, box_mesh({8, 0, 11}, {20, 16, 14}));
    groove = test::merged(groove, box_mesh({17, 0, 0}, {20, 16, 5}));
    groove = test::merged(groove, box_mesh({17, 0, 9}, {20, 16, 14}));
    Mesh tongue = box_mesh({10, 0, 4}, {15, 16, 10});
    tongue = test::merged(tongue, box_mesh({10, 0, 6}, {40, 16, 8}));
    scene.add(placed(groove, {15, 9, 9}));
    scene.add(placed(tongue, {15, 9, 9}));
    return scene;
}

TEST(Groups, TakesOutAsAGroupWhatComesOutOnlySo) {
    const AssemblyScene scene = tongue_and_groove();
    const auto answer = scene.disassemble();
    EXPECT_TRUE(answer.complete());
    ASSERT_EQ(answer.steps.size(), 3u);
    EXPECT_EQ(answer.steps.front().placements, (std::vector<int>{1, 2}));
    EXPECT_EQ(answer.counts.groups, 1);
    scene.replay(answer);
}

TEST(Groups, TakesOutAsAGroupWhatItIsTold) {
    // As before, with one end closed and a sill at the other: the pair is to be lifted first.
    AssemblyScene scene = tongue_and_groove();
    scene.add(test::merged(box_mesh({6, 5, 5}, {10, 29, 27}), box_mesh({70, 5, 5}, {72, 29, 9.5})), true);
    EXPECT_EQ(scene.disassemble().stuck, (Sets{{0, 1, 2, 3}}));
    const std::vector<RemovalStep> told{{{1, 2}, {{0, 0, 0.8}, {80, 0, 0}}}};
    const auto answer = scene.disassemble(&told);
    EXPECT_TRUE(answer.complete());
    ASSERT_EQ(answer.steps.size(), 3u);
    EXPECT_EQ(answer.steps.front(), told.front());
    EXPECT_EQ(answer.counts.groups, 1);
    scene.replay(answer);
}

}  // namespace
}  // namespace spectralpack
