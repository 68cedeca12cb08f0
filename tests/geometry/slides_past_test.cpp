#include "geometry/slides_past.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/meeting_interval.hpp"
#include "geometry/triangle_distance.hpp"
#include "kernel_support.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::alone;
using test::along;
using test::any_direction;
using test::Numbers;
using test::slide;

/// slides_past() for a graze of kTouchTolerance, by the kernel that iterates; none where its answer hangs on rounding.
std::optional<bool> slid_past(const Bvh& a, const Vec3& offset, const Bvh& b, AxisDirection direction, double way) {
    constexpr double kDoubt = 2e-5;
    const double free = slide(a, offset, b, direction, 0, way + kDoubt);
    if (std::abs(free - way) < kDoubt) return std::nullopt;
    return free >= way;
}

TEST(MeetingInterval, HoldsTheWaysOfNoDistance) {
    int met = 0, thin = 0;
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2;
        const Corners a = numbers.triangle(coarse), b = numbers.triangle(coarse);
        const AxisDirection direction = any_direction(numbers);
        const Vec3 offset = coarse ? Vec3{} : numbers.point(false);
        const SeenTriangle one(a, offset, direction), other(b, {}, direction);
        const auto f = [&](double way) { return distance(test::moved(a, offset + along(direction, way)), b); };
        if (!shadows_overlap(one, other, 1e-4)) continue;
        const MeetingInterval meeting = meeting_interval(one, other);
        ASSERT_LE(meeting.enter, meeting.leave) << seed;
        for (const double share : {0.0, 0.01, 0.3, 0.5, 0.99, 1.0}) {
            ASSERT_LE(f(meeting.enter + share * (meeting.leave - meeting.enter)), 1e-6) << seed << " " << share;
        }
        // Beyond it they are apart; by how much depends on how steep they are.
        for (const double beyond : {1e-3, 0.1}) {
            ASSERT_GT(f(meeting.enter - beyond), 1e-9) << seed;
            ASSERT_GT(f(meeting.leave + beyond), 1e-9) << seed;
        }
        ++met;
        thin += one.facing() == 0 && other.facing() == 0;
    }
    EXPECT_GT(met, 3000);
    EXPECT_GT(thin, 100) << "both edge on";
}

TEST(MeetingInterval, OfShadowsThatOverlapNoMoreThanTheGrazeIsNotAskedFor) {
    const AxisDirection up{2, 1};
    const Corners a{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    for (const double overlap : {-1.0, 0.0, 0.01, 0.5}) {
        const SeenTriangle one(a, {}, up), beside(a, {overlap - 4, 0, 3}, up);
        EXPECT_EQ(shadows_overlap(one, beside, 0.02), overlap > 0.02);
        EXPECT_EQ(shadows_overlap(beside, one, 0.02), overlap > 0.02);
    }
    // A wall on its edge through the middle of a face does overlap, two walls in one plane do not.
    const SeenTriangle face(a, {}, up), wall({{{1, 1, 0}, {2, 1, 0}, {1, 1, 5}}}, {}, up);
    const SeenTriangle point({{{1, 1, 0}, {1, 1, 2}, {1, 1, 5}}}, {}, up);
    EXPECT_TRUE(shadows_overlap(face, wall, 1e-3));
    EXPECT_TRUE(shadows_overlap(face, point, 1e-3));
    EXPECT_FALSE(shadows_overlap(wall, wall, 0));
    EXPECT_FALSE(shadows_overlap(point, point, 0));
}

TEST(SlidesPast, OfTwoTrianglesIsWhatSlideSays) {
    int blocked = 0, free = 0;
    for (std::uint64_t seed = 0; seed < 150000; ++seed) {
        Numbers numbers(seed);
        const bool coarse = seed % 2;
        const Bvh a = alone(numbers.triangle(coarse)), b = alone(numbers.triangle(coarse));
        const AxisDirection direction = any_direction(numbers);
        // Also from contact, and from a little overlap.
        Vec3 offset = numbers.point(coarse) - numbers.point(coarse);
        if (seed % 3 == 0) offset = offset + along(direction, -6);
        if (seed % 5 == 0) offset = offset + along(direction, 9e-4 * numbers.unit());
        const double way = coarse ? static_cast<double>(1 + numbers.below(8)) + 0.5 : 12 * numbers.unit();
        const std::optional<bool> slid = slid_past(a, offset, b, direction, way);
        if (!slid) continue;
        ++(*slid ? free : blocked);
        ASSERT_EQ(slides_past(a, offset, b, direction, kTouchTolerance, way), *slid) << "seed " << seed;
    }
    EXPECT_GT(blocked, 5000);
    EXPECT_GT(free, 5000);
}

TEST(SlidesPast, OfMeshesIsWhatSlideSays) {
    // Blocks on a lattice touch with faces, edges and corners; balls and rings are steep somewhere.
    const Mesh block = test::box_mesh({0, 0, 0}, {4, 6, 8});
    const Mesh frame = test::merged(test::box_mesh({0, 0, 0}, {8, 2, 4}), test::box_mesh({0, 2, 0}, {2, 8, 4}));
    Mesh open = test::cube_mesh(4);
    open.triangles.pop_back();
    const std::vector<Mesh> meshes{block,
                                   frame,
                                   open,
                                   test::turned_inside_out(test::cube_mesh(4)),
                                   test::sphere_mesh(4, 7),
                                   test::torus_mesh(6, 2, 15, 9),
                                   test::box_mesh({1, -20, -20}, {1, 20, 20})};
    std::vector<Bvh> trees;
    for (const Mesh& mesh : meshes) {
        trees.emplace_back(mesh);
    }
    int blocked = 0, free = 0;
    for (std::uint64_t seed = 0; seed < 10000; ++seed) {
        Numbers numbers(seed);
        const Bvh &a = trees[numbers.below(trees.size())], &b = trees[numbers.below(trees.size())];
        const AxisDirection direction = any_direction(numbers);
        Vec3 offset = seed % 2 ? 2 * numbers.point(false) : 2 * (numbers.point(true) - numbers.point(true));
        if (seed % 4 == 3) offset = offset + along(direction, 5e-4);
        const double way = seed % 2 ? 25 * numbers.unit() : 2.0 * static_cast<double>(1 + numbers.below(10));
        const std::optional<bool> slid = slid_past(a, offset, b, direction, way);
        if (!slid) continue;
        ++(*slid ? free : blocked);
        ASSERT_EQ(slides_past(a, offset, b, direction, kTouchTolerance, way), *slid) << "seed " << seed;
    }
    EXPECT_GT(blocked, 1000);
    EXPECT_GT(free, 1000);
}

TEST(SlidesPast, LetsPassWhatOverlapsSidewaysByTheGraze) {
    const Bvh box(test::cube_mesh(4));
    for (const AxisDirection d : {AxisDirection{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}) {
        for (const double overlap : {-1e-3, 0.0, 7e-4, 9e-4}) {
            Vec3 offset = along(d, -10);
            offset[(d.axis + 1) % 3] = 4 - overlap;
            EXPECT_EQ(slides_past(box, offset, box, d, 8e-4, 20), overlap <= 8e-4) << overlap;
        }
    }
}

TEST(SlidesPast, MayEndWhereTheyTouch) {
    const Bvh box(test::cube_mesh(4));
    for (const AxisDirection d : {AxisDirection{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}) {
        for (const double start : {0.1, 0.7, 123.4}) {
            Vec3 offset = along(d, -4 - start);
            EXPECT_TRUE(slides_past(box, offset, box, d, 8e-4, start));
            EXPECT_FALSE(slides_past(box, offset, box, d, 8e-4, start + 2e-6));
            EXPECT_TRUE(slides_past(box, offset, box, {d.axis, -d.sign}, 8e-4, 500));
        }
        EXPECT_FALSE(slides_past(box, along(d, -4), box, d, 8e-4, 20));
        EXPECT_TRUE(slides_past(box, along(d, -4), box, {(d.axis + 1) % 3, 1}, 8e-4, 20));
        EXPECT_TRUE(slides_past(box, along(d, 4 - 9e-4), box, d, 8e-4, 20)) << "out of a little overlap";
        EXPECT_FALSE(slides_past(box, along(d, -4 + 9e-4), box, d, 8e-4, 20)) << "and not further in";
    }
}

}  // namespace
}  // namespace spectralpack
