#include "packing/tray/measure.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "support/shapes.hpp"

namespace spectralpack {
namespace {

TrayPacking two_boxes() {
    TrayPacking tray;
    tray.placements.push_back({0, 0, 0, false, {2 * Mat3{}, {10, 10, 0}}});  // 2 x 2 x 2 at scale 2
    tray.placements.push_back({1, 0, 0, false, {Mat3{}, {40, 10, 0}}});
    return tray;
}

TEST(Measure, DensityBoxesAndHeightOfTwoBoxes) {
    TrayPacking tray = two_boxes();
    std::vector<PackedPart> parts(2);
    parts[0].volume = 64;
    parts[1].volume = 1000;
    const auto small = std::make_shared<const Mesh>(test::cube_mesh(2));
    const auto large = std::make_shared<const Mesh>(test::cube_mesh(10));
    measure_tray(tray, {{100, 50, 20}}, parts, {small, large}, 2, Workers(2));
    EXPECT_DOUBLE_EQ(tray.density, 1064.0 / 100000);
    EXPECT_EQ(tray.bounding_box, (Box{{10, 10, 0}, {50, 20, 10}}));
    EXPECT_DOUBLE_EQ(tray.density_bounding_box, 1064.0 / 4000);
    EXPECT_DOUBLE_EQ(tray.height, 10);
}

TEST(Measure, LayerAreasAreThoseOfTheSectionsAndAddUpToTheVolume) {
    TrayPacking tray = two_boxes();
    std::vector<PackedPart> parts(2);
    const auto small = std::make_shared<const Mesh>(test::cube_mesh(2));
    // A box with a closed hollow: its section is a frame.
    const auto hollow = std::make_shared<const Mesh>(
        test::merged(test::cube_mesh(10), test::turned_inside_out(test::box_mesh({2, 2, 4}, {8, 8, 8}))));
    measure_tray(tray, {{100, 50, 21}}, parts, {small, hollow}, 2, Workers(1));
    ASSERT_EQ(tray.layers.area.size(), 11u);
    EXPECT_NEAR(tray.layers.area[0], 16 + 100, 1e-9);
    EXPECT_NEAR(tray.layers.area[1], 16 + 100, 1e-9);
    EXPECT_NEAR(tray.layers.area[2], 100 - 36, 1e-9);
    EXPECT_NEAR(tray.layers.area[4], 100, 1e-9);
    EXPECT_NEAR(tray.layers.area[5], 0, 1e-9);
    const double sum = std::accumulate(tray.layers.area.begin(), tray.layers.area.end(), 0.0);
    EXPECT_NEAR(2 * sum, signed_volume(*hollow) + 64, 1e-6);
}

TEST(Measure, AnEmptyTrayHasNoHeight) {
    TrayPacking tray;
    measure_tray(tray, {{10, 10, 10}}, {}, {}, 2, Workers(1));
    EXPECT_EQ(tray.density, 0);
    EXPECT_EQ(tray.height, 0);
    EXPECT_TRUE(tray.bounding_box.empty());
}

}  // namespace
}  // namespace spectralpack
