#include "render/taking_apart.hpp"

#include <gtest/gtest.h>

#include "render/stage.hpp"
#include "scenes.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// Five boxes of 10 mm in a row along x; 1 and 2 leave as a group.
TrayPacking tray_with_plan() {
    TrayPacking tray;
    tray.placements.resize(5);
    tray.disassembly = Disassembly{true,
                                   {{{4}, {{10, 0, 0}}},
                                    {{1, 2}, {{0, 0, 20}, {0, 40, 0}}},
                                    {{0}, {{-10, 0, 0}}},
                                    {{2}, {{10, 0, 0}}},
                                    {{1}, {}},
                                    {{3}, {}}},
                                   {}};
    return tray;
}

std::vector<int> where(const std::vector<ShownCopy>& shown, bool ShownCopy::*what) {
    std::vector<int> found;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i].*what) found.push_back(static_cast<int>(i));
    }
    return found;
}

TEST(TakingApart, AStepShowsWhoLeavesAndWhoStays) {
    using List = std::vector<int>;
    const TrayPacking tray = tray_with_plan();
    const struct {
        int step;
        List drawn, leaving;
    } cases[] = {{0, {0, 1, 2, 3, 4}, {}},
                 {1, {0, 1, 2, 3, 4}, {4}},
                 {2, {0, 1, 2, 3}, {1, 2}},
                 {3, {0, 3}, {0}},
                 {4, {1, 2}, {2}},
                 {5, {1}, {1}},
                 {6, {3}, {3}}};
    for (const auto& c : cases) {
        const std::vector<ShownCopy> shown = show_step(tray, c.step);
        EXPECT_EQ(where(shown, &ShownCopy::drawn), c.drawn) << c.step;
        EXPECT_EQ(where(shown, &ShownCopy::leaving), c.leaving) << c.step;
    }
    EXPECT_EQ(show_step(tray, 2)[1].offset, (Vec3{0, 10, 20}));  // half of 60 mm
    EXPECT_EQ(show_step(tray, 2)[0].offset, Vec3{});
    EXPECT_EQ(show_step(tray, 4)[2].offset, (Vec3{5, 0, 0}));
}

TEST(TakingApart, ExplodingLiftsLayersUntilNoneHidesTheNext) {
    // Two layers of 50 mm, a tall copy in the lower one.
    const std::vector<Box> boxes{{{0, 0, 0}, {10, 10, 40}},
                                 {{20, 0, 0}, {30, 10, 80}},
                                 {{0, 0, 55}, {10, 10, 95}},
                                 {{20, 20, 85}, {30, 30, 100}}};
    const Vec3 container{100, 100, 100};
    const ExplodedTray apart = show_exploded(boxes, container, 0, 45, 1);
    ASSERT_EQ(apart.floors.size(), 2u);
    EXPECT_EQ(apart.copies[0].offset, Vec3{});
    EXPECT_EQ(apart.copies[1].offset, Vec3{});
    EXPECT_EQ(apart.copies[2].offset, apart.copies[3].offset);
    // From 45 degrees above, the far edge of a layer is seen as high as the tray is deep.
    EXPECT_NEAR(apart.floors[1] - 80, 100, 1e-9);
    EXPECT_NEAR(apart.copies[2].offset.z, apart.floors[1] - 50, 1e-9);
    for (const ShownCopy& copy : show_exploded(boxes, container, 0, 45, 0).copies) {
        EXPECT_EQ(copy.offset, Vec3{});
    }
}

TEST(TakingApart, TheStageHoldsWhatIsDrawn) {
    test::SmallScene scene = test::empty_scene({40, 30, 20});
    const int part = scene.add_part(test::cube_mesh(5));
    scene.place(part, {Mat3{}, {1, 2, 3}}, 0);
    scene.place(part, {Mat3{}, {8, 2, 3}}, 1);
    RenderOptions options;
    options.step = 2;
    EXPECT_THROW(set_stage(scene.packing, scene.meshes, {options}), UsageError);
    scene.packing.trays[0].disassembly = Disassembly{true, {{{1}, {{50, 0, 0}}}, {{0}, {}}}, {}};
    EXPECT_EQ(set_stage(scene.packing, scene.meshes, {options}).copies.size(), 1u);
    options.step = 1;
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    ASSERT_EQ(stage.copies.size(), 2u);
    const double scale = stage.copies[0].pose.linear.rows[0].x;
    EXPECT_NEAR(stage.copies[1].pose.translation.x - stage.copies[0].pose.translation.x, scale * (7 + 25), 1e-12);
    EXPECT_NE(stage.copies[0].colour, stage.copies[1].colour);
    options.step = 3;
    EXPECT_THROW(set_stage(scene.packing, scene.meshes, {options}), UsageError);
    options.step.reset();
    options.explode = 1;
    EXPECT_EQ(set_stage(scene.packing, scene.meshes, {options}).copies.size(), 2u);
}

}  // namespace
}  // namespace spectralpack
