/// Pairs made by hand: what may touch, and what overlaps.

#include "verify/overlap.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_edges.hpp"
#include "scenes.hpp"

namespace spectralpack::test {
namespace {

using Kind = Relation::Kind;

/// Both ways round, as they stand and turned together, so that planes that coincide do so up to rounding only.
void expect_relation(const Mesh& a, const Mesh& b, bool expect_apart, const std::string& what) {
    RandomStream random(11);
    for (int turn = 0; turn < 4; ++turn) {
        const Transform pose = turn == 0 ? Transform{} : Transform{random_rotation(random), random_point(random, 300)};
        EXPECT_EQ(apart(compare_meshes(a, b, pose, pose)), expect_apart) << what << ", turn " << turn;
        EXPECT_EQ(apart(compare_meshes(b, a, pose, pose)), expect_apart) << what << " swapped, turn " << turn;
    }
}

TEST(Overlap, CubesMayTouch) {
    const Mesh cube = cube_mesh(10);
    const auto at = [&](const Vec3& step) { return transformed(cube, moved_by(step)); };
    expect_relation(cube, at({10, 0, 0}), true, "face to face");
    expect_relation(cube, at({10, 3, -4}), true, "parts of faces");
    expect_relation(cube, at({10, 10, 0}), true, "edge to edge");
    expect_relation(cube, at({10, 10, 4}), true, "parts of edges");
    expect_relation(cube, at({10, 10, 10}), true, "corner to corner");
    expect_relation(cube, at({9.9995, 0, 0}), true, "within the tolerance");
    expect_relation(cube, at({9.9995, 9.9995, 2}), true, "edges within the tolerance");
    EXPECT_LT(compare_meshes(cube, at({10, 3, -4})).distance, 1e-9);
}

TEST(Overlap, AlignedCubesThatOverlapAreFound) {
    // No two triangles of these cross.
    const Mesh cube = cube_mesh(10);
    const auto at = [&](const Vec3& step) { return transformed(cube, moved_by(step)); };
    expect_relation(cube, at({9.5, 0, 0}), false, "half a millimetre along x");
    expect_relation(cube, at({0, 0, -9.99}), false, "a hundredth");
    expect_relation(cube, at({9.996, 0, 0}), false, "four tolerances");
    expect_relation(cube, at({0, 0, 0}), false, "the same place");
    expect_relation(cube, at({0.0005, 0, 0}), false, "almost the same place");
    expect_relation(cube, at({0, 5, 0}), false, "half");
    expect_relation(cube, box_mesh({0, 0, 2}, {10, 10, 8}), false, "a slice, its rim in the other's sides");
    expect_relation(cube, box_mesh({0, 0, 0}, {5, 5, 5}), false, "an eighth in the corner");
    expect_relation(cube, box_mesh({2, 2, 0}, {8, 8, 3}), false, "on the floor inside");
    expect_relation(cube, box_mesh({-5, 2, 2}, {15, 8, 8}), false, "a bar through it");
    expect_relation(cube, box_mesh({-5, 0, 0}, {15, 10, 10}), false, "a bar of the same section");
    expect_relation(cube, box_mesh({-5, 0, 2}, {15, 10, 8}), false, "a flat bar, its sides in the other's");
}

TEST(Overlap, CubesThatCrossAtAnyAngleAreFound) {
    RandomStream random(3);
    const Mesh centred = box_mesh({-5, -5, -5}, {5, 5, 5});
    for (int i = 0; i < 50; ++i) {
        const Transform pose{random_rotation(random), random_point(random, 4)};
        EXPECT_FALSE(apart(compare_meshes(centred, centred, {}, pose)));
    }
    const Mesh cube = cube_mesh(10);
    // An edge that crosses a face, with both of its triangles on the face's other side only by 4 tolerances.
    const double s = std::sqrt(0.5);
    const Mat3 tilt{{Vec3{1, 0, 0}, {0, s, -s}, {0, s, s}}};
    EXPECT_FALSE(apart(compare_meshes(cube, transformed(cube, {tilt, {0, 5, 9.996}}))));
    EXPECT_TRUE(apart(compare_meshes(cube, transformed(cube, {tilt, {0, 5, 10}}))));
    EXPECT_TRUE(apart(compare_meshes(cube, transformed(cube, {tilt, {0, 5, 9.9995}}))));
}

TEST(Overlap, AThingMayFillAHole) {
    Cells frame = box_cells({0, 0, 0}, {3, 3, 2});
    frame.erase({1, 1, 0});
    frame.erase({1, 1, 1});
    const Mesh frame_mesh = block_mesh(frame);
    expect_relation(frame_mesh, box_mesh({1, 1, 0}, {2, 2, 2}), true, "cube in a hole");
    expect_relation(frame_mesh, box_mesh({1, 1, -2}, {2, 2, 5}), true, "bar in a hole");
    expect_relation(frame_mesh, box_mesh({1, 1, 0.5}, {2, 2, 1}), true, "slice in a hole");
    expect_relation(frame_mesh, box_mesh({1, 1, -2}, {2.01, 2, 5}), false, "too wide a bar");
    expect_relation(frame_mesh, box_mesh({0.5, 1, -2}, {2, 2, 5}), false, "much too wide a bar");

    Cells shell = box_cells({0, 0, 0}, {3, 3, 3});
    shell.erase({1, 1, 1});
    expect_relation(block_mesh(shell), box_mesh({1, 1, 1}, {2, 2, 2}), true, "fills a hollow");
    expect_relation(block_mesh(shell), box_mesh({1.2, 1.2, 1.2}, {1.8, 1.8, 1.8}), true, "in a hollow");
    expect_relation(block_mesh(shell), box_mesh({1, 1, 1}, {2, 2, 2.01}), false, "over-fills a hollow");
}

TEST(Overlap, CombsMayInterleave) {
    Cells comb = box_cells({0, 0, 0}, {9, 1, 2}), other = box_cells({0, 4, 0}, {9, 5, 2});
    for (int x = 0; x < 9; ++x) {
        for (int y = 1; y < 4; ++y) {
            for (int z = 0; z < 2; ++z) {
                (x % 2 == 0 ? comb : other).insert({x, y, z});
            }
        }
    }
    const Mesh a = block_mesh(comb), b = block_mesh(other, true);
    expect_relation(a, b, true, "teeth that fill each other's gaps");
    expect_relation(a, transformed(b, moved_by({0, 0, 1})), true, "slid along");
    expect_relation(a, transformed(b, moved_by({0, 0.5, 0.3})), true, "half way out");
    expect_relation(a, transformed(b, moved_by({0.004, 0, 0})), false, "a little sideways");
    expect_relation(a, transformed(b, moved_by({1, 0, 0})), false, "tooth on tooth");
    expect_relation(a, transformed(b, moved_by({0, -0.01, 0})), false, "too deep");
}

TEST(Overlap, RingsMayBeLinked) {
    const Mesh ring = torus_mesh(10, 3);
    const Mat3 upright{{Vec3{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
    EXPECT_TRUE(apart(compare_meshes(ring, transformed(ring, {upright, {10, 0, 0}}))));
    EXPECT_FALSE(apart(compare_meshes(ring, transformed(ring, {upright, {15, 0, 0}}))));
    EXPECT_FALSE(apart(compare_meshes(ring, transformed(ring, {upright, {0, 0, 0}}))));
}

TEST(Overlap, ARingMayHugARod) {
    // A prism of as many sides as the ring has, which touches it all around.
    constexpr int kAround = 32;
    const auto rod = [](double radius, double turn) {
        Mesh mesh;
        for (int i = 0; i < kAround; ++i) {
            const double a = 2 * std::numbers::pi * (i + turn) / kAround;
            for (const double z : {-20.0, 20.0}) {
                mesh.vertices.push_back({radius * std::cos(a), radius * std::sin(a), z});
            }
        }
        mesh.vertices.push_back({0, 0, -20});
        mesh.vertices.push_back({0, 0, 20});
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kAround);
            mesh.triangles.insert(
                mesh.triangles.end(),
                {{a, b, a + 1}, {b, b + 1, a + 1}, {b, a, 2 * kAround}, {a + 1, b + 1, 2 * kAround + 1}});
        }
        return mesh;
    };
    const Mesh ring = torus_mesh(10, 3, kAround, 16);
    ASSERT_TRUE(is_closed(rod(7, 0)));
    ASSERT_GT(signed_volume(rod(7, 0)), 0);
    expect_relation(ring, rod(7, 0), true, "sides on sides");
    expect_relation(ring, rod(7.01, 0), false, "too thick");
    expect_relation(ring, rod(7, 0.5), false, "its edges in the ring's sides");
    expect_relation(ring, rod(7 * std::cos(std::numbers::pi / kAround), 0.5), true, "edges on sides");
}

TEST(Overlap, NestingIsToldFromHollows) {
    const Mesh cube = cube_mesh(30), small = box_mesh({10, 10, 10}, {12, 12, 12});
    EXPECT_EQ(compare_meshes(cube, small).kind, Kind::b_within_a);
    EXPECT_EQ(compare_meshes(small, cube).kind, Kind::a_within_b);
    EXPECT_NEAR(compare_meshes(small, cube).depth, 12, 1e-9);
    EXPECT_EQ(compare_meshes(small, cube).distance, 0);

    const Mesh hollow = merged(cube, turned_inside_out(box_mesh({5, 5, 5}, {25, 25, 25})));
    EXPECT_EQ(compare_meshes(hollow, small).kind, Kind::apart);
    EXPECT_NEAR(compare_meshes(hollow, small).distance, 5, 1e-9);
    EXPECT_EQ(compare_meshes(hollow, box_mesh({1, 1, 1}, {3, 3, 3})).kind, Kind::b_within_a);
    EXPECT_EQ(compare_meshes(hollow, box_mesh({5, 5, 5}, {25, 25, 25})).kind, Kind::apart);
    EXPECT_EQ(compare_meshes(hollow, box_mesh({4, 6, 6}, {25, 24, 24})).kind, Kind::overlap);
    // Of two shells one lies in the material, the other far away.
    EXPECT_EQ(compare_meshes(cube, merged(small, box_mesh({50, 0, 0}, {60, 9, 9}))).kind, Kind::overlap);
    // A self-intersecting solid is solid where its parts overlap, too.
    const Mesh twice = merged(box_mesh({0, 0, 0}, {20, 30, 30}), box_mesh({5, 0, 0}, {30, 30, 30}));
    EXPECT_EQ(compare_meshes(twice, small).kind, Kind::b_within_a);
}

TEST(Overlap, OpenMeshesHaveASurfaceOnly) {
    Mesh open = cube_mesh(30);
    open.triangles.pop_back();
    const Mesh small = box_mesh({10, 10, 10}, {12, 12, 12});
    EXPECT_EQ(compare_meshes(open, small).kind, Kind::apart);
    EXPECT_EQ(compare_meshes(open, box_mesh({-1, 10, 10}, {12, 12, 12})).kind, Kind::overlap);
    Mesh open_small = small;
    open_small.triangles.pop_back();
    EXPECT_EQ(compare_meshes(cube_mesh(30), open_small).kind, Kind::b_within_a);
}

TEST(Overlap, DegenerateAndDuplicateTrianglesChangeNothing) {
    Mesh rough = cube_mesh(10);
    rough.vertices.push_back({5, 0, 0});     // on an edge
    rough.vertices.push_back({5, 1e-9, 0});  // almost
    rough.triangles.push_back({0, 8, 1});
    rough.triangles.push_back({0, 1, 8});
    rough.triangles.push_back({0, 9, 1});
    rough.triangles.push_back({0, 1, 9});
    rough.triangles.push_back({0, 0, 0});
    const Triangle twice = rough.triangles[0];
    rough.triangles.push_back(twice);
    rough.triangles.push_back({twice[0], twice[2], twice[1]});
    ASSERT_TRUE(is_closed(rough));
    for (const Mesh& a : {rough, cube_mesh(10)}) {
        expect_relation(a, transformed(rough, moved_by({10, 0, 0})), true, "touching");
        expect_relation(a, transformed(rough, moved_by({0, -10, 3})), true, "touching at the rough side");
        expect_relation(a, transformed(rough, moved_by({9.9, 0, 0})), false, "overlapping");
        expect_relation(a, transformed(rough, moved_by({0, 0, 0})), false, "the same place");
        EXPECT_NEAR(compare_meshes(a, transformed(rough, moved_by({0, -12, 3}))).distance, 2, 1e-9);
    }
}

}  // namespace
}  // namespace spectralpack::test
