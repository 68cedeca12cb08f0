/// Random pairs, each judged another way as well.

#include "verify/overlap.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "scenes.hpp"

namespace spectralpack::test {
namespace {

TEST(OverlapOfRandom, BlocksAgreeWithTheirCells) {
    // All faces in common planes, tens of contacts a pair: exact by counting cells. Offsets are half cells, and a
    // little more or less than the tolerance.
    RandomStream random(5);
    const double offsets[] = {-5 * kTolerance, -0.4 * kTolerance, 0, 0.4 * kTolerance, 5 * kTolerance};
    int overlaps = 0, slight = 0;
    constexpr int kPairs = 400;
    for (int pair = 0; pair < kPairs; ++pair) {
        const Cells a = random_cells(random, {3, 2, 4}, 0.6), b = random_cells(random, {2, 3, 3}, 0.6);
        const Vec3 step{(int(random.below(11)) - 5) / 2.0 + offsets[random.below(5)],
                        (int(random.below(11)) - 5) / 2.0 + offsets[random.below(5)],
                        (int(random.below(15)) - 6) / 2.0 + offsets[random.below(5)]};
        double distance = kFar, deepest = 0;
        for (const Cell& cell : a) {
            for (const Cell& other : b) {
                Vec3 gap;
                double depth = kFar;
                for (int axis = 0; axis < 3; ++axis) {
                    const double between = std::abs(cell[axis] - other[axis] - step[axis]) - 1;
                    gap[axis] = std::max(between, 0.0);
                    depth = std::min(depth, -between);
                }
                distance = std::min(distance, length(gap));
                deepest = std::max(deepest, depth);
            }
        }
        const bool shared = deepest > kTolerance;
        const Transform common =
            random.below(2) == 1 ? Transform{random_rotation(random), random_point(random, 100)} : Transform{};
        const Relation relation =
            compare_meshes(block_mesh(a), block_mesh(b, random.below(2) == 1), common, common * moved_by(step));
        EXPECT_EQ(apart(relation), !shared) << "pair " << pair;
        if (shared) {
            EXPECT_GT(relation.depth, deepest / 4) << "pair " << pair;
        } else {
            EXPECT_NEAR(relation.distance, distance, 1e-9) << "pair " << pair;
        }
        overlaps += shared;
        slight += shared && deepest < 0.1;
    }
    EXPECT_GT(overlaps, kPairs / 5);
    EXPECT_LT(overlaps, 4 * kPairs / 5);
    EXPECT_GT(slight, kPairs / 50);
}

TEST(OverlapOfRandom, ConvexSolidsAgreeWithSeparatingAxes) {
    RandomStream random(8);
    for (int pair = 0; pair < 200; ++pair) {
        const auto shape = [&] {
            const Vec3 size{between(random, 2, 20), between(random, 2, 20), between(random, 2, 20)};
            Mesh mesh = random.below(2) == 0 ? box_mesh({0, 0, 0}, size) : sphere_mesh(1, 3);
            if (mesh.vertices.size() > 8) {
                for (Vec3& v : mesh.vertices) {
                    v = {v.x * size.x, v.y * size.y, v.z * size.z};
                }
            }
            return transformed(mesh, {random_rotation(random), random_point(random, 2)});
        };
        const Mesh a = shape(), b = shape();
        // Slide b out along a random way until the penetration is what we want, by bisection.
        const Vec3 way = random_direction(random);
        const double wanted_depths[] = {-0.5, -1e-6, 0.5 * kTolerance, 6 * kTolerance, 0.1, 0.5};
        const double wanted = wanted_depths[random.below(6)];
        double near = 0, far = 80;
        if (convex_penetration(a, b) < wanted) continue;
        for (int step = 0; step < 45; ++step) {
            const double middle = (near + far) / 2;
            const bool deep = convex_penetration(a, transformed(b, moved_by(middle * way))) > wanted;
            (deep ? near : far) = middle;
        }
        const Mesh slid = transformed(b, moved_by(near * way));
        const Relation relation = compare_meshes(a, slid);
        EXPECT_EQ(apart(relation), wanted < kTolerance) << "pair " << pair << ", depth " << wanted;
        if (wanted < 0) {
            EXPECT_NEAR(relation.distance, reference_distance(a, slid), 1e-9);
        } else if (wanted > kTolerance) {
            EXPECT_GT(relation.depth, wanted / 3);
            EXPECT_LT(relation.depth, wanted + 1e-9);
        }
    }
}

TEST(OverlapOfRandom, RandomToriAgreeWithSampling) {
    RandomStream random(21);
    int together = 0, sampled = 0;
    for (int pair = 0; pair < 60; ++pair) {
        const Mesh a = torus_mesh(between(random, 6, 12), between(random, 1, 4), 12, 6);
        const Mesh b = transformed(torus_mesh(between(random, 6, 12), between(random, 1, 4), 10, 7),
                                   {random_rotation(random), random_point(random, 12)});
        const Relation relation = compare_meshes(a, b);
        const double distance = reference_distance(a, b);
        const bool shared =
            distance == 0 || reference_winding(a, b.vertices[0]) != 0 || reference_winding(b, a.vertices[0]) != 0;
        double depth = 0;
        for (int i = 0; i < 60; ++i) {
            // Points of either's material: inside one of its triangles, pushed in.
            const bool on_a = random.below(2) == 0;
            const Mesh& from = on_a ? a : b;
            const PointTriangle t = triangle_of(from, random.below(from.triangles.size()));
            const Point middle = Real(1) / 3 * (t[0] + t[1] + t[2]);
            const Vec3 p{double(middle.x), double(middle.y), double(middle.z)};
            const Mesh& other = on_a ? b : a;
            if (reference_winding(other, p) != 0) {
                depth = std::max(depth, reference_surface_distance(other, p));
            }
        }
        if (depth > 3 * kTolerance) {
            ++sampled;
            EXPECT_FALSE(apart(relation)) << "pair " << pair << ", depth " << depth;
        }
        EXPECT_EQ(apart(relation), !shared) << "pair " << pair;
        EXPECT_NEAR(relation.distance, shared ? 0 : distance, 1e-9) << "pair " << pair;
        together += shared;
    }
    EXPECT_GT(together, 10);
    EXPECT_LT(together, 50);
    EXPECT_GT(sampled, 5);
}

TEST(OverlapOfRandom, ABoundChangesNoDistanceBelowIt) {
    RandomStream random(2);
    const Mesh a = torus_mesh(10, 3), b = sphere_mesh(4, 8);
    for (int i = 0; i < 100; ++i) {
        const Transform pose{random_rotation(random), random_point(random, 30)};
        const Relation free = compare_meshes(a, b, {}, pose);
        if (!apart(free)) continue;
        for (const double share : {0.0, 0.5, 0.999, 1.001, 4.0}) {
            const double bound = share * free.distance;
            EXPECT_EQ(compare_meshes(a, b, {}, pose, bound).distance, std::min(bound, free.distance));
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
