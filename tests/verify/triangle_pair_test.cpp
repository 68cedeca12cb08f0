#include "verify/triangle_pair.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "scenes.hpp"

namespace spectralpack::test {
namespace {

PointTriangle points(const Corners& c) { return {Point(c[0]), Point(c[1]), Point(c[2])}; }

Corners moved(const Corners& c, const Vec3& step) { return {c[0] + step, c[1] + step, c[2] + step}; }

Vec3 grid_point(RandomStream& random, int reach) {
    const auto at = [&] { return double(int(random.below(2 * reach + 1)) - reach); };
    return {at(), at(), at()};
}

/// Triangles of all kinds, from generic ones to points.
Corners random_triangle(RandomStream& random) {
    Corners c{random_point(random, 10), random_point(random, 10), random_point(random, 10)};
    switch (random.below(8)) {
        case 0:
            c = {grid_point(random, 2), grid_point(random, 2), grid_point(random, 2)};
            break;
        case 1:
            c[0].z = c[1].z = c[2].z = double(random.below(2));
            break;
        case 2:
            c[2] = 0.3 * c[0] + 0.7 * c[1];
            break;  // a segment up to rounding
        case 3:
            c[2] = 0.3 * c[0] + 0.7 * c[1] + random_point(random, 1e-7);
            break;
        case 4:
            c[1] = c[0];
            break;
        case 5:
            c[1] = c[0] + random_point(random, 1e-5);
            break;
        case 6:
            c = moved({1e-5 * c[0], 1e-5 * c[1], 1e-5 * c[2]}, random_point(random, 1e-4));
            break;
        default:
            break;
    }
    return c;
}

TEST(TrianglePair, DistancesAgreeWithTheReference) {
    RandomStream random(1);
    int meeting = 0;
    for (int i = 0; i < 40000; ++i) {
        const Corners a = random_triangle(random), b = random_triangle(random);
        const double expected = double(reference_distance(points(a), points(b)));
        const double exact = std::min(least_height(a), least_height(b)) > 1e-6 ? 1e-9 : 2e-7;
        ASSERT_NEAR(triangle_distance(a, b, kFar), expected, exact) << i;
        ASSERT_NEAR(triangle_distance(b, a, kFar), expected, exact) << i;
        ASSERT_NEAR(point_triangle_distance(a[0], b), double(reference_distance(Point(a[0]), points(b))), exact);
        const double cutoff = between(random, 0, 2 * expected);
        const double cut = triangle_distance(a, b, cutoff);
        ASSERT_TRUE(cut == triangle_distance(a, b, kFar) || (cut == kFar && expected > cutoff)) << i;
        meeting += expected == 0;
    }
    EXPECT_GT(meeting, 100);
}

TEST(TrianglePair, NoShorterTranslationEndsACrossing) {
    RandomStream random(2);
    int crossings = 0;
    for (int i = 0; i < 20000 && crossings < 1000; ++i) {
        const Corners a = random_triangle(random), b = random_triangle(random);
        const double depth = crossing_depth(a, b);
        ASSERT_NEAR(depth, crossing_depth(b, a), 1e-9);
        if (depth <= 1e-6) continue;
        ++crossings;
        ASSERT_EQ(reference_distance(points(a), points(b)), 0);
        // Nor does any of these, and one of twice the triangles' heights over each other does.
        for (int k = 0; k < 20; ++k) {
            const Vec3 step = between(random, 0, 0.999) * depth * random_direction(random);
            ASSERT_EQ(reference_distance(points(a), points(moved(b, step))), 0) << i;
        }
    }
    EXPECT_GT(crossings, 500);
}

TEST(TrianglePair, CrossingDepthIsWhatSeparates) {
    const Corners floor{Vec3{-10, -10, 0}, {10, -10, 0}, {0, 20, 0}};
    const auto blade = [](double low, double high) { return Corners{Vec3{-1, 0, high}, {1, 0, high}, {0, 0, low}}; };
    EXPECT_NEAR(crossing_depth(floor, blade(-0.25, 1)), 0.25, 1e-12);
    EXPECT_NEAR(crossing_depth(floor, blade(-1, 0.25)), 0.25, 1e-12);
    EXPECT_EQ(crossing_depth(floor, blade(0, 1)), 0);              // a corner on the face
    EXPECT_EQ(crossing_depth(floor, blade(1, 0)), 0);              // an edge on the face
    EXPECT_EQ(crossing_depth(floor, blade(0.1, 1)), 0);            // apart
    EXPECT_EQ(crossing_depth(floor, floor), 0);                    // one face
    EXPECT_EQ(crossing_depth(floor, moved(floor, {1, 2, 0})), 0);  // faces in one plane
    // Edge against edge: the faces are long, the edges pass each other by 0.1.
    const Corners roof{Vec3{-50, 0, 0}, {50, 0, 0}, {0, 0, -50}};
    const Corners keel{Vec3{0, -50, -0.1}, {0, 50, -0.1}, {0, 0, 50}};
    EXPECT_NEAR(crossing_depth(roof, keel), 0.1, 1e-12);
}

TEST(TrianglePair, HeightIsThatOverTheLongestEdge) {
    EXPECT_NEAR(least_height({Vec3{0, 0, 0}, {10, 0, 0}, {5, 1e-8, 0}}), 1e-8, 1e-20);
    EXPECT_EQ(least_height({Vec3{0, 0, 0}, {10, 0, 0}, {5, 0, 0}}), 0);
    EXPECT_EQ(least_height({Vec3{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), 0);
}

}  // namespace
}  // namespace spectralpack::test
