/// Slides whose end is known: contacts that are flush, exactly at the gap, thin, open or too near to begin with.

#include <gtest/gtest.h>

#include "kernel_support.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::alone;
using test::along;
using test::slide;

TEST(SlideContact, AContactCountsThoughWhatIsKnownEndsBeforeTheFall) {
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

/// What boxes do is known: they stop where the sides are the gap apart, if they overlap across.
TEST(SlideContact, OfBoxesIsExactInEveryDirection) {
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
TEST(SlideContact, AlongAFaceAtExactlyTheGapIsFree) {
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
TEST(SlideContact, InAnExactlyFittingCorridor) {
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
TEST(SlideContact, TouchingFacesDoNotEnterEachOther) {
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

TEST(SlideContact, WallsOfNoThicknessStopIt) {
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

TEST(SlideContact, OpenMeshesBlockATouchingFaceEitherWay) {
    Mesh open = test::cube_mesh(4);
    open.triangles.pop_back();
    const Bvh a(open), b(test::box_mesh({-10, -10, -5}, {10, 10, 0}));
    EXPECT_LE(slide(a, {0, 0, 0}, b, {2, -1}, 0, 10), 1e-9);
    EXPECT_EQ(slide(a, {0, 0, 0}, b, {0, 1}, 0, 2), 2);
    EXPECT_EQ(slide(a, {0, 0, 0.2}, b, {2, 1}, 0.2, 10), 10);  // with a gap there is no doubt
}

TEST(SlideContact, TooNearToBeginWithItMayLeaveButComeNoNearer) {
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

TEST(SlideContact, WhatPartsOtherPairsDoesNotFreeOneThatOverlapsALittle) {
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

}  // namespace
}  // namespace spectralpack
