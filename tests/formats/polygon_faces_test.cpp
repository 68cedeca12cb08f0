#include "formats/polygon_faces.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/random.hpp"

namespace spectralpack {
namespace {

/// Areas, as seen along +z.
struct Filled {
    double signed_area = 0, total_area = 0;
    std::size_t count = 0;
};

Filled fill(const std::vector<Vec3>& loop_points) {
    std::vector<std::uint32_t> loop(loop_points.size());
    std::iota(loop.begin(), loop.end(), 0u);
    std::vector<Triangle> triangles;
    EXPECT_TRUE(triangulate(loop_points, loop, triangles));
    Filled filled;
    filled.count = triangles.size();
    for (const Triangle& t : triangles) {
        const double area = cross(loop_points[t[1]] - loop_points[t[0]], loop_points[t[2]] - loop_points[t[0]]).z / 2;
        filled.signed_area += area;
        filled.total_area += std::abs(area);
    }
    return filled;
}

double shoelace(const std::vector<Vec3>& loop) {
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        area += cross(loop[i], loop[(i + 1) % loop.size()]).z / 2;
    }
    return area;
}

/// Triangles that overlap or leave the outline would make the total area larger than the polygon's.
void expect_exact_fill(const std::vector<Vec3>& loop) {
    const Filled filled = fill(loop);
    EXPECT_EQ(filled.count, loop.size() - 2);
    EXPECT_NEAR(filled.signed_area, shoelace(loop), 1e-9 * filled.total_area);
    EXPECT_NEAR(filled.total_area, std::abs(shoelace(loop)), 1e-9 * filled.total_area);
}

TEST(Triangulate, ConcavePolygonsAreFilledExactly) {
    const std::vector<Vec3> ell{{0, 0, 0}, {30, 0, 0}, {30, 10, 0}, {10, 10, 0}, {10, 30, 0}, {0, 30, 0}};
    for (std::size_t start = 0; start < ell.size(); ++start) {
        std::vector<Vec3> turned(ell);
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
        expect_exact_fill(turned);
        std::reverse(turned.begin(), turned.end());
        expect_exact_fill(turned);
    }
}

TEST(Triangulate, AHoleJoinedByACutStaysAHole) {
    expect_exact_fill({{0, 0, 0},
                       {30, 0, 0},
                       {30, 30, 0},
                       {0, 30, 0},
                       {0, 0, 0},
                       {10, 10, 0},
                       {10, 20, 0},
                       {20, 20, 0},
                       {20, 10, 0},
                       {10, 10, 0}});
}

TEST(Triangulate, ACombAndASpiralAreFilledExactly) {
    std::vector<Vec3> comb{{0, 0, 0}};
    for (int i = 0; i < 40; ++i) {
        comb.push_back({2.0 * i + 1, 0, 0});
        comb.push_back({2.0 * i + 1, 10, 0});
        comb.push_back({2.0 * i + 2, 10, 0});
        comb.push_back({2.0 * i + 2, 0, 0});
    }
    comb.push_back({81, 0, 0});
    comb.push_back({81, -1, 0});
    comb.push_back({0, -1, 0});
    std::reverse(comb.begin(), comb.end());
    expect_exact_fill(comb);
    std::vector<Vec3> spiral;
    for (int i = 0; i < 200; ++i) {
        const double angle = 0.1 * i;
        spiral.push_back({(1 + angle) * std::cos(angle), (1 + angle) * std::sin(angle), 0});
    }
    for (int i = 199; i >= 0; --i) {
        const double angle = 0.1 * i;
        spiral.push_back({(3 + angle) * std::cos(angle), (3 + angle) * std::sin(angle), 0});
    }
    expect_exact_fill(spiral);
}

TEST(Triangulate, StarShapedPolygonsAreFilledExactly) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        const auto corners = 4 + random.below(40);
        std::vector<Vec3> loop;
        for (std::uint64_t i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
            const double radius = 1 + 9 * random.unit();
            loop.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
        }
        const Filled filled = fill(loop);
        RC_ASSERT(filled.count == loop.size() - 2);
        RC_ASSERT(std::abs(filled.total_area - shoelace(loop)) < 1e-9 * filled.total_area);
    }));
}

TEST(Triangulate, PolygonsThatMakeNoSenseStillEnd) {
    EXPECT_EQ(fill({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).count, 2u);  // crosses itself
    EXPECT_EQ(fill({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}).count,
              3u);                                                            // no area
    EXPECT_EQ(fill({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).count, 2u);  // one point
    EXPECT_EQ(fill({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, -2, 0}, {0, 4, 0}, {9, 9, 0}}).count, 4u);
}

TEST(Triangulate, AHugeConcaveFaceIsRefusedAHugeConvexOneIsNot) {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 20'000;
        points.push_back({std::cos(angle), std::sin(angle), 0});
        loop.push_back(i);
    }
    std::vector<Triangle> triangles;
    EXPECT_TRUE(triangulate(points, loop, triangles));
    EXPECT_EQ(triangles.size(), 19'998u);
    points[7] = {0, 0, 0};
    EXPECT_FALSE(triangulate(points, loop, triangles));
}

}  // namespace
}  // namespace spectralpack
