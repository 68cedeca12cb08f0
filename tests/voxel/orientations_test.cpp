#include <gtest/gtest.h>

#include <algorithm>

#include "random_mesh.hpp"
#include "voxel/permute.hpp"
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
        EXPECT_EQ(voxels[i].size, box.size());
        EXPECT_EQ(voxels[i].min, box.min);
        EXPECT_TRUE(voxels[i].solid == voxelize(turned, voxel_size, workers)) << seed << " " << i;
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

TEST(Permuted, MovesEveryVoxel) {
    RandomStream random(5);
    for (const Extent& n : {Extent{5, 70, 130}, {130, 3, 66}, {64, 128, 1}, {1, 1, 200}, {65, 64, 63}}) {
        BitGrid grid(n);
        for (BitGrid::Word& word : grid.words()) {
            word = random.next();
        }
        BitGrid all(n);
        all.fill(true);
        for (std::size_t i = 0; i < grid.words().size(); ++i) {
            grid.words()[i] &= all.words()[i];
        }
        std::array<int, 3> axes{0, 1, 2};
        do {
            const BitGrid result = permuted(grid, axes);
            ASSERT_EQ(result.extent(), (Extent{n[axes[0]], n[axes[1]], n[axes[2]]}));
            EXPECT_EQ(result.count(), grid.count());
            for (int z = 0; z < n.z; ++z) {
                for (int y = 0; y < n.y; ++y) {
                    for (int x = 0; x < n.x; ++x) {
                        const VoxelIndex at{x, y, z};
                        ASSERT_EQ(result.get(at[axes[0]], at[axes[1]], at[axes[2]]), grid.get(x, y, z));
                    }
                }
            }
        } while (std::ranges::next_permutation(axes).found);
    }
}

}  // namespace
}  // namespace spectralpack
