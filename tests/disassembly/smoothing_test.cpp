#include "disassembly/smoothing.hpp"

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"

namespace spectralpack {
namespace {

using test::AssemblyScene;
using test::box_mesh;
using test::placed;

/// A die in a tunnel 12 mm wide that leads 18 mm along x and then out along y.
AssemblyScene tunnel() {
    AssemblyScene scene({60, 60, 30});
    Mesh block = box_mesh({0, 0, 0}, {50, 50, 4});
    block = test::merged(block, box_mesh({0, 0, 14}, {50, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {10, 50, 18}));
    block = test::merged(block, box_mesh({0, 0, 0}, {50, 10, 18}));
    block = test::merged(block, box_mesh({10, 22, 0}, {36, 50, 18}));
    block = test::merged(block, box_mesh({48, 0, 0}, {50, 50, 18}));
    scene.add(placed(block, {2, 2, 2}), true);
    scene.add(placed(test::cube_mesh(8), {15, 14, 7}));
    return scene;
}

Disassembly smooth_plan(const AssemblyScene& scene, const std::vector<Vec3>& path) {
    Disassembly plan{true, {{{1}, path}}, {}};
    smooth(scene.setup(), scene.parts(), std::nullopt, plan);
    scene.replay({plan.steps, {}, {}});
    return plan;
}

TEST(Smoothing, LeavesOutCornersThatTheMeshesDoNotNeed) {
    const AssemblyScene scene = tunnel();
    // In small steps round every millimetre.
    std::vector<Vec3> path;
    for (int i = 0; i < 8; ++i) {
        for (const Vec3& move : {Vec3{3, 0, 0}, Vec3{0, 0, i % 2 == 0 ? 1.0 : -1.0}}) {
            path.push_back(move);
        }
    }
    path.insert(path.end(), {{0, 20, 0}, {0, 0, 1}, {0, 30, 0}});
    EXPECT_EQ(smooth_plan(scene, path).steps[0].path.size(), 2u);
}

TEST(Smoothing, KeepsWhatIsAsShortAsItCanBe) {
    const AssemblyScene scene = tunnel();
    const std::vector<Vec3> path{{24, 0, 0}, {0, 50, 0}};
    EXPECT_EQ(smooth_plan(scene, path).steps[0].path, path);
}

TEST(Smoothing, WallsAreInTheWayOfStepsThatDoNotGoThroughThem) {
    // A wall on the straight way out: only the step that is said to go through it is made straight.
    AssemblyScene scene({60, 60, 30});
    const int die = scene.add(placed(test::cube_mesh(8), {4, 20, 7}));
    scene.add(box_mesh({30, 0, 0}, {32, 40, 30}), true);
    const std::vector<Vec3> path{{10, 0, 0}, {0, 22, 0}, {20, 0, 0}, {0, 40, 0}};
    for (const bool through : {false, true}) {
        Disassembly plan{true, {{{die}, path}}, {}};
        if (through) plan.through_walls = {0};
        smooth(scene.setup(), scene.parts(), 1, plan);
        const auto replayed = AssemblyScene::Answer{plan.steps, {}, {}, plan.through_walls, 1};
        scene.replay(replayed);
        EXPECT_LE(plan.steps[0].path.size(), through ? 1u : 2u);
    }
}

}  // namespace
}  // namespace spectralpack
