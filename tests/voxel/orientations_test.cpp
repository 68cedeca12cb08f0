#include <gtest/gtest.h>

#include <algorithm>

#include "random_mesh.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

void expect_same_as_turned(const Mesh& mesh, const std::vector<Mat3>& rotations, double voxel_size,
                           const Workers& workers, std::uint64_t seed) {
    const auto voxels = voxelize_orientations(mesh, rotations, voxel_size, workers);
    ASSERT_EQ(voxels.size(), rotations.size());
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        const Mesh turned = transformed(mesh, {rotations[i], {}});
        const Box box = bounding_box(turned);
        const Vec3 in = inset(box.size(), voxel_size);
        EXPECT_EQ(voxels[i].reach, box.size() + in);
        EXPECT_EQ(voxels[i].corner, box.min - in);
        EXPECT_TRUE(*voxels[i].solid == voxelize(turned, voxel_size, workers)) << seed << " " << i;
    }
}

TEST(VoxelizeOrientations, EqualsVoxelisingTheTurnedMesh) {
    const Workers workers(2);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        test::RandomMesh random(seed);
        const Mesh mesh = random.below(3) == 0 ? random.soup() : random.closed();
        std::vector<Mat3> rotations = test::axis_turns(seed % 2 == 0);
        rotations.insert(rotations.begin() + 5, random.rotation());
        rotations.push_back(random.rotation());
        const double voxel_size = random.within(0.1, 1);
        expect_same_as_turned(mesh, rotations, voxel_size, workers, seed);
    }
}

TEST(VoxelizeOrientations, OfALongPartAndOfFewTurns) {
    const Mesh bar =
        transformed(test::torus_mesh(30, 1.3, 12, 5), {{{Vec3{5, 0, 0}, Vec3{0, 2.3, 0.2}, Vec3{0, 0, 1}}}, {3, 4, 5}});
    const std::vector<Mat3> all = test::axis_turns(false);
    expect_same_as_turned(bar, all, 1, Workers(1), 0);
    for (const Mat3& turn : all) {
        expect_same_as_turned(bar, {turn}, 2, Workers(1), 0);
    }
    EXPECT_TRUE(voxelize_orientations(bar, {}, 2, Workers(1)).empty());
}

TEST(VoxelizeOrientations, WithoutItsInsetWhereThatKeepsItOut) {
    const Mesh bar = test::box_mesh({0, 0, 0}, {20.5, 6.5, 4});
    const std::vector<Mat3> all = test::axis_turns(false);
    const auto fits = [](const Vec3& reach, const Vec3& room) {
        return reach.x <= room.x && reach.y <= room.y && reach.z <= room.z;
    };
    for (const Vec3& room : {Vec3{20.7, 30, 30}, Vec3{30, 20.7, 6.6}, Vec3{20.5, 6.5, 4}}) {
        const auto voxels = voxelize_orientations(bar, all, 2, Workers(2), room);
        int tight = 0, fitting = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Box box = bounding_box(transformed(bar, {all[i], {}}));
            EXPECT_EQ(fits(voxels[i].reach, room), fits(box.size(), room)) << i;
            const Vec3 from = box.min - voxels[i].corner;
            EXPECT_EQ(voxels[i].reach, box.max - voxels[i].corner);
            fitting += fits(box.size(), room) ? 1 : 0;
            tight += fits(box.size(), room) && from != inset(box.size(), 2) ? 1 : 0;
            if (from != inset(box.size(), 2)) {
                EXPECT_EQ(voxels[i].origin, i);
            }
        }
        EXPECT_GT(fitting, 0);
        EXPECT_GT(tight, 0);
    }
}

/// Between the cube's rotations, and from any rotation on, there is always a turn, and it is right for points.
TEST(AxisTurn, LeadsFromOneRotationToAnother) {
    test::RandomMesh random(3);
    const Mat3 start = random.rotation();
    const std::vector<Mat3> all = test::axis_turns(false);
    for (const Mat3& a : all) {
        for (const Mat3& b : all) {
            const Mat3 from = a * start, to = b * start;
            const std::optional<AxisTurn> turn = axis_turn(from, to);
            ASSERT_TRUE(turn);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Vec3& row = from.rows[static_cast<std::size_t>(turn->order[axis])];
                EXPECT_EQ(to.rows[axis], turn->reversed[axis] ? -1.0 * row : row);
            }
        }
    }
    EXPECT_FALSE(axis_turn(start, random.rotation()));
    EXPECT_EQ(axis_turn(start, start), AxisTurn{});
}

TEST(Turned, MovesEveryVoxel) {
    RandomStream random(5);
    for (const Extent& n : {Extent{5, 70, 130},
                            {130, 3, 66},
                            {64, 128, 1},
                            {1, 1, 200},
                            {65, 64, 63},
                            {3, 4, 5},
                            {17, 16, 15},
                            {33, 31, 32},
                            {2, 40, 7}}) {
        BitGrid grid(n);
        for (BitGrid::Word& word : grid.words()) {
            word = random.next();
        }
        BitGrid all(n);
        all.fill(true);
        for (std::size_t i = 0; i < grid.words().size(); ++i) {
            grid.words()[i] &= all.words()[i];
        }
        for (const Mat3& rotation : test::axis_turns(true)) {
            const AxisTurn turn = axis_turn(Mat3{}, rotation).value();
            const auto& [order, reversed] = turn;
            const BitGrid result = turned(grid, turn);
            const Extent& m = result.extent();
            ASSERT_EQ(m, (Extent{n[order[0]], n[order[1]], n[order[2]]}));
            EXPECT_EQ(result.count(), grid.count());
            for (int z = 0; z < n.z; ++z) {
                for (int y = 0; y < n.y; ++y) {
                    for (int x = 0; x < n.x; ++x) {
                        const VoxelIndex from{x, y, z};
                        VoxelIndex to;
                        for (int axis = 0; axis < 3; ++axis) {
                            const auto k = static_cast<std::size_t>(axis);
                            to[axis] = reversed[k] ? m[axis] - 1 - from[order[k]] : from[order[k]];
                        }
                        ASSERT_EQ(result.get(to.x, to.y, to.z), grid.get(x, y, z));
                    }
                }
            }
        }
    }
}

TEST(AxisTurn, ChainedIsOneAfterTheOther) {
    RandomStream random(6);
    BitGrid grid({5, 4, 7});
    for (int i = 0; i < 30; ++i) {
        grid.set(static_cast<int>(random.below(5)), static_cast<int>(random.below(4)),
                 static_cast<int>(random.below(7)));
    }
    for (const Mat3& a : test::axis_turns(true)) {
        const AxisTurn first = axis_turn(Mat3{}, a).value();
        for (const Mat3& b : test::axis_turns(true)) {
            const AxisTurn second = axis_turn(Mat3{}, b).value();
            EXPECT_EQ(turned(grid, chained(first, second)), turned(turned(grid, first), second));
        }
        EXPECT_EQ(chained(first, inverse(first)), AxisTurn{});
    }
}

TEST(Symmetric, AsTheGridTurnedSays) {
    RandomStream random(7);
    std::vector<AxisTurn> all;
    for (const Mat3& rotation : test::axis_turns(true)) {
        all.push_back(axis_turn(Mat3{}, rotation).value());
    }
    int symmetric = 0, not_symmetric = 0;
    for (const Extent& n : {Extent{6, 6, 6}, {70, 9, 9}, {9, 70, 5}, {64, 64, 3}, {7, 3, 7}}) {
        for (int i = 0; i < 40; ++i) {
            BitGrid grid(n);
            for (int k = 0; k < 20; ++k) {
                grid.set(static_cast<int>(random.below(static_cast<std::uint64_t>(n.x))),
                         static_cast<int>(random.below(static_cast<std::uint64_t>(n.y))),
                         static_cast<int>(random.below(static_cast<std::uint64_t>(n.z))));
            }
            // With all that a turn which keeps its extents makes of it, it is symmetric.
            AxisTurn own = all[random.below(all.size())];
            while (turned(n, own) != n)
                own = all[random.below(all.size())];
            for (int again = 0; again < i % 4; ++again) {
                unite(grid, turned(grid, own), {});
            }
            for (const AxisTurn& turn : all) {
                const bool expected = turned(grid, turn) == grid;
                EXPECT_EQ(is_symmetric(grid, turn), expected);
                ++(expected ? symmetric : not_symmetric);
            }
        }
    }
    EXPECT_GT(symmetric, 300);
    EXPECT_GT(not_symmetric, 1000);
}

}  // namespace
}  // namespace spectralpack
