#include "voxel/voxelize.hpp"

#include <gtest/gtest.h>

#include "plain_voxels.hpp"
#include "random_mesh.hpp"
#include "spectralpack/error.hpp"
#include "support/sanitized.hpp"

namespace spectralpack {
namespace {

using test::box_mesh;
using test::merged;
using test::RandomMesh;
using test::trials;

const Workers kOne(1);

BitGrid full(const Extent& extent) {
    BitGrid grid(extent);
    grid.fill(true);
    return grid;
}

Mesh moved(Mesh mesh, const Vec3& by) { return transformed(mesh, {Mat3{}, by}); }

TEST(VoxelsAlong, IsTheCeilingLessTheShrink) {
    EXPECT_EQ(voxels_along(20, 2), 10);
    EXPECT_EQ(voxels_along(20 + 1e-4, 2), 10);
    EXPECT_EQ(voxels_along(20 + 3e-4, 2), 11);
    EXPECT_EQ(voxels_along(0.3, 0.1), 3);
    EXPECT_EQ(voxels_along(0, 2), 1);
    EXPECT_EQ(voxels_along(1e-9, 2), 1);
    EXPECT_THROW(voxels_along(1e12, 2), ResourceError);
}

TEST(Voxelize, ACubeOnTheGridIsItsVoxelsAndNoMore) {
    for (const double offset : {0.0, -7.3, 0.1, 1000.0, -1e6, 1e6 + 0.1}) {
        const Mesh cube = moved(test::cube_mesh(20), {offset, 2 * offset, -offset});
        EXPECT_EQ(voxelize(cube, 2, kOne), full({10, 10, 10})) << offset;
    }
    EXPECT_EQ(voxelize(test::cube_mesh(0.3), 0.1, kOne), full({3, 3, 3}));
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {130, 2, 4}), 2, kOne), full({65, 1, 2}));
}

TEST(Voxelize, ABoxOffTheGridFillsThePartialVoxels) {
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {20.5, 19.5, 2.001}), 2, kOne), full({11, 10, 2}));
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {20.0001, 20, 19.9999}), 2, kOne), full({10, 10, 10}));
}

TEST(Voxelize, BoxesThatTouchShareNoVoxel) {
    // By a face, whose two triangulations lie on each other; by an edge; by a corner.
    const Mesh first = box_mesh({0, 0, 0}, {10, 6, 4});
    EXPECT_EQ(voxelize(merged(first, box_mesh({10, 0, 0}, {16, 6, 4})), 2, kOne), full({8, 3, 2}));
    EXPECT_EQ(voxelize(merged(first, box_mesh({10, 6, 0}, {16, 8, 4})), 2, kOne).count(), 30 + 6);
    EXPECT_EQ(voxelize(merged(first, box_mesh({10, 6, 4}, {16, 8, 6})), 2, kOne).count(), 30 + 3);
}

TEST(Voxelize, ThinSheetsFillTheirLayer) {
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {20, 30, 0.1}), 2, kOne), full({10, 15, 1}));
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {20, 1e-5, 30}), 2, kOne), full({10, 1, 15}));
    EXPECT_EQ(voxelize(box_mesh({0, 0, 0}, {0, 20, 30}), 2, kOne), full({1, 10, 15}));
    // One that stands between two layers of a larger part belongs to both.
    const Mesh fin = merged(box_mesh({0, 0, 0}, {10, 10, 2}), box_mesh({3.9, 0, 2}, {4.1, 10, 8}));
    const BitGrid voxels = voxelize(fin, 2, kOne);
    EXPECT_EQ(voxels.count(), 5 * 5 + 2 * 5 * 3);
    EXPECT_TRUE(voxels.get(1, 0, 3) && voxels.get(2, 4, 3));
}

TEST(Voxelize, NothingIsTooSmallForAVoxel) {
    for (const double size : {1e-6, 1e-12, 3.1e-4, 1e-300}) {
        EXPECT_EQ(voxelize(test::sphere_mesh(size), 2, kOne), full({1, 1, 1})) << size;
        EXPECT_EQ(voxelize(moved(test::cube_mesh(size), {1e6, 3, 5}), 2, kOne), full({1, 1, 1})) << size;
    }
    Mesh dot;
    dot.vertices = {{4, 4, 4}};
    dot.triangles = {{0, 0, 0}};
    EXPECT_EQ(voxelize(dot, 2, kOne), full({1, 1, 1}));
    EXPECT_EQ(voxelize(Mesh{}, 2, kOne), BitGrid({1, 1, 1}));
}

TEST(Voxelize, ANeedleIsTheVoxelsItPasses) {
    Mesh needle;
    needle.vertices = {{0, 0, 0}, {20, 0.3, 7.1}, {20, 0.3, 7.1}};
    needle.triangles = {{0, 1, 2}};
    EXPECT_EQ(voxelize(needle, 2, kOne), test::plain_voxels(needle, 2));
    EXPECT_GE(voxelize(needle, 2, kOne).count(), 10);
    EXPECT_LE(voxelize(needle, 2, kOne).count(), 13);
}

TEST(Voxelize, InsideOutIsTheSame) {
    const Mesh torus = test::torus_mesh(15, 6);
    EXPECT_EQ(voxelize(test::turned_inside_out(torus), 2, kOne), voxelize(torus, 2, kOne));
    EXPECT_EQ(voxelize(test::turned_inside_out(test::cube_mesh(20)), 2, kOne), full({10, 10, 10}));
}

TEST(Voxelize, ClosedHollowsAreFilled) {
    const Mesh inner = box_mesh({4, 4, 4}, {16, 16, 16});
    EXPECT_EQ(voxelize(merged(test::cube_mesh(20), test::turned_inside_out(inner)), 2, kOne), full({10, 10, 10}));
    EXPECT_EQ(voxelize(merged(test::cube_mesh(20), inner), 2, kOne), full({10, 10, 10}));
}

TEST(Voxelize, WhatIsWoundTwiceIsSolid) {
    // On the grid no face enters a voxel, so that only the winding number tells inside from
    // outside.
    const Mesh cube = test::cube_mesh(20);
    EXPECT_EQ(voxelize(merged(cube, cube), 2, kOne), full({10, 10, 10}));
    EXPECT_EQ(voxelize(merged(cube, box_mesh({10, 0, 0}, {30, 20, 20})), 2, kOne), full({15, 10, 10}));
}

TEST(Voxelize, AHoleAsWideAsAVoxelStaysOpen) {
    // Four bars round a square hole on the grid, and the hole's faces are voxel faces.
    Mesh frame = merged(box_mesh({0, 0, 0}, {10, 4, 6}), box_mesh({0, 6, 0}, {10, 10, 6}));
    frame = merged(merged(frame, box_mesh({0, 4, 0}, {4, 6, 6})), box_mesh({6, 4, 0}, {10, 6, 6}));
    const BitGrid voxels = voxelize(frame, 2, kOne);
    EXPECT_EQ(voxels.count(), 3 * 24);
    for (int z = 0; z < 3; ++z) {
        EXPECT_FALSE(voxels.get(2, 2, z));
    }
}

TEST(Voxelize, ALeakingMeshIsSurfaceOnly) {
    Mesh cup = box_mesh({0, 0, 0}, {21, 21, 21});
    std::erase_if(cup.triangles, [&](const Triangle& t) {
        return cup.vertices[t[0]].z + cup.vertices[t[1]].z + cup.vertices[t[2]].z == 63;
    });
    // Half a millimetre of the outer voxels is left over on every side.
    const BitGrid voxels = voxelize(cup, 2, kOne);
    EXPECT_EQ(voxels.count(), 11 * 11 * 11 - 9 * 9 * 10);
    EXPECT_FALSE(voxels.get(5, 5, 5));
    // On the grid its faces enter no voxel; it is something all the same.
    for (Vec3& v : cup.vertices) {
        v = (20.0 / 21) * v;
    }
    EXPECT_FALSE(voxelize(cup, 2, kOne).none());
}

TEST(Voxelize, WhatAnOpenMeshEnclosesIsFilled) {
    // A small hole, and a facet turned round: neither is a boundary, and neither leaks at this
    // voxel size.
    const Mesh sphere = test::sphere_mesh(20);
    Mesh hole = sphere, turned = sphere;
    hole.triangles.erase(hole.triangles.begin() + 100);
    std::swap(turned.triangles[100][0], turned.triangles[100][1]);
    EXPECT_EQ(voxelize(hole, 5, kOne), voxelize(sphere, 5, kOne));
    EXPECT_EQ(voxelize(turned, 5, kOne), voxelize(sphere, 5, kOne));
    // At a finer one the hole does.
    EXPECT_LT(voxelize(hole, 0.5, kOne).count(), voxelize(sphere, 0.5, kOne).count() / 2);
}

TEST(Voxelize, OfClosedMeshesIsThePlainDefinition) {
    for (std::uint64_t seed = 0; seed < trials(100u); ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = random.closed();
        const double voxel_size = random.below(2) == 0 ? 1 : random.within(0.4, 1.5);
        ASSERT_TRUE(voxelize(mesh, voxel_size, kOne) == test::plain_voxels(mesh, voxel_size)) << seed;
    }
}

TEST(Voxelize, OfLooseTrianglesIsThePlainDefinition) {
    for (std::uint64_t seed = 0; seed < trials(500u); ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = random.soup();
        const double voxel_size = random.within(0.3, 2);
        ASSERT_TRUE(voxelize(mesh, voxel_size, kOne) == test::plain_voxels(mesh, voxel_size)) << seed;
    }
}

TEST(Voxelize, RowsLongerThanAWordAreThePlainDefinition) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomMesh random(seed);
        const Mat3 stretch{{Vec3{60, 0, 0}, Vec3{0, 0.8, 0}, Vec3{0, 0, 0.8}}};
        const Mesh mesh = transformed(random.closed(), {stretch, {}});
        ASSERT_TRUE(voxelize(mesh, 2, kOne) == test::plain_voxels(mesh, 2)) << seed;
    }
}

TEST(Voxelize, FarFromTheOriginIsTheSame) {
    // Coordinates on a lattice of 2^-10 mm, which 1e6 mm away holds too.
    Mesh mesh = test::torus_mesh(20, 7);
    for (Vec3& v : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            v[axis] = std::round(v[axis] * 1024) / 1024;
        }
    }
    EXPECT_EQ(voxelize(moved(mesh, {1e6, -1e6, 1e6}), 2, kOne), voxelize(mesh, 2, kOne));
}

TEST(Voxelize, DoesNotDependOnTheThreads) {
    const Mesh mesh = test::torus_mesh(40, 15, 300, 100);
    const BitGrid voxels = voxelize(mesh, 1, kOne);
    for (const int threads : {2, 3}) {
        EXPECT_EQ(voxelize(mesh, 1, Workers(threads)), voxels);
    }
}

TEST(Voxelize, AGridBeyondAllMemoryIsRefused) {
    EXPECT_THROW(voxelize(test::cube_mesh(1e6), 0.01, kOne), ResourceError);
    EXPECT_THROW(voxelize(test::cube_mesh(1e9), 1e-9, kOne), ResourceError);
}

}  // namespace
}  // namespace spectralpack
