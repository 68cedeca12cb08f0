#include "verify/sweep.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "scenes.hpp"
#include "support/sanitized.hpp"
#include "verify/triangle_sweep.hpp"

namespace spectralpack::test {
namespace {

SweepResult sweep_meshes(const Mesh& a, const Mesh& b, const Vec3& move, const Transform& pose_a = {},
                         const Transform& pose_b = {}) {
    const Solid solid_a(a, {}, deep_enough(kTolerance)), solid_b(b, {}, deep_enough(kTolerance));
    return sweep({&solid_a, pose_a}, {&solid_b, pose_b}, move, kTolerance);
}

Mesh shifted(const Mesh& mesh, const Vec3& by) { return transformed(mesh, {Mat3{}, by}); }

/// Whether the meshes share points deeper than about the tolerance at any of many times of the move.
bool brute_force_overlap(const Mesh& a, const Mesh& b, const Vec3& move, int steps) {
    for (int i = 0; i <= steps; ++i) {
        if (!apart(compare_meshes(a, b, {Mat3{}, double(i) / steps * move}))) return true;
    }
    return false;
}

TEST(TriangleSweep, FindsTheDeepestCrossingOfAPassage) {
    // A wall in the plane x = 10; an upright triangle of 2 mm flies through its middle.
    const Corners wall{Vec3{10, -9, -9}, Vec3{10, 9, -9}, Vec3{10, 0, 9}};
    const Corners flyer{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 0, 1}};
    const TrianglePassage through = pass(flyer, wall, {50, 0, 0}, 1e-3);
    EXPECT_NEAR(through.depth, 1, 1e-6);  // half way through: 1 mm out to either side
    EXPECT_NEAR(through.at * 50, 9, 1e-3);
    EXPECT_EQ(pass(flyer, wall, {7.9, 0, 0}, 1e-3).depth, 0);
    EXPECT_EQ(pass(flyer, wall, {8.0009, 0, 0}, 1e-3).depth, 0);
    EXPECT_NEAR(pass(flyer, wall, {8.01, 0, 0}, 1e-3).depth, 0.01, 1e-6);
    EXPECT_EQ(pass(flyer, wall, {0, 50, 0}, 1e-3).depth, 0);
    EXPECT_EQ(pass(flyer, wall, {-50, 0, 0}, 1e-3).depth, 0);
}

TEST(TriangleSweep, DepthIsTheGreatestThatStandingTrianglesHaveOnTheWay) {
    RandomStream random(11);
    int crossings = 0;
    for (int round = 0; round < 400; ++round) {
        Corners a, b;
        for (int i = 0; i < 3; ++i) {
            a[i] = random_point(random, 2) - Vec3{5, 0, 0};
            b[i] = random_point(random, 2);
        }
        const Vec3 move{10, between(random, -1, 1), between(random, -1, 1)};
        double deepest = 0;
        for (int step = 0; step <= 1000; ++step) {
            Corners at = a;
            for (Vec3& corner : at) {
                corner = corner + step / 1000.0 * move;
            }
            deepest = std::max(deepest, crossing_depth(at, b));
        }
        const TrianglePassage passage = pass(a, b, move, 1e-3);
        EXPECT_GE(passage.depth + 1e-3, deepest) << round;
        EXPECT_LE(passage.depth, deepest + 0.011) << round;  // the samples are 0.01 mm apart
        crossings += passage.depth > 0;
    }
    EXPECT_GT(crossings, 100);
    EXPECT_LT(crossings, 390);
}

TEST(Sweep, SlidingAlongAContactIsAllowed) {
    const Mesh box = cube_mesh(10);
    for (const double overlap : {0.0, 1e-9, -1e-9, 9e-4}) {
        const Mesh neighbour = shifted(box, {10 - overlap, 0, 0});
        for (const Vec3& move : {Vec3{0, 0, 50}, Vec3{0, -50, 0}, Vec3{0, 30, 40}, Vec3{-50, 0, 0}, Vec3{-20, 3, 20}}) {
            EXPECT_EQ(sweep_meshes(box, neighbour, move).depth, 0) << overlap;
            EXPECT_EQ(sweep_meshes(neighbour, box, -move).depth, 0) << overlap;
        }
    }
}

TEST(Sweep, SlidingIntoAContactIsSeenAtAHundredthOfAMillimetre) {
    const Mesh box = cube_mesh(10), neighbour = shifted(box, {10, 0, 0});
    EXPECT_GT(sweep_meshes(box, neighbour, {0.01, 0, 0}).depth, kTolerance);
    EXPECT_GT(sweep_meshes(box, neighbour, {0.01, 0, 5}).depth, kTolerance);
    EXPECT_EQ(sweep_meshes(box, neighbour, {0.0009, 0, 5}).depth, 0);
    // A step 0.01 mm too high on the way.
    const Mesh floor = merged(box_mesh({0, 0, -1}, {20, 10, 0}), box_mesh({20, 0, -1}, {40, 10, 0.01}));
    EXPECT_NEAR(sweep_meshes(box, floor, {30, 0, 0}).depth, 0.01, 1e-6);
    EXPECT_NEAR(sweep_meshes(box, floor, {30, 0, 0}).travelled, 20, 10.1);
}

TEST(Sweep, NothingTunnelsThroughAThinWall) {
    const Mesh box = cube_mesh(10);
    for (const double thickness : {1e-2, 0.1, 1.0}) {
        const Mesh wall = box_mesh({50, -20, -20}, {50 + thickness, 30, 30});
        EXPECT_GT(sweep_meshes(box, wall, {1000, 0, 0}).depth, kTolerance) << thickness;
        EXPECT_GT(sweep_meshes(box, wall, {1000, 7, -3}).depth, kTolerance) << thickness;
        EXPECT_GT(sweep_meshes(wall, box, {-1000, 0, 0}).depth, kTolerance) << thickness;
        EXPECT_EQ(sweep_meshes(box, wall, {0, 0, 1000}).depth, 0) << thickness;
    }
}

TEST(Sweep, WhatIsAlignedIsSeenThough) {
    // Equal boxes in a line: every pair of triangles is flat, parallel to the move, or meets in an edge.
    const Mesh box = cube_mesh(10);
    for (const Vec3& at : {Vec3{30, 0, 0}, Vec3{30, 10 - 0.01, 0}, Vec3{30, 5, 0}}) {
        EXPECT_GT(sweep_meshes(box, shifted(box, at), {100, 0, 0}).depth, kTolerance) << at.y;
        EXPECT_GT(sweep_meshes(box, shifted(box, at), {20.01, 0, 0}).depth, kTolerance) << at.y;
        EXPECT_EQ(sweep_meshes(box, shifted(box, at), {20, 0, 0}).depth, 0) << at.y;
    }
    EXPECT_EQ(sweep_meshes(box, shifted(box, {30, 10, 0}), {100, 0, 0}).depth, 0);
    // In contact from the start.
    EXPECT_GT(sweep_meshes(box, shifted(box, {10, 0, 0}), {100, 0, 0}).depth, kTolerance);
    EXPECT_GT(sweep_meshes(box, shifted(box, {10 - 9e-4, 0, 0}), {100, 0, 0}).depth, kTolerance);
    EXPECT_EQ(sweep_meshes(box, shifted(box, {10, 0, 0}), {-100, 0, 0}).depth, 0);
    // One prong of three meets its equal, the deep points of both lie elsewhere.
    const Mesh prongs = block_mesh({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 2, 0}});
    const Mesh others = block_mesh({{5, 2, 0}, {5, 4, 0}, {6, 2, 0}, {6, 3, 0}, {6, 4, 0}}, true);
    EXPECT_GT(sweep_meshes(prongs, others, {4, 0, 0}).depth, kTolerance);
    EXPECT_EQ(sweep_meshes(prongs, others, {3, 0, 0}).depth, 0);
}

TEST(Sweep, TinyStepsDoNotCreepIn) {
    const Mesh box = cube_mesh(10), other = shifted(box, {10, 0, 0});
    bool found = false;
    for (int step = 0; step < 40 && !found; ++step) {
        found = sweep_meshes(box, other, {2e-4, 0, 0}, {Mat3{}, {step * 2e-4, 0, 0}}).depth > 0;
    }
    EXPECT_TRUE(found);
}

TEST(Sweep, ALooseRingComesOffItsPinOneWayOnly) {
    const Mesh ring = torus_mesh(10, 2), pin = box_mesh({-5, -5, -20}, {5, 5, 20});
    const Mesh head = box_mesh({-9, -9, -25}, {9, 9, -20});
    EXPECT_EQ(sweep_meshes(ring, merged(pin, head), {0, 0, 100}).depth, 0);
    EXPECT_GT(sweep_meshes(ring, merged(pin, head), {0, 0, -100}).depth, 0.5);
    EXPECT_GT(sweep_meshes(ring, merged(pin, head), {100, 0, 0}).depth, 0.5);
}

/// Against comparing at 40 times, on block solids in lattice positions (contacts and alignments galore).
TEST(Sweep, AgreesWithFineStepsOnLatticeBlocks) {
    RandomStream random(5);
    int met = 0;
    const int rounds = trials(150);
    for (int round = 0; round < rounds; ++round) {
        const Mesh a = block_mesh(random_cells(random, {2, 3, 2}, 0.6), random.unit() < 0.5);
        const Mesh b = shifted(block_mesh(random_cells(random, {3, 2, 3}, 0.6), random.unit() < 0.5),
                               {double(int(between(random, -4, 5))), double(int(between(random, -4, 5))),
                                double(int(between(random, 2, 6)))});
        if (!apart(compare_meshes(a, b))) continue;
        Vec3 move{0, 0, between(random, 3, 9)};
        if (random.unit() < 0.4) move = {between(random, -4, 4), 0, between(random, 3, 9)};
        if (random.unit() < 0.4) move = {double(int(between(random, -4, 5))), double(int(between(random, -4, 5))), 5};
        const SweepResult result = sweep_meshes(a, b, move);
        EXPECT_EQ(result.depth > 0, brute_force_overlap(a, b, move, 40)) << round << ": " << result.depth;
        met += result.depth > 0;
    }
    EXPECT_GT(met, rounds / 6);
    EXPECT_LT(met, rounds * 5 / 6);
}

/// In general position: steps are fine, so a difference must be a graze that falls between two of them.
TEST(Sweep, AgreesWithFineStepsOnTurnedSolids) {
    RandomStream random(6);
    int met = 0, grazes = 0;
    const int rounds = 80, steps = 60;
    for (int round = 0; round < rounds; ++round) {
        const Mesh shapes[] = {torus_mesh(3, 1, 10, 6), block_mesh(random_cells(random, {2, 2, 3}, 0.7)),
                               sphere_mesh(2, 5), box_mesh({0, 0, 0}, {4, 3, 0.05})};
        const auto pick = [&]() -> const Mesh& { return shapes[static_cast<std::size_t>(4 * random.unit())]; };
        const Mesh a = transformed(pick(), {random_rotation(random), {}});
        const Mesh b = transformed(pick(), {random_rotation(random), 8 * random_direction(random)});
        if (!apart(compare_meshes(a, b))) continue;
        const Vec3 move = between(random, 6, 16) * random_direction(random) + Vec3{0, 0, 0.3};
        const Vec3 aim =
            between(random, 0.5, 2) * (bounding_box(b).min - bounding_box(a).min) + random_point(random, 2);
        const Vec3 way = random.unit() < 0.7 ? aim : move;
        const SweepResult result = sweep_meshes(a, b, way);
        const bool stepped = brute_force_overlap(a, b, way, steps);
        EXPECT_TRUE(result.depth > 0 || !stepped) << round;
        if (result.depth > 0 && !stepped) {
            // It must be there at the time that the sweep names, and too short to be hit by a step.
            const double at = result.travelled / length(way);
            EXPECT_FALSE(apart(compare_meshes(a, b, {Mat3{}, at * way}))) << round;
            ++grazes;
        }
        met += result.depth > 0;
    }
    EXPECT_GT(met, rounds / 6);
    EXPECT_LT(grazes, rounds / 8);
}

TEST(Sweep, PosesAreHeeded) {
    RandomStream random(7);
    for (int round = 0; round < 30; ++round) {
        const Mesh a = torus_mesh(3, 1, 8, 5), b = cube_mesh(3);
        const Transform pose_a{random_rotation(random), random_point(random, 5)};
        const Transform pose_b{random_rotation(random), random_point(random, 5) + Vec3{12, 0, 0}};
        const Vec3 move = Vec3{12, 0, 0} + random_point(random, 5);
        const double posed = sweep_meshes(a, b, move, pose_a, pose_b).depth;
        const double baked = sweep_meshes(transformed(a, pose_a), transformed(b, pose_b), move).depth;
        EXPECT_NEAR(posed, baked, 1e-6);
    }
}

}  // namespace
}  // namespace spectralpack::test
