#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "geometry/mesh_distance.hpp"
#include "geometry/slide.hpp"
#include "kernel_support.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::along;
using test::Numbers;
using test::slide;

Bvh alone(const Corners& t) { return Bvh(Mesh{{t.begin(), t.end()}, {{0, 1, 2}}}); }

AxisDirection any_direction(Numbers& numbers) {
    return {static_cast<int>(numbers.below(3)), numbers.below(2) ? 1 : -1};
}

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

TEST(Slide, AContactCountsThoughWhatIsKnownEndsBeforeTheFall) {
    // Above a plane that rises by a millionth: half a slack from the gap after 1.5 mm, under it after 2; a wall after
    // 1.8 mm.
    constexpr double kGap = 0.2, kRise = 1e-6, kAtMost = 10;
    const auto under = [](double x, double y) { return Vec3{x, y, -(kGap + 3 * kRise) + kRise * x}; };
    const Bvh moving = alone({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}});
    const Bvh plane = alone({under(-50, -50), under(100, -50), under(0, 100)});
    const Bvh wall = alone({Vec3{2.8 + kGap, -5, -0.1}, Vec3{2.8 + kGap, 5, -0.1}, Vec3{2.8 + kGap, 0, 5}});
    const AxisDirection ahead{0, 1};
    const double to_plane = slide(moving, {}, plane, ahead, kGap, kAtMost);
    EXPECT_NEAR(to_plane, 1.5, 0.01);
    EXPECT_NEAR(slide(moving, {}, wall, ahead, kGap, kAtMost), 1.8, 1e-5);
    for (const bool plane_first : {true, false}) {
        std::atomic<double> free = kAtMost;
        slide(moving, {}, plane_first ? plane : wall, ahead, kGap, kAtMost, free);
        slide(moving, {}, plane_first ? wall : plane, ahead, kGap, kAtMost, free);
        EXPECT_EQ(free, to_plane);
    }
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

/// What boxes do is known: they stop where the sides are the gap apart, if they overlap across.
TEST(Slide, OfBoxesIsExactInEveryDirection) {
    const Vec3 size{4, 6, 8};
    const Bvh box(test::box_mesh({0, 0, 0}, size));
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            for (const double gap : {0.0, 0.2, 1.0}) {
                for (const double sideways : {0.0, 1.0, -3.0}) {
                    Vec3 offset;
                    offset[(axis + 1) % 3] = sideways;
                    offset[axis] = -sign * (size[axis] + 5);
                    const double way = slide(box, offset, box, {axis, sign}, gap, 20);
                    EXPECT_NEAR(way, 5 - gap, 2e-6) << axis << sign << gap << sideways;
                    EXPECT_LE(way, 5 - gap + 1e-12);
                    EXPECT_EQ(slide(box, offset, box, {axis, sign}, gap, 3),
                              3);                                                    // as far as is asked
                    EXPECT_EQ(slide(box, offset, box, {axis, -sign}, gap, 20), 20);  // away
                }
                Vec3 beside;
                beside[axis] = -sign * (size[axis] + 5);
                beside[(axis + 1) % 3] = size[(axis + 1) % 3] + gap;  // passes exactly at the gap
                EXPECT_EQ(slide(box, beside, box, {axis, sign}, gap, 40), 40);
                if (gap > 0) {
                    beside[(axis + 1) % 3] -= 1e-6;  // and just within it
                    EXPECT_LT(slide(box, beside, box, {axis, sign}, gap, 40), 6);
                }
            }
        }
    }
}

/// Resting on a floor of two boxes, flush, at exactly the gap: free along the floor, over the
/// joint, and up; not down.
TEST(Slide, AlongAFaceAtExactlyTheGapIsFree) {
    const Bvh box(test::box_mesh({0, 0, 0}, {4, 6, 8}));
    const Bvh floor(
        test::merged(test::box_mesh({-20, -20, -5}, {1, 20, 0}), test::box_mesh({1, -20, -5}, {20, 20, 0})));
    const Bvh wide(test::box_mesh({-20, -20, -5}, {20, 20, 0}));
    for (const double gap : {0.0, 0.2, 0.3, 1.0, 1e-3}) {
        for (const Bvh* below : {&floor, &wide}) {
            const Vec3 rest{0.1, 0.7, gap};
            for (const AxisDirection d : {AxisDirection{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}}) {
                EXPECT_EQ(slide(box, rest, *below, d, gap, 30), 30) << gap << d.axis << d.sign;
            }
            EXPECT_LE(slide(box, rest, *below, {2, -1}, gap, 30), 1e-9) << gap;
        }
    }
}

/// The walls of a corridor as wide as the box and two gaps, corners and edges meeting exactly.
TEST(Slide, InAnExactlyFittingCorridor) {
    const Bvh box(test::box_mesh({0, 0, 0}, {4, 6, 8}));
    for (const double gap : {0.0, 0.25}) {
        const Bvh corridor(test::merged(test::box_mesh({-50, 0, -gap - 1}, {50, 6, -gap}),
                                        test::box_mesh({-50, 0, 8 + gap}, {50, 6, 9 + gap})));
        EXPECT_EQ(slide(box, {0, 0, 0}, corridor, {0, 1}, gap, 20), 20);
        EXPECT_EQ(slide(box, {0, 0, 0}, corridor, {1, -1}, gap, 20), 20);
        EXPECT_LE(slide(box, {0, 0, 0}, corridor, {2, 1}, gap, 20), 1e-9);
        EXPECT_LE(slide(box, {0, 0, 0}, corridor, {2, -1}, gap, 20), 1e-9);
    }
}

/// Equal boxes with coinciding faces, edges and corners, triangulated alike or not: nothing may
/// enter.
TEST(Slide, TouchingFacesDoNotEnterEachOther) {
    const Mesh cube = test::cube_mesh(4);
    Mesh flipped = cube;  // mirrored at its middle: the other diagonals
    for (Vec3& v : flipped.vertices)
        v.x = 4 - v.x;
    flipped = test::turned_inside_out(flipped);
    for (const Mesh& other : {cube, flipped}) {
        const Bvh a(cube), b(other);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int sign : {-1, 1}) {
                const Vec3 beside = along({axis, sign}, -4);
                EXPECT_LE(slide(a, beside, b, {axis, sign}, 0, 20), 1e-9);
                EXPECT_EQ(slide(a, beside, b, {axis, -sign}, 0, 20), 20);
                for (const int turn : {-1, 1}) {
                    EXPECT_EQ(slide(a, beside, b, {(axis + 1) % 3, turn}, 0, 20), 20);
                }
                Vec3 shifted = beside;
                shifted[(axis + 2) % 3] = 1.5;
                EXPECT_LE(slide(a, shifted, b, {axis, sign}, 0, 20), 1e-9);
                EXPECT_EQ(slide(a, shifted, b, {axis, -sign}, 0, 20), 20);
            }
        }
    }
}

TEST(Slide, WallsOfNoThicknessStopIt) {
    const Bvh box(test::box_mesh({0, 0, 0}, {4, 6, 8}));
    Mesh sheet = test::box_mesh({10, -20, -20}, {10, 20, 20});  // both faces at x = 10, sides of zero area
    const Mesh needle = test::box_mesh({10, 3, -20}, {10, 3 + 1e-9, 20});
    Mesh single{{{10, -20, -20}, {10, 40, -20}, {10, -20, 40}}, {{0, 1, 2}}};
    for (const Mesh& wall : {sheet, needle, single, test::turned_inside_out(single)}) {
        for (const double gap : {0.0, 0.2, 1e-5, 3.0}) {
            const double way = slide(box, {0, 0, 0}, Bvh(wall), {0, 1}, gap, 100);
            const bool too_thin_to_touch = gap == 0 && wall.vertices == needle.vertices;
            if (too_thin_to_touch) continue;  // thinner than the sideways tolerance of gap 0
            EXPECT_LE(way, 6 - gap + 1e-12) << gap;
            EXPECT_GE(way, 6 - gap - 2e-6) << gap;
        }
    }
}

TEST(Slide, OpenMeshesBlockATouchingFaceEitherWay) {
    Mesh open = test::cube_mesh(4);
    open.triangles.pop_back();
    const Bvh a(open), b(test::box_mesh({-10, -10, -5}, {10, 10, 0}));
    EXPECT_LE(slide(a, {0, 0, 0}, b, {2, -1}, 0, 10), 1e-9);
    EXPECT_EQ(slide(a, {0, 0, 0}, b, {0, 1}, 0, 2), 2);
    EXPECT_EQ(slide(a, {0, 0, 0.2}, b, {2, 1}, 0.2, 10), 10);  // with a gap there is no doubt
}

TEST(Slide, TooNearToBeginWithItMayLeaveButComeNoNearer) {
    const Bvh box(test::cube_mesh(4));
    const double gap = 0.2, start = 0.2 - 3e-4;
    const Vec3 beside{-4 - start, 0, 0};
    EXPECT_LE(slide(box, beside, box, {0, 1}, gap, 10), 1e-9);
    EXPECT_EQ(slide(box, beside, box, {0, -1}, gap, 10), 10);
    EXPECT_EQ(slide(box, beside, box, {1, 1}, start, 10), 10);
    // Overlapping by a little at gap 0, as voxels allow: out, or along, but not further in.
    const Vec3 within{-4 + 3e-4, 0, 0};
    EXPECT_EQ(slide(box, within, box, {0, 1}, 0, 10), 0);
    EXPECT_EQ(slide(box, within, box, {0, -1}, 0, 10), 10);
    const Vec3 shifted{-4 + 3e-4, 1, -2};
    EXPECT_EQ(slide(box, shifted, box, {0, 1}, 0, 10), 0);
    EXPECT_EQ(slide(box, shifted, box, {0, -1}, 0, 10), 10);
    // Crossing, it stays.
    EXPECT_EQ(slide(box, {-2, 1, 1}, box, {0, -1}, gap, 10), 0);
}

TEST(Slide, WhatPartsOtherPairsDoesNotFreeOneThatOverlapsALittle) {
    const Vec3 within{-4 + 3e-4, 0, 0};
    // Far beside the boxes, long edges that have passed one another already: apart nearly along the move, a little
    // across it, so that their boxes still overlap.
    constexpr double kPast = 1.5e-3, kTilt = 5e-5, kLong = 50;
    Mesh with_edges[2];
    for (Mesh& mesh : with_edges) {
        mesh = test::cube_mesh(4);
        const bool moves = &mesh == &with_edges[0];
        const double side = moves ? 1 : -1;
        for (int i = 0; i < 16; ++i) {
            const Vec3 at = Vec3{moves ? kPast : 0, 300.0 + 300 * i, 2} - (moves ? within : Vec3{});
            const Vec3 edge = kLong * Vec3{-kTilt, 1, side}, away = kLong * Vec3{side, side, -1};
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const Vec3& corner : {at - edge, at + edge, at + away}) {
                mesh.vertices.push_back(corner);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
    }
    const Bvh moving(with_edges[0], true), still(with_edges[1], true);
    EXPECT_EQ(slide(moving, within, still, {0, 1}, 0, 10), 0);
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
