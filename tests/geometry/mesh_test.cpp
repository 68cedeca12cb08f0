#include "spectralpack/mesh.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_edges.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

TEST(Mesh, BoxFigures) {
    const Mesh box = test::box_mesh({1, 2, 3}, {4, 6, 8});
    EXPECT_EQ(bounding_box(box), (Box{{1, 2, 3}, {4, 6, 8}}));
    EXPECT_DOUBLE_EQ(signed_volume(box), 60);
    EXPECT_DOUBLE_EQ(surface_area(box), 2 * (12 + 15 + 20));
    EXPECT_TRUE(is_closed(box));
    EXPECT_DOUBLE_EQ(signed_volume(test::turned_inside_out(box)), -60);
}

TEST(Mesh, VolumeKeepsItsDigitsFarFromTheOrigin) {
    const Mesh far = test::box_mesh({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1});
    EXPECT_NEAR(signed_volume(far), 1, 1e-8);
}

TEST(Mesh, UnusedVerticesDoNotCount) {
    Mesh box = test::cube_mesh(1);
    box.vertices.push_back({100, 100, 100});
    EXPECT_EQ(bounding_box(box).max, (Vec3{1, 1, 1}));
}

TEST(Mesh, AMirrorTurnsTheTrianglesRound) {
    const Mat3 mirror{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
    const Mesh mirrored = transformed(test::torus_mesh(5, 2), {mirror, {3, 0, 0}});
    EXPECT_GT(signed_volume(mirrored), 0);
    EXPECT_TRUE(is_closed(mirrored));
}

TEST(Mesh, TransformsCompose) {
    const Transform a{2 * Mat3{}, {1, 2, 3}};
    const Transform b{{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}}, {4, 5, 6}};
    const Vec3 p{7, 8, 9};
    EXPECT_EQ((a * b) * p, a * (b * p));
}

TEST(Mesh, IsClosedSeesHolesAndTurnedFacets) {
    Mesh open = test::cube_mesh(1);
    open.triangles.pop_back();
    EXPECT_FALSE(is_closed(open));
    Mesh flipped = test::cube_mesh(1);
    std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
    EXPECT_FALSE(is_closed(flipped));
    // Two cubes that share one edge: four facets on it, and still a boundary.
    EXPECT_TRUE(is_closed(test::merged(test::cube_mesh(1), test::box_mesh({1, 1, 0}, {2, 2, 1}))));
    EXPECT_FALSE(is_closed(Mesh{}));
}

}  // namespace
}  // namespace spectralpack
