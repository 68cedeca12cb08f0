#include "verify/check.hpp"

#include <gtest/gtest.h>

#include "support/names.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

/// One cube of 10 mm in a container of 60 x 60 x 30 mm, wherever a test wants it.
class WallsTest : public testing::Test {
  protected:
    WallsTest() {
        packing_.container.size = {60, 60, 30};
        packing_.parts.resize(1);
        packing_.parts[0].name = "cube";
        packing_.parts[0].count = 1;
        packing_.trays.resize(1);
        packing_.trays[0].placements.push_back({0, 0, 0, false, {}});
    }

    static StandingMesh standing(Mesh mesh) { return {"wall.stl", {}, std::make_shared<const Mesh>(std::move(mesh))}; }

    /// Findings about containment alone; figures are not stated here.
    std::vector<Finding> at(const Vec3& corner) {
        packing_.trays[0].placements[0].transform.translation = corner;
        Listener quiet;
        std::vector<Finding> outside;
        for (const Finding& finding : check_packing(packing_, {cube_}, Workers(2), quiet, {}).findings) {
            if (finding.kind == FindingKind::outside) outside.push_back(finding);
        }
        return outside;
    }

    std::shared_ptr<const Mesh> cube_ = std::make_shared<const Mesh>(cube_mesh(10));
    Packing packing_;
};

TEST_F(WallsTest, ACopyMayTouchTheMeshContainerAndNotLeaveIt) {
    // A ring-shaped room: 60 mm wide, a hole of 20 mm in the middle.
    packing_.container.mesh =
        standing(merged(box_mesh({0, 0, 0}, {60, 60, 30}), turned_inside_out(box_mesh({20, 20, 0}, {40, 40, 30}))));
    EXPECT_TRUE(at({0, 0, 0}).empty());
    EXPECT_TRUE(at({10, 25, 20}).empty());  // touches hole and top
    const auto halfway = at({15, 25, 5});
    ASSERT_EQ(halfway.size(), 1u);
    EXPECT_TRUE(names(halfway[0].message, {"1 cube", "container"}));
    EXPECT_FALSE(at({25, 25, 10}).empty());  // wholly in the hole, touching nothing
    EXPECT_FALSE(at({200, 0, 0}).empty());
    EXPECT_TRUE(at({10.0005, 25, 5}).empty());  // within the tolerance
}

TEST_F(WallsTest, TheWallGapHoldsForMeshesAndKeepOuts) {
    packing_.options.wall_gap = 1;
    packing_.container.mesh = standing(transformed(torus_mesh(30, 14, 96, 64), {Mat3{}, {44, 44, 14}}));
    packing_.container.size = {88, 88, 28};
    EXPECT_TRUE(at({9, 39, 9}).empty());
    const auto near = at({2, 39, 9});
    ASSERT_FALSE(near.empty());
    EXPECT_TRUE(names(near[0].message, {"1 cube", 1, "mm"}));

    packing_.container.mesh.reset();
    packing_.container.keep_out = {{Box{{40, 40, 0}, {50, 50, 28}}}};
    EXPECT_TRUE(at({29, 40, 5}).empty());
    const auto close = at({29.5, 40, 5});
    ASSERT_EQ(close.size(), 1u);
    EXPECT_NEAR(close[0].amount, 0.5, 1e-6);
    EXPECT_TRUE(names(close[0].message, {"cube", "keep-out", 0}));
}

TEST_F(WallsTest, KeepOutsMayBeInsideACopyOrRoundIt) {
    packing_.container.keep_out = {{Box{{20, 20, 10}, {22, 22, 12}}},
                                   {{}, standing(box_mesh({40, 40, 0}, {60, 60, 30}))}};
    EXPECT_EQ(at({15, 15, 5}).size(), 1u);   // the first is in the cube
    EXPECT_EQ(at({45, 45, 10}).size(), 1u);  // the cube is in the second
    EXPECT_TRUE(at({30, 30, 0}).empty());
}

TEST_F(WallsTest, DensityIsOfTheContainersOwnVolume) {
    packing_.container.mesh = standing(box_mesh({0, 0, 0}, {60, 60, 10}));
    packing_.trays[0].density = packing_.metrics.density = 1000.0 / 36000;
    packing_.trays[0].density_bounding_box = 1;
    packing_.trays[0].bounding_box = {{0, 0, 0}, {10, 10, 10}};
    packing_.trays[0].height = 10;
    Listener quiet;
    EXPECT_TRUE(check_packing(packing_, {cube_}, Workers(1), quiet, {}).ok());
}

}  // namespace
}  // namespace spectralpack::test
