#include "voxel/widen.hpp"

#include <gtest/gtest.h>

#include "core/stopped.hpp"
#include "geometry/triangle_distance.hpp"
#include "plain_voxels.hpp"
#include "random_mesh.hpp"
#include "spectralpack/error.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/box_distance.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

using test::PlainTriangle;
using test::RandomMesh;

const Workers kOne(1);

/// Distance of a triangle and the closed unit cube around `centre`, by way of the cube's twelve
/// facets.
double plain_distance(const PlainTriangle& triangle, const Vec3& centre) {
    const Mesh cube = test::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    PlainTriangle t;
    bool inside = false;
    for (std::size_t i = 0; i < 3; ++i) {
        t[i] = triangle[i] - centre;
        inside = inside || std::max({std::abs(t[i].x), std::abs(t[i].y), std::abs(t[i].z)}) <= 0.5;
    }
    double least = Box::kInfinity;
    for (const Triangle& facet : cube.triangles) {
        const Corners corners{cube.vertices[facet[0]], cube.vertices[facet[1]], cube.vertices[facet[2]]};
        least = std::min(least, distance(corners, t));
    }
    return inside ? 0 : least;
}

/// A mesh's voxels `solid`, which it stands in the middle of, widened.
WidenedVoxels widened_by(const BitGrid& solid, const Mesh& mesh, double voxel_size, double gap,
                         const Workers& workers = kOne) {
    return widen(solid, mesh, test::plain_corner(mesh, voxel_size), voxel_size, gap, workers);
}

/// What a widened grid says of a voxel, counted from the unwidened grid.
bool has(const WidenedVoxels& widened, int x, int y, int z) {
    const VoxelIndex i = VoxelIndex{x, y, z} - widened.offset;
    return widened.voxels.extent().contains(i) && widened.voxels->get(i.x, i.y, i.z);
}

void expect_plain_widening(const Mesh& mesh, double voxel_size, double gap, std::uint64_t seed) {
    const BitGrid solid = voxelize(mesh, voxel_size, kOne);
    const WidenedVoxels widened = widened_by(solid, mesh, voxel_size, gap);
    const double reach = (gap - kGapTolerance) / voxel_size;
    const int margin = static_cast<int>(reach) + 3;
    const auto triangles = test::grid_triangles(mesh, voxel_size, test::plain_corner(mesh, voxel_size));
    const Extent& n = solid.extent();
    std::int64_t count = 0;
    for (int z = -margin; z < n.z + margin; ++z) {
        for (int y = -margin; y < n.y + margin; ++y) {
            for (int x = -margin; x < n.x + margin; ++x) {
                bool near = n.contains({x, y, z}) && solid.get(x, y, z);
                bool clear = true;  // no distance so near to the reach that rounding decides
                const Vec3 low{x * 1.0, y * 1.0, z * 1.0};
                const Box cube{low, low + Vec3{1, 1, 1}};
                for (std::size_t i = 0; i < triangles.size() && !near; ++i) {
                    Box box;
                    for (const Vec3& corner : triangles[i]) {
                        box.add(corner);
                    }
                    if (distance(box, cube) > reach + 1e-9) continue;
                    const double d = plain_distance(triangles[i], {x + 0.5, y + 0.5, z + 0.5});
                    near = d < reach;
                    clear = clear && std::abs(d - reach) > 1e-9;
                }
                count += has(widened, x, y, z) ? 1 : 0;
                if (clear) {
                    ASSERT_EQ(has(widened, x, y, z), near) << seed << ": " << x << " " << y << " " << z;
                }
            }
        }
    }
    EXPECT_EQ(count, widened.voxels->count());  // nothing farther out
}

TEST(BoxDistance, IsThatToTheCubesFacets) {
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
        RandomMesh random(seed);
        // Also corners in the planes of the cube, and segments and points.
        const bool coarse = random.below(3) == 0;
        PlainTriangle t;
        for (Vec3& corner : t) {
            corner = random.point(-2, 2);
            for (int axis = 0; coarse && axis < 3; ++axis) {
                corner[axis] = std::round(2 * corner[axis]) / 2;
            }
        }
        if (random.below(6) == 0) t[2] = t[0] + random.within(0, 1) * (t[1] - t[0]);
        if (random.below(12) == 0) t[1] = t[2] = t[0];
        const double expected = plain_distance(t, {});
        ASSERT_NEAR(std::sqrt(squared_box_distance(t)), expected, 1e-8) << seed;
        for (const double distance : {0.01, 0.3, 1.0, expected * (1 - 1e-6), expected * (1 + 1e-6)}) {
            if (std::abs(distance - expected) < 1e-8) continue;
            ASSERT_EQ(NearCubes(t, distance).contain({}), expected < distance) << seed;
            const Vec3 far{300.5, -41, 7.25};
            const PlainTriangle moved{t[0] + far, t[1] + far, t[2] + far};
            ASSERT_EQ(NearCubes(moved, distance).contain(far), expected < distance) << seed;
        }
    }
}

TEST(Widen, OfClosedMeshesIsTheDistanceVoxelByVoxel) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = random.closed();
        const double gap = random.below(2) == 0 ? 0.2 : random.within(0.3, 3);
        expect_plain_widening(mesh, 1.1, gap, seed);
    }
}

TEST(Widen, OfLooseTrianglesIsTheDistanceVoxelByVoxel) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = random.soup();
        const double voxel_size = random.within(0.8, 2), gap = random.within(0.01, 3);
        expect_plain_widening(mesh, voxel_size, gap, seed);
    }
}

TEST(Widen, ByALongGapIsTheDistanceVoxelByVoxel) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = seed % 2 == 0 ? random.closed() : random.soup();
        const double gap = random.within(8.5, 14);
        expect_plain_widening(mesh, 2, gap, seed);
    }
}

TEST(Widen, AVoxelExactlyTheGapAwayStaysOut) {
    const Mesh cube = test::cube_mesh(20);
    const BitGrid solid = voxelize(cube, 2, kOne);
    // 2 mm reach all of the next layer and no further; not its corners, which are nearer than 2 mm
    // only by a corner or an edge: there the distance is 0 as well.
    const WidenedVoxels one = widened_by(solid, cube, 2, 2);
    EXPECT_EQ(one.offset, (VoxelIndex{-1, -1, -1}));
    EXPECT_EQ(one.voxels->count(), 12 * 12 * 12);
    // Just over 2 mm: a second layer over the faces and over the edges' nearest voxels, but not at
    // the corners.
    const WidenedVoxels two = widened_by(solid, cube, 2, 2.001);
    EXPECT_EQ(two.voxels.extent(), (Extent{14, 14, 14}));
    EXPECT_TRUE(has(two, -2, 0, 0));
    EXPECT_TRUE(has(two, -2, -1, 0));
    EXPECT_TRUE(has(two, -2, -1, -1));
    EXPECT_FALSE(has(two, -2, -2, 0));
    EXPECT_EQ(*widened_by(solid, cube, 2, 1e-7).voxels, solid);
}

TEST(Widen, AGapBeyondAllMemoryIsRefused) {
    const Mesh cube = test::cube_mesh(20);
    EXPECT_THROW(widened_by(voxelize(cube, 2, kOne), cube, 2, 1e300), ResourceError);
}

TEST(Widen, TheFurtherHoldsTheNearer) {
    const Mesh torus = test::torus_mesh(15, 5);
    const BitGrid solid = voxelize(torus, 2, kOne);
    WidenedVoxels inner{LazyGrid(solid), {}};
    for (const double gap : {0.1, 0.5, 2.0, 5.0, 13.0}) {
        const WidenedVoxels outer = widened_by(solid, torus, 2, gap);
        BitGrid rest = *inner.voxels;
        subtract(rest, *outer.voxels, outer.offset - inner.offset);
        EXPECT_TRUE(rest.none()) << gap;
        EXPECT_GT(outer.voxels->count(), inner.voxels->count()) << gap;
        inner = outer;
    }
}

TEST(Widen, HoldsWhatDenseSamplesOfTheSurfaceAreNearTo) {
    const Mesh sphere = test::sphere_mesh(13.3, 8);
    const double voxel_size = 2, gap = 1.7;
    const BitGrid solid = voxelize(sphere, voxel_size, kOne);
    const WidenedVoxels widened = widened_by(solid, sphere, voxel_size, gap);
    const auto triangles = test::grid_triangles(sphere, voxel_size, test::plain_corner(sphere, voxel_size));
    RandomStream random(7);
    for (const PlainTriangle& t : triangles) {
        for (int i = 0; i < 30; ++i) {
            const double u = random.unit(), v = (1 - u) * random.unit();
            Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
            // Any point nearer than the gap to the sample lies in a widened voxel.
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] += 0.57 * gap / voxel_size * (2 * random.unit() - 1);
            }
            EXPECT_TRUE(has(widened, static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
                            static_cast<int>(std::floor(p.z))));
        }
    }
}

TEST(Widen, TurningTheMeshTurnsTheVoxels) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        RandomMesh random(seed);
        const Mesh mesh = random.below(3) == 0 ? random.soup() : random.closed();
        const double voxel_size = random.within(0.3, 1.5), gap = random.within(0.1, 2);
        const BitGrid solid = voxelize(mesh, voxel_size, kOne);
        const WidenedVoxels wide = widened_by(solid, mesh, voxel_size, gap);
        for (const Mat3& rotation : test::axis_turns(true)) {
            const Mesh one = transformed(mesh, {rotation, {}});
            const WidenedVoxels direct = widened_by(voxelize(one, voxel_size, kOne), one, voxel_size, gap);
            const WidenedVoxels derived = turned(wide, solid.extent(), axis_turn(Mat3{}, rotation).value());
            EXPECT_TRUE(*derived.voxels == *direct.voxels) << seed;
            EXPECT_EQ(derived.offset, direct.offset);
        }
    }
}

TEST(Widen, DoesNotDependOnTheThreads) {
    const Mesh mesh = test::torus_mesh(40, 15, 120, 60);
    const BitGrid solid = voxelize(mesh, 2, kOne);
    const WidenedVoxels widened = widened_by(solid, mesh, 2, 3);
    for (const int threads : {2, 3}) {
        EXPECT_EQ(*widened_by(solid, mesh, 2, 3, Workers(threads)).voxels, *widened.voxels);
    }
}

TEST(Widen, StopsBetweenRowsOfOneTriangle) {
    const Mesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
    StopSource stop;
    stop.request(StopReason::time_limit);
    for (const double gap : {2.0, 20.0, 300.0}) {  // by triangles, by centres, and beyond what these can tell
        EXPECT_THROW(widened_by(voxelize(mesh, 1, kOne), mesh, 1, gap, kOne.stopping_with(stop.token())), Stopped);
    }
}

}  // namespace
}  // namespace spectralpack
