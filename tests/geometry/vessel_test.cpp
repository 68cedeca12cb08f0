#include "geometry/vessel.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_edges.hpp"
#include "support/data.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

/// A beaker of 20 x 20 x 20 mm with walls and a floor of 2 mm; its four corners at the rim, outside and inside, are as
/// high as said.
Mesh beaker(const std::array<double, 4>& rim) {
    Mesh mesh;
    const auto ring = [&](double low, double high, const std::array<double, 4>& z) {
        const Vec3 corners[] = {{low, low, z[0]}, {high, low, z[1]}, {high, high, z[2]}, {low, high, z[3]}};
        mesh.vertices.insert(mesh.vertices.end(), std::begin(corners), std::end(corners));
    };
    ring(0, 20, {0, 0, 0, 0});
    ring(0, 20, rim);
    ring(2, 18, rim);
    ring(2, 18, {2, 2, 2, 2});
    for (std::uint32_t level = 0; level < 3; ++level) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = 4 * level + i, b = 4 * level + (i + 1) % 4;
            mesh.triangles.push_back({a, b, b + 4});
            mesh.triangles.push_back({a, b + 4, a + 4});
        }
    }
    mesh.triangles.push_back({0, 2, 1});
    mesh.triangles.push_back({0, 3, 2});
    mesh.triangles.push_back({12, 13, 14});
    mesh.triangles.push_back({12, 14, 15});
    return mesh;
}

void expect_room(const Cavity& cavity) {
    EXPECT_TRUE(is_closed(cavity.room));
    EXPECT_NEAR(signed_volume(cavity.room), cavity.volume, 1e-9 * cavity.volume);
    EXPECT_DOUBLE_EQ(bounding_box(cavity.room).max.z, cavity.brim);
}

TEST(Vessel, HoldsWhatIsWithinItsWalls) {
    const Mesh mesh = beaker({20, 20, 20, 20});
    ASSERT_TRUE(is_closed(mesh));
    ASSERT_NEAR(signed_volume(mesh), 8000 - 16 * 16 * 18, 1e-9);
    const auto cavity = largest_cavity(mesh);
    ASSERT_TRUE(cavity);
    EXPECT_NEAR(cavity->volume, 16 * 16 * 18, 1e-9);
    EXPECT_EQ(cavity->brim, 20);
    EXPECT_TRUE(cavity->open);
    expect_room(*cavity);
    EXPECT_EQ(bounding_box(cavity->room), (Box{{2, 2, 2}, {18, 18, 20}}));
}

TEST(Vessel, RunsOverAtTheLowestPointOfItsRim) {
    // One corner is 5 mm lower.
    const auto cavity = largest_cavity(beaker({15, 20, 20, 20}));
    ASSERT_TRUE(cavity);
    EXPECT_EQ(cavity->brim, 15);
    EXPECT_NEAR(cavity->volume, 16 * 16 * 13, 1e-9);
    expect_room(*cavity);
}

TEST(Vessel, HoldsNothingUpsideDownOrOnItsSide) {
    const Mesh mesh = beaker({20, 20, 20, 20});
    const Mat3 upside_down{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}};
    const Mat3 on_its_side{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
    EXPECT_FALSE(largest_cavity(transformed(mesh, {upside_down, {}})));
    EXPECT_FALSE(largest_cavity(transformed(mesh, {on_its_side, {}})));
    EXPECT_FALSE(largest_cavity(cube_mesh(10)));
    EXPECT_FALSE(largest_cavity(torus_mesh(20, 4)));
    EXPECT_FALSE(largest_cavity({}));
}

TEST(Vessel, AHollowHasNoBrim) {
    Mesh mesh = cube_mesh(20);
    append(mesh, inside_out(box_mesh({2, 2, 2}, {18, 18, 12})));
    const auto cavity = largest_cavity(mesh);
    ASSERT_TRUE(cavity);
    EXPECT_NEAR(cavity->volume, 2560, 1e-9);
    EXPECT_FALSE(cavity->open);
    EXPECT_EQ(cavity->brim, 12);
    expect_room(*cavity);
}

TEST(Vessel, TheLargerOfTwo) {
    Mesh mesh = beaker({15, 20, 20, 20});
    append(mesh, transformed(beaker({20, 20, 20, 20}), {Mat3{}, {30, 0, 0}}));
    const auto cavity = largest_cavity(mesh);
    ASSERT_TRUE(cavity);
    EXPECT_NEAR(cavity->volume, 16 * 16 * 18, 1e-9);
    EXPECT_EQ(bounding_box(cavity->room).min.x, 32);
}

}  // namespace
}  // namespace spectralpack::test
