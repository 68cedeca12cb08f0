#include "disassembly/disassembler.hpp"

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"
#include "support/die_behind_sill.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::placed;

using Sets = std::vector<std::vector<int>>;

TEST(WaysOut, FindsAWayOutWithACorner) {
    // A die at the end of an L-shaped tunnel in a fixed block: along x, then along y.
    AssemblyScene scene({60, 60, 30});
    Mesh block = box_mesh({0, 0, 0}, {50, 50, 4});
    block = test::merged(block, box_mesh({0, 0, 14}, {50, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {10, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {50, 10, 18}));
    block = test::merged(block, box_mesh({10, 22, 0}, {38, 50, 18}));
    block = test::merged(block, box_mesh({48, 0, 0}, {50, 50, 18}));
    scene.add(placed(block, {2, 2, 2}), true);
    const int die = scene.add(placed(test::cube_mesh(8), {15, 14, 7}));
    const auto answer = scene.disassemble();
    ASSERT_TRUE(answer.steps.size() == 1);
    EXPECT_EQ(answer.steps.front().placements, std::vector<int>{die});
    EXPECT_EQ(answer.steps.front().path.size(), 2u);
    EXPECT_EQ(answer.counts.flooded, 1);
    scene.replay(answer);
}

TEST(WaysOut, SnapsACopyOffTheGridOntoIt) {
    AssemblyScene scene({60, 60, 30});
    Mesh block = box_mesh({0, 0, 0}, {50, 50, 4});
    block = test::merged(block, box_mesh({0, 0, 14}, {50, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {10, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {50, 10, 18}));
    block = test::merged(block, box_mesh({10, 22, 0}, {38, 50, 18}));
    block = test::merged(block, box_mesh({48, 0, 0}, {50, 50, 18}));
    scene.add(placed(block, {2, 2, 2}), true);
    scene.add(placed(test::cube_mesh(8), {15.3, 14.7, 7.45}));
    const auto answer = scene.disassemble();
    EXPECT_EQ(answer.counts.flooded, 1);
    scene.replay(answer);
}

AssemblyScene die_behind_a_sill(double sill, double room_above) {
    AssemblyScene scene({60, 40, 40});
    scene.add(test::box_with_sill(sill, room_above), true);
    scene.add(test::die_mesh());
    return scene;
}

TEST(WaysOut, FindsAWayBesideTheGrid) {
    const AssemblyScene scene = die_behind_a_sill(0.8, 1.2);
    const auto answer = scene.disassemble();
    EXPECT_TRUE(answer.complete());
    ASSERT_EQ(answer.steps.size(), 1u);
    EXPECT_EQ(answer.steps.front().path.size(), 2u);
    EXPECT_EQ(answer.counts.flooded, 1);
    scene.replay(answer);
    EXPECT_FALSE(die_behind_a_sill(1.2, 1.4).disassemble().complete());
    EXPECT_FALSE(die_behind_a_sill(0.8, 0.7).disassemble().complete());
}

TEST(WaysOut, TriesStepsThatItIsToldOf) {
    const AssemblyScene scene = die_behind_a_sill(1.4, 1.7);
    EXPECT_EQ(scene.disassemble().stuck, (Sets{{0, 1}}));
    const std::vector<RemovalStep> told{{{1}, {{0, 0, 1.5}, {30, 0, 0}}}};
    const auto answer = scene.disassemble(&told);
    EXPECT_EQ(answer.steps, told);
    EXPECT_TRUE(answer.complete());
    scene.replay(answer);
    // What is not so, does not lead outside or cannot be swept changes nothing.
    for (const std::vector<Vec3>& path : {std::vector<Vec3>{{0, 0, 1.3}, {30, 0, 0}},
                                          {{0, 0, 1.8}, {30, 0, 0}},
                                          {{0, 0, 1.5}, {10, 0, 0}},
                                          {{0, 0, 1.5}, {30, 0.01, 0}},
                                          {}}) {
        const std::vector<RemovalStep> wrong{{{1}, path}};
        EXPECT_EQ(scene.disassemble(&wrong).stuck, (Sets{{0, 1}}));
    }
}

}  // namespace
}  // namespace spectralpack
