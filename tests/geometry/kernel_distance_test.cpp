#include <gtest/gtest.h>

#include "geometry/mesh_distance.hpp"
#include "kernel_support.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::Numbers;

double error_of(const Corners& a, const Corners& b) { return std::abs(distance(a, b) - test::quad_distance(a, b)); }

/// The points reported lie on the triangles and are as far apart as is said.
void expect_witnesses(const Corners& a, const Corners& b, double scale) {
    const ClosestPoints found = closest_points(a, b);
    const Corners at_a{found.a, found.a, found.a}, at_b{found.b, found.b, found.b};
    EXPECT_NEAR(length(found.a - found.b), found.distance, 1e-12 * scale);
    EXPECT_NEAR(test::quad_distance(at_a, a), 0, 1e-12 * scale);
    EXPECT_NEAR(test::quad_distance(at_b, b), 0, 1e-12 * scale);
}

TEST(TriangleDistance, IsThatOfTheQuadraticProgramme) {
    for (std::uint64_t seed = 0; seed < 12000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2 == 0;
        const Corners a = numbers.triangle(coarse);
        const Corners b = test::moved(numbers.triangle(coarse), 0.7 * numbers.point(coarse));
        ASSERT_LT(error_of(a, b), 1e-11) << "seed " << seed;
        if (seed % 10 == 0) expect_witnesses(a, b, 10);
    }
}

TEST(TriangleDistance, HoldsFarFromTheOriginAndForLongNeedles) {
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        Numbers numbers(seed);
        Corners a = numbers.triangle(false), b = numbers.triangle(false);
        const double thin = std::pow(10, -static_cast<double>(numbers.below(9)));
        for (Corners* t : {&a, &b}) {
            for (Vec3& corner : *t) {
                corner = {100 * corner.x, thin * corner.y, corner.z};
            }
        }
        const Vec3 far{400, 200, 150};
        ASSERT_LT(error_of(test::moved(a, far), test::moved(b, far)), 1e-9) << "seed " << seed;
    }
}

TEST(TriangleDistance, DoesNotDependOnTheOrderOfCornersOrTriangles) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Numbers numbers(seed);
        const Corners a = numbers.triangle(true), b = numbers.triangle(true);
        const double d = distance(a, b);
        EXPECT_NEAR(distance(b, a), d, 1e-14);
        EXPECT_NEAR(distance({a[1], a[2], a[0]}, {b[2], b[1], b[0]}), d, 1e-12);
    }
}

TEST(TriangleDistance, IsNoughtExactlyWhereTrianglesMeet) {
    const Corners a{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
    const auto at = [&](const Corners& b) { return distance(a, b); };
    EXPECT_EQ(at(a), 0);                                                // the same
    EXPECT_EQ(at({Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 2, 0}}), 0);    // inside, coplanar
    EXPECT_EQ(at({Vec3{1, 1, 0}, Vec3{1, 1, 3}, Vec3{2, 1, 3}}), 0);    // corner on face
    EXPECT_EQ(at({Vec3{4, 0, 0}, Vec3{5, 0, 1}, Vec3{5, 1, 1}}), 0);    // corner on corner
    EXPECT_EQ(at({Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{1, -1, 5}}), 0);  // edge over edge
    EXPECT_EQ(at({Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{9, 9, 1}}), 0);   // through the face
    EXPECT_EQ(at({Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{1, 1, 1}}), 0);   // a segment through it
    EXPECT_EQ(at({Vec3{1, 1, 2}, Vec3{1, 1, 2}, Vec3{1, 1, 2}}), 2);    // a point above
    EXPECT_EQ(at({Vec3{5, 0, 0}, Vec3{6, 0, 0}, Vec3{9, 0, 0}}), 1);    // a segment in line
}

TEST(TriangleDistance, IsNeverBelowTheSeparationByPlanes) {
    int told = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2 == 0;
        const Corners a = numbers.triangle(coarse), b = numbers.triangle(coarse);
        const Vec3 sweep = numbers.point(coarse);
        const double separation = plane_separation(a, b);
        told += separation > 0;
        ASSERT_LE(separation, distance(a, b) + 1e-12) << seed;
        // Along a normal distances change with the way, so a bound at one place is one everywhere.
        for_each_plane(a, b, [&](const Vec3& from_b, double there) {
            ASSERT_NEAR(length(from_b), 1, 1e-12) << seed;
            ASSERT_LE(there, separation) << seed;
            for (int i = 0; i <= 8; ++i) {
                const Vec3 way = (i / 8.0) * sweep;
                ASSERT_LE(there + dot(from_b, way), distance(test::moved(a, way), b) + 1e-12) << seed;
            }
        });
    }
    EXPECT_GT(told, 200);
}

TEST(Bvh, HoldsEveryTriangleOnceInsideItsBoxes) {
    const Mesh mesh = test::torus_mesh(10, 3, 13, 7);
    const Bvh bvh(mesh);
    ASSERT_EQ(bvh.triangle_count(), mesh.triangles.size());
    std::vector<int> seen(mesh.triangles.size());
    for (const Bvh::Node& node : bvh.nodes()) {
        if (!node.leaf()) continue;
        EXPECT_LE(node.count, Bvh::kLeafTriangles);
        for (std::size_t i = node.first; i < node.first + node.count; ++i) {
            ++seen[i];
            for (const Vec3& corner : bvh.corners(i)) {
                Box grown = node.box();
                grown.add(corner);
                EXPECT_EQ(grown, node.box());
            }
        }
    }
    EXPECT_EQ(seen, std::vector<int>(mesh.triangles.size(), 1));
    for (std::size_t i = 0; i < bvh.nodes().size(); ++i) {
        const Bvh::Node& node = bvh.nodes()[i];
        if (node.leaf()) continue;
        Box both = bvh.nodes()[i + 1].box();
        both.add(bvh.nodes()[node.first].box());
        EXPECT_EQ(both, node.box());
    }
    EXPECT_EQ(bvh.box(), bounding_box(mesh));
    EXPECT_NEAR(distance(bvh.nodes().front().box(), {{20, -1, -1}, {21, 1, 1}}),
                distance(bvh.box(), {{20, -1, -1}, {21, 1, 1}}), 2e-6);
}

TEST(Bvh, TurnedIsTheTreeOfTheTurnedMesh) {
    const Mesh mesh = test::torus_mesh(10, 3, 13, 7);
    const Mat3 turn{{Vec3{0, 0, 1}, Vec3{0.6, 0.8, 0}, Vec3{-0.8, 0.6, 0}}};
    for (const Mat3& linear : {turn, Mat3{}, -1.0 * Mat3{}}) {
        const Bvh turned = Bvh(mesh).turned(linear);
        const Mesh expected = transformed(mesh, {linear, {}});
        EXPECT_EQ(turned.box(), bounding_box(expected));
        EXPECT_EQ(least_distance(turned, {}, Bvh(expected), {30, 1, 2}).distance,
                  least_distance(Bvh(expected), {}, Bvh(expected), {30, 1, 2}).distance);
        double volume = 0;  // faces still outwards
        for (std::size_t i = 0; i < turned.triangle_count(); ++i) {
            const Corners t = turned.corners(i);
            volume += dot(t[0], cross(t[1], t[2])) / 6;
        }
        EXPECT_NEAR(volume, signed_volume(mesh), 1e-9);
    }
}

TEST(Bvh, KnowsWhetherTheTrianglesFaceOutwards) {
    Mesh open = test::cube_mesh(2);
    EXPECT_TRUE(Bvh(open).faces_outwards());
    EXPECT_FALSE(Bvh(test::turned_inside_out(open)).faces_outwards());
    open.triangles.pop_back();
    EXPECT_FALSE(Bvh(open).faces_outwards());
}

TEST(Bvh, OfNothingIsEmpty) {
    const Bvh nothing{Mesh{}};
    EXPECT_TRUE(nothing.nodes().empty());
    EXPECT_TRUE(nothing.box().empty());
    EXPECT_EQ(least_distance(nothing, {}, Bvh(test::cube_mesh(1)), {}).distance, Box::kInfinity);
}

TEST(MeshDistance, IsTheLeastOverAllPairs) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Numbers numbers(seed);
        Mesh soup[2];
        for (Mesh& mesh : soup) {
            for (std::uint32_t i = 0; i < 17; ++i) {
                const Corners t = test::moved(numbers.triangle(seed % 2), 3 * numbers.point(seed % 2));
                mesh.vertices.insert(mesh.vertices.end(), t.begin(), t.end());
                mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            }
        }
        const Bvh a(soup[0]), b(soup[1]);
        const Vec3 offset = 6 * numbers.point(false), base{1, 2, 3};
        const double expected = test::quad_distance(a, offset, b);
        const ClosestPoints found = least_distance(a, base + offset, b, base);
        EXPECT_NEAR(found.distance, expected, 1e-11) << "seed " << seed;
        EXPECT_NEAR(length(found.a - found.b), found.distance, 1e-11);
        if (expected > 1e-9) {
            EXPECT_EQ(least_distance(a, base + offset, b, base, 0.5 * expected).distance, 0.5 * expected);
        }
        EXPECT_NEAR(least_distance(a, base + offset, b, base, 2 * expected).distance, expected, 1e-11);
    }
}

TEST(MeshDistance, OfBoxesIsThatOfTheirSidesAndOfNestedOnesThatOfTheSurfaces) {
    const Bvh cube(test::cube_mesh(10)), small(test::cube_mesh(2));
    EXPECT_DOUBLE_EQ(least_distance(cube, {0, 0, 0}, cube, {13, 14, 0}).distance, 5);
    EXPECT_EQ(least_distance(cube, {0, 0, 0}, cube, {10, 5, 5}).distance, 0);
    EXPECT_DOUBLE_EQ(least_distance(small, {4, 4, 5}, cube, {0, 0, 0}).distance, 3);
}

}  // namespace
}  // namespace spectralpack
