#include "geometry/minimum_box.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "geometry/convex_hull.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

Mesh turned(const Mesh& mesh, const Mat3& turn) { return transformed(mesh, {turn, {3, -7, 11}}); }

/// A rotation with nothing special about it.
Mat3 skew(double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    const Mat3 about_x{{Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}}};
    const Mat3 about_z{{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}};
    return about_x * about_z;
}

double box_volume(const Mesh& mesh, const Mat3& frame) { return bounding_box(transformed(mesh, {frame, {}})).volume(); }

TEST(ConvexHull, HasTheCornersOfABoxAndItsSixNormals) {
    std::vector<Vec3> points;
    for (int i = 0; i < 27; ++i) {
        points.push_back({i % 3 * 2.0, i / 3 % 3 * 3.0, i / 9 * 4.0});
    }
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.vertices.size(), 8u);
    EXPECT_EQ(hull.normals.size(), 12u);  // triangulated
    EXPECT_TRUE(convex_hull({}).vertices.empty());
    EXPECT_TRUE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 5, 0}}).vertices.empty());
    EXPECT_TRUE(convex_hull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).vertices.empty());
    EXPECT_TRUE(convex_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).vertices.empty());
}

TEST(MinimumBox, FindsTheBoxThatATurnedBoxIs) {
    const Mesh box = test::box_mesh({0, 0, 0}, {10, 20, 35});
    for (const double angle : {0.1, 0.5, 0.785, 2.0}) {
        const Mesh mesh = turned(box, skew(angle));
        const Mat3 frame = minimum_box_frame(mesh);
        EXPECT_NEAR(box_volume(mesh, frame), 7000, 1e-6) << angle;
        EXPECT_NEAR(determinant(frame), 1, 1e-12);
    }
    EXPECT_EQ(minimum_box_frame(box), Mat3{});
}

TEST(MinimumBox, IsNeverLargerThanTheMeshsOwnOrAnyOfManyOthers) {
    RandomStream random(7);
    for (int n = 0; n < 20; ++n) {
        Mesh mesh;  // a tetrahedron and more corners
        for (int i = 0; i < 4 + n; ++i) {
            mesh.vertices.push_back({10 * random.unit(), 20 * random.unit(), 5 * random.unit()});
        }
        for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); ++i) {
            mesh.triangles.push_back({i, i + 1, i + 2});
        }
        const double least = box_volume(mesh, minimum_box_frame(mesh));
        EXPECT_LE(least, box_volume(mesh, {}));
        // Random frames come close now and then, and only a frame with two sides on edges could beat it.
        double beaten = 0;
        for (int i = 0; i < 500; ++i) {
            const Mat3 frame = skew(7 * random.unit()) * skew(7 * random.unit()) * skew(7 * random.unit());
            beaten = std::max(beaten, least / box_volume(mesh, frame));
        }
        EXPECT_LT(beaten, 1.05) << n;
    }
}

TEST(MinimumBox, OfManyVerticesIsNearTheBest) {
    const Mesh mesh = turned(test::torus_mesh(20, 5, 64, 48), skew(0.6));
    EXPECT_LT(box_volume(mesh, minimum_box_frame(mesh)), 1.01 * 50 * 50 * 10);
}

TEST(MinimumBox, OfFlatMeshesIsTheirOwn) {
    Mesh flat;
    flat.vertices = {{0, 0, 1}, {1, 2, 1}, {3, 1, 1}, {5, 5, 1}};
    flat.triangles = {{0, 1, 2}, {1, 2, 3}};
    EXPECT_EQ(minimum_box_frame(flat), Mat3{});
    EXPECT_EQ(minimum_box_frame({}), Mat3{});
}

}  // namespace
}  // namespace spectralpack
