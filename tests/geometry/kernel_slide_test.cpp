/// Slides of random shapes, each judged another way as well.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "geometry/mesh_distance.hpp"
#include "kernel_support.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::alone;
using test::along;
using test::any_direction;
using test::Numbers;
using test::slide;

TEST(Slide, OfTwoTrianglesStopsAtTheFirstMomentAtTheGapAndNoEarlier) {
    int stopped = 0;
    for (std::uint64_t seed = 0; seed < 6000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2;
        const Corners a = numbers.triangle(coarse), b = numbers.triangle(coarse);
        const AxisDirection direction = any_direction(numbers);
        const Vec3 offset = along(direction, -6) + numbers.point(coarse) - numbers.point(coarse);
        const double gap = coarse ? 0.5 * static_cast<double>(1 + numbers.below(3)) : 2 * numbers.unit() + 1e-3;
        const double most = 14;
        const auto f = [&](double way) { return distance(test::moved(a, offset + along(direction, way)), b); };
        const double start = f(0);
        if (start < 1e-3) continue;
        const double way = slide(alone(a), offset, alone(b), direction, gap, most);
        ASSERT_GE(way, 0);
        ASSERT_LE(way, most);
        const double floor = std::min(gap, start) - 1e-9;
        for (int i = 0; i <= 40; ++i) {
            ASSERT_GE(f(way * i / 40), floor) << "seed " << seed;
        }
        if (way == most) continue;
        ++stopped;
        ASSERT_NEAR(f(way), test::quad_distance(test::moved(a, offset + along(direction, way)), b), 1e-11);
        if (start > gap) {
            ASSERT_LE(f(way), gap + kSlideSlack + 1e-11) << "seed " << seed;
        }
        // It had to stop: going on, f (convex) falls below the floor. Ternary search for its least
        // value.
        double low = way, high = most;
        for (int i = 0; i < 120; ++i) {
            const double one = low + (high - low) / 3, two = high - (high - low) / 3;
            (f(one) < f(two) ? high : low) = f(one) < f(two) ? two : one;
        }
        ASSERT_LT(f(low), std::min(gap, start) - kSlideTolerance / 20) << "seed " << seed;
    }
    EXPECT_GT(stopped, 1000);
}

TEST(Slide, OfManyContactsAtOnceIsTheLeastInAnyOrder) {
    int moved = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2;
        const double gap = seed % 3 == 0 ? 0 : 0.3;
        const AxisDirection direction = any_direction(numbers);
        const Corners a = numbers.triangle(coarse);
        // All a few slacks from contact, which each reaches in another way.
        std::vector<Bvh> still;
        for (int i = 0; i < 5; ++i) {
            Corners b = numbers.triangle(coarse);
            const double wanted = gap + 3 * numbers.unit() * kSlideSlack;
            if (i < 2) {  // a corner or a face ahead
                const auto ahead = [&](const Vec3& p) { return direction.sign * p[direction.axis]; };
                if (i == 0) b[1][direction.axis] = b[2][direction.axis] = b[0][direction.axis];
                const Vec3 foremost = *std::ranges::max_element(a, {}, ahead);
                const Vec3 nearest = *std::ranges::min_element(b, {}, ahead);
                still.push_back(alone(test::moved(b, foremost + along(direction, wanted) - nearest)));
                continue;
            }
            const ClosestPoints nearest = closest_points(a, b);
            if (nearest.distance < 1e-3) continue;
            still.push_back(alone(test::moved(b, (1 - wanted / nearest.distance) * nearest.apart())));
        }
        const Bvh moving = alone(a);
        double least = 1;
        for (const Bvh& one : still) {
            least = std::min(least, slide(moving, {}, one, direction, gap, 1));
        }
        moved += least > 0 && least < 1;
        for (std::size_t first = 0; first < still.size(); ++first) {
            std::atomic<double> free = 1;
            for (std::size_t i = 0; i < still.size(); ++i) {
                slide(moving, {}, still[(first + i) % still.size()], direction, gap, 1, free);
            }
            ASSERT_EQ(free, least) << "seed " << seed;
        }
    }
    EXPECT_GT(moved, 500);
}

TEST(Slide, OfMeshesIsTheLeastOverAllPairs) {
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        Numbers numbers(seed);
        Mesh soup[2];
        for (Mesh& mesh : soup) {
            for (std::uint32_t i = 0; i < 19; ++i) {
                const Corners t = test::moved(numbers.triangle(seed % 2), 2 * numbers.point(false));
                mesh.vertices.insert(mesh.vertices.end(), t.begin(), t.end());
                mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            }
        }
        const Bvh a(soup[0]), b(soup[1]);
        const AxisDirection direction = any_direction(numbers);
        const Vec3 offset = along(direction, -32 - 10 * numbers.unit()) + numbers.point(false);
        const double gap = seed % 3 == 0 ? 0 : 0.01 + numbers.unit();
        double least = 60;
        for (std::size_t i = 0; i < a.triangle_count(); ++i) {
            for (std::size_t j = 0; j < b.triangle_count(); ++j) {
                least = std::min(least, slide(alone(a.corners(i)), offset, alone(b.corners(j)), direction, gap, 60));
            }
        }
        const double way = slide(a, offset, b, direction, gap, 60);
        EXPECT_EQ(way, least) << "seed " << seed;
        // Halves of `still` that are asked about one after the other, in either order.
        Mesh halves[2];
        for (std::size_t j = 0; j < b.triangle_count(); ++j) {
            Mesh& half = halves[j % 2];
            const auto first = static_cast<std::uint32_t>(half.vertices.size());
            const Corners t = b.corners(j);
            half.vertices.insert(half.vertices.end(), t.begin(), t.end());
            half.triangles.push_back({first, first + 1, first + 2});
        }
        for (const int first : {0, 1}) {
            std::atomic<double> free = 60;
            for (const int half : {first, 1 - first}) {
                slide(a, offset, Bvh(halves[half]), direction, gap, 60, free);
            }
            EXPECT_EQ(free, least) << "seed " << seed;
        }
        // Parts of it, in either order; and of those none meets before it is said to.
        for (const std::size_t count : {1, 5, 1000}) {
            std::vector<SlidePart> parts = slide_parts(a, offset, b, direction, gap, 60, count);
            EXPECT_TRUE(parts.size() >= count || count == 1000 || way == 60) << "seed " << seed;
            EXPECT_TRUE(std::ranges::is_sorted(parts, {}, &SlidePart::earliest));
            for (int order = 0; order < 2; ++order) {
                std::atomic<double> free = 60;
                for (const SlidePart& part : parts) {
                    slide(a, offset, b, direction, gap, 60, free, part);
                    std::atomic<double> of_part = 60;
                    slide(a, offset, b, direction, gap, 60, of_part, part);
                    EXPECT_GE(of_part, std::min(60.0, part.earliest)) << "seed " << seed;
                }
                EXPECT_EQ(free, least) << "seed " << seed << " of " << parts.size() << " parts";
                std::ranges::reverse(parts);
            }
        }
        if (gap > 0 && way < 60) {
            const double d = least_distance(a, offset + along(direction, way), b, {}).distance;
            EXPECT_GE(d, gap - 1e-9);
            EXPECT_LE(d, gap + kSlideSlack + 1e-11);
        }
    }
}

TEST(Slide, AgreesWithDenseSamplingOnCurvedMeshes) {
    const Bvh ball(test::sphere_mesh(5, 7)), torus(test::torus_mesh(12, 4, 15, 9));
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Numbers numbers(seed);
        const AxisDirection d = any_direction(numbers);
        const Vec3 offset = 2 * numbers.point(false) + along(d, -25);
        const double gap = numbers.unit();
        if (least_distance(ball, offset, torus, {}).distance < gap) continue;
        const double way = slide(ball, offset, torus, d, gap, 50);
        double sampled = 50;
        for (double t = 0; t < 50; t += 0.01) {
            if (least_distance(ball, offset + along(d, t), torus, {}, gap).distance < gap - 1e-9) {
                sampled = t;
                break;
            }
        }
        EXPECT_LE(way, sampled + 1e-9) << seed;
        EXPECT_GE(way, sampled - 0.011) << seed;
    }
}

/// Back and forth and round a corner many times: the gap holds to the tolerance, whatever the
/// number of moves.
TEST(Slide, RepeatedMovesDoNotAddUp) {
    const Bvh ball(test::sphere_mesh(5)), torus(test::torus_mesh(12, 4, 24, 12));
    for (const double gap : {0.2, 1.3}) {
        Numbers numbers(static_cast<std::uint64_t>(10 * gap));
        Vec3 at{0, 1, 20};
        int moves = 0;
        for (int i = 0; i < 400; ++i) {
            AxisDirection d = any_direction(numbers);
            if (i % 4 == 0) d = {2, -1};
            const double way = slide(ball, at, torus, d, gap, 2);
            at = at + along(d, way);
            moves += way > 1e-9;
            ASSERT_GE(least_distance(ball, at, torus, {}).distance, gap - 1e-9) << i;
            for (int axis = 0; axis < 3; ++axis)
                at[axis] = std::clamp(at[axis], -25.0, 25.0);
        }
        EXPECT_GT(moves, 50);
    }
}

/// At gap 0 nothing may pass through: the ball that fell stands on the torus, and its surface
/// crosses nowhere.
TEST(Slide, AtGapNoughtSurfacesDoNotCross) {
    const Bvh ball(test::sphere_mesh(5, 7)), torus(test::torus_mesh(12, 4, 15, 9));
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Numbers numbers(seed);
        const Vec3 offset = 2 * numbers.point(false) + Vec3{0, 0, 25};
        const double way = slide(ball, offset, torus, {2, -1}, 0, 50);
        for (int i = 0; i < 200; ++i) {
            ASSERT_GT(least_distance(ball, offset - Vec3{0, 0, way * i / 200}, torus, {}, 1).distance, 0);
        }
        if (way < 50) {
            const double end = least_distance(ball, offset - Vec3{0, 0, way}, torus, {}).distance;
            EXPECT_LE(end, kSlideSlack);
            EXPECT_EQ(least_distance(ball, offset - Vec3{0, 0, way + 0.01}, torus, {}).distance, 0) << seed;
        }
    }
}

}  // namespace
}  // namespace spectralpack
