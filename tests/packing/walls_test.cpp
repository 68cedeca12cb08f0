#include "packing/containers/walls.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh_edges.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

StandingMesh standing(const Mesh& mesh) { return {"wall.stl", {}, std::make_shared<const Mesh>(mesh)}; }

/// Which voxels of 1 mm have all of their corners and centre in the set that `inside` describes.
template <class Inside>
BitGrid not_inside(const Extent& grid, double origin, Inside inside) {
    BitGrid blocked(grid);
    for (int z = 0; z < grid.z; ++z)
        for (int y = 0; y < grid.y; ++y)
            for (int x = 0; x < grid.x; ++x) {
                bool free = true;
                for (int i = 0; i < 8; ++i) {
                    free = free && inside(Vec3{origin + x + (i & 1), origin + y + (i >> 1 & 1), origin + z + (i >> 2)});
                }
                if (!free) blocked.set(x, y, z);
            }
    return blocked;
}

TEST(Walls, ABoxHasNone) {
    EXPECT_TRUE(blocked_voxels({{10, 10, 10}}, {10, 10, 10}, 1, 0, Workers(1)).extent().empty());
    EXPECT_TRUE(wall_surfaces({{10, 10, 10}}, 0).empty());
}

TEST(Walls, AVoxelIsFreeOnlyIfItIsWhollyInTheContainer) {
    // A box that ends in the middle of a voxel.
    const Container container{{9.5, 8, 6}, standing(test::box_mesh({0, 0, 0}, {9.5, 8, 6}))};
    const BitGrid blocked = blocked_voxels(container, {10, 8, 6}, 1, 0, Workers(2));
    EXPECT_EQ(blocked, not_inside({10, 8, 6}, 0, [](const Vec3& p) { return p.x <= 9.5; }));
    // A wedge x <= z.
    Mesh wedge;
    wedge.vertices = {{0, 0, 0}, {0, 8, 0}, {0, 0, 8}, {0, 8, 8}, {8, 0, 8}, {8, 8, 8}};
    wedge.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {0, 1, 4}, {1, 5, 4}, {0, 4, 2}, {1, 3, 5}};
    if (signed_volume(wedge) < 0) wedge = test::turned_inside_out(wedge);
    ASSERT_TRUE(is_closed(wedge));
    EXPECT_EQ(blocked_voxels({{8, 8, 8}, standing(wedge)}, {8, 8, 8}, 1, 0, Workers(1)),
              not_inside({8, 8, 8}, 0, [](const Vec3& p) { return p.x <= p.z; }));
}

TEST(Walls, TheWallGapHoldsForContainerAndKeepOuts) {
    // The grid starts at the wall gap.
    Container container{{12, 12, 12}, standing(test::box_mesh({0, 0, 0}, {12, 12, 12}))};
    EXPECT_TRUE(blocked_voxels(container, {9, 9, 9}, 1, 1.5, Workers(1)).none());
    container.keep_out = {{Box{{5, 5, 5}, {6, 6, 6}}}};
    const BitGrid box = blocked_voxels(container, {9, 9, 9}, 1, 1.5, Workers(1));
    BitGrid expected({9, 9, 9});  // 3.5 to 7.5 mm
    for (int z = 2; z < 6; ++z)
        for (int y = 2; y < 6; ++y)
            for (int x = 2; x < 6; ++x)
                expected.set(x, y, z);
    EXPECT_EQ(box, expected);
    // The same as a mesh: the corners are not square then.
    container.keep_out = {{{}, standing(test::box_mesh({5, 5, 5}, {6, 6, 6}))}};
    BitGrid mesh = blocked_voxels(container, {9, 9, 9}, 1, 1.5, Workers(2));
    EXPECT_FALSE(mesh.none());
    subtract(mesh, box, {});
    EXPECT_TRUE(mesh.none());
}

TEST(Walls, AKeepOutMeshTakesItsSolid) {
    Container container{{10, 10, 10}};
    container.keep_out = {{{}, standing(test::box_mesh({3, 3, 3}, {7.5, 7, 7}))}};
    const BitGrid blocked = blocked_voxels(container, {10, 10, 10}, 1, 0, Workers(1));
    BitGrid expected({10, 10, 10});
    for (int z = 3; z < 7; ++z)
        for (int y = 3; y < 7; ++y)
            for (int x = 3; x < 8; ++x)
                expected.set(x, y, z);
    EXPECT_EQ(blocked, expected);
}

TEST(Walls, SurfacesFaceTheFreeSide) {
    const Container container{{8, 8, 8}, standing(test::cube_mesh(8)), {{Box{{1, 1, 1}, {2, 2, 2}}}}};
    const std::vector<PlacedSurface> walls = wall_surfaces(container, 0.5);
    ASSERT_EQ(walls.size(), 2u);
    for (const PlacedSurface& wall : walls) {
        EXPECT_TRUE(wall.wall);
        EXPECT_EQ(wall.gap, 0.5);
        EXPECT_TRUE(wall.surface->faces_outwards());
    }
    // A copy in the middle is 3 mm from the container's side and not inside its "material".
    Refiner refiner({{8, 8, 8}, 0, 4, 3});
    for (const PlacedSurface& wall : walls) {
        refiner.add(wall);
    }
    const auto cube = std::make_shared<const Bvh>(test::cube_mesh(2));
    const Refined moved = refiner.refine({cube, {3, 3, 4}, 1}, {-1, 0, 1});
    EXPECT_NEAR(moved.offset.x, 0.5, 1e-5);  // its own gap of 1 is for other copies
    EXPECT_NEAR(moved.offset.z, 5.5, 1e-5);
}

}  // namespace
}  // namespace spectralpack
