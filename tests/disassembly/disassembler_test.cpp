#include "disassembly/disassembler.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "disassembly/scenes.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::lying;
using test::placed;

using Sets = std::vector<std::vector<int>>;

const Mesh kTorus = test::torus_mesh(10, 2);

TEST(Disassembler, OnMixedScenesOnlyTheInterlockedStay) {
    AssemblyScene scene({120, 60, 60});
    scene.add(placed(kTorus, {20, 20, 20}));
    scene.add(placed(lying(kTorus, 0), {20, 30, 20}));
    const int on_top = scene.add(box_mesh({10, 10, 34}, {40, 40, 38}));
    const int below = scene.add(box_mesh({10, 10, 2}, {40, 40, 6}));
    const int beside = scene.add(placed(kTorus, {70, 20, 20}));
    const auto answer = scene.disassemble();
    EXPECT_EQ(answer.stuck, (Sets{{0, 1}}));
    std::vector<int> out;
    for (const RemovalStep& step : answer.steps) {
        if (step.placements.size() == 1) out.push_back(step.placements.front());
    }
    std::sort(out.begin(), out.end());
    EXPECT_EQ(out, (std::vector<int>{on_top, below, beside}));
}

TEST(Disassembler, TakesTheRestApartOnceOneIsDiscarded) {
    AssemblyScene scene({60, 60, 60});
    scene.add(placed(kTorus, {20, 20, 20}));
    scene.add(placed(lying(kTorus, 0), {20, 30, 20}));
    Disassembler disassembler(scene.setup(), scene.parts(), [](int, int) {});
    disassembler.run();
    EXPECT_TRUE(disassembler.steps().empty());
    disassembler.discard(0);
    disassembler.run();
    EXPECT_TRUE(disassembler.stuck().empty());
    EXPECT_EQ(disassembler.steps().size(), 1u);
}

TEST(Disassembler, EndsEarlyWhenStopped) {
    AssemblyScene scene({60, 60, 60});
    scene.add(placed(kTorus, {20, 20, 20}));
    StopSource stop;
    stop.request(StopReason::cancelled);
    scene.setup().stop = stop.token();
    EXPECT_TRUE(scene.disassemble().steps.empty());
}

TEST(Disassembler, PlansOfRandomHeapsHoldOnTheMeshes) {
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        RandomStream random(seed);
        AssemblyScene scene({40, 40, 40}, 2);
        scene.add_heap(random, 40, {}, seed % 2 == 0);  // in half of the heaps they stand off the grid
        const auto answer = scene.disassemble();
        scene.replay(answer, 0.5);
        // Every step is of one kind, and every flood fill that found a way is one.
        EXPECT_EQ(static_cast<std::size_t>(answer.counts.straight + answer.counts.flooded + answer.counts.groups),
                  answer.steps.size());
        EXPECT_GE(answer.counts.fills, answer.counts.flooded);
        for (const int threads : {1, 3}) {
            scene.setup().workers = Workers(threads);
            const auto again = scene.disassemble();
            EXPECT_EQ(again.steps, answer.steps);
            EXPECT_EQ(again.counts.fills, answer.counts.fills);
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

}  // namespace
}  // namespace spectralpack
