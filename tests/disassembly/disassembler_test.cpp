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

/// A C open towards +x, in the plane of x and z.
Mesh hook_mesh() {
    Mesh mesh = box_mesh({0, 0, 0}, {12, 4, 3});
    mesh = test::merged(mesh, box_mesh({0, 0, 0}, {3, 4, 12}));
    mesh = test::merged(mesh, box_mesh({0, 0, 9}, {12, 4, 12}));
    return test::merged(mesh, box_mesh({9, 0, 7}, {12, 4, 12}));
}

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
        std::vector<Box> taken;
        BitGrid voxels({20, 20, 20});
        for (int attempt = 0; attempt < 60; ++attempt) {
            Mesh mesh;
            switch (random.below(4)) {
                case 0:
                    mesh = test::frame_mesh(8 + 2.0 * static_cast<double>(random.below(4)), 2, 2);
                    break;
                case 1:
                    mesh = placed(hook_mesh(), {});
                    break;
                case 2:
                    mesh = test::chest_mesh(10, 2, true);
                    break;
                default:
                    mesh = test::cube_mesh(3 + static_cast<double>(random.below(3)));
            }
            mesh = lying(mesh, static_cast<int>(random.below(3)));
            const Box box = bounding_box(mesh);
            Vec3 to;
            for (int axis = 0; axis < 3; ++axis) {
                const auto room = static_cast<std::uint64_t>((40 - box.size()[axis]) / 2);
                to[axis] = 2.0 * static_cast<double>(random.below(room + 1)) - box.min[axis];
                // In half of the heaps they stand off the grid.
                if (seed % 2 == 1)
                    to[axis] += std::min(0.1 * static_cast<double>(random.below(20)),
                                         40 - box.size()[axis] - box.min[axis] - to[axis]);
            }
            mesh = placed(mesh, to);
            const StandingVoxels standing = voxelize_at(mesh, bounding_box(mesh).min, 2, scene.setup().workers);
            if (intersects(voxels, standing.solid, standing.position)) continue;
            unite(voxels, standing.solid, standing.position);
            scene.add(mesh);
        }
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
