#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plain_voxels.hpp"
#include "random_mesh.hpp"
#include "spectralpack/error.hpp"
#include "support/sanitized.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

const Workers kOne(1);

TEST(VoxelizeAt, IsThePlainDefinitionSeenFromTheGrid) {
    for (std::uint64_t seed = 0; seed < test::trials(300u); ++seed) {
        test::RandomMesh random(seed);
        const Mesh mesh = seed % 4 ? random.closed() : random.soup();
        const double voxel_size = random.within(0.4, 1.5);
        const VoxelIndex position{static_cast<int>(random.below(9)), static_cast<int>(random.below(9)), -3};
        const Vec3 inside = random.point(1e-3, 1 - 1e-3);  // of the voxel
        const Vec3 corner = voxel_size * (inside + Vec3{position.x + 0.0, position.y + 0.0, position.z + 0.0});
        const StandingVoxels found = voxelize_at(mesh, corner, voxel_size, kOne);
        EXPECT_EQ(found.position, position);
        EXPECT_EQ(found.solid, test::plain_voxels(mesh, voxel_size, bounding_box(mesh).min - voxel_size * inside))
            << "seed " << seed;
    }
}

TEST(VoxelizeAt, OnTheGridItIsVoxelize) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        test::RandomMesh random(seed);
        const Mesh mesh = random.closed();
        const Vec3 corner = Vec3{6, -1.5, 0} + inset(bounding_box(mesh).size(), 0.5);
        const StandingVoxels found = voxelize_at(mesh, corner, 0.5, kOne);
        EXPECT_EQ(found.position, (VoxelIndex{12, -3, 0}));
        EXPECT_EQ(found.solid, voxelize(mesh, 0.5, kOne));
    }
}

TEST(VoxelizeAt, ACubeThatOverhangsByLessThanTheShrinkStaysInItsVoxels) {
    const Mesh cube = test::cube_mesh(20);
    BitGrid full(Extent{10, 10, 10});
    full.fill(true);
    for (const double overhang : {-1e-4, -1e-7, 0.0, 1e-7, 1e-4}) {
        const StandingVoxels found = voxelize_at(cube, {4 + overhang, 8, 2 - overhang}, 2, kOne);
        EXPECT_EQ(found.position, (VoxelIndex{2, 4, 1})) << overhang;
        EXPECT_EQ(found.solid, full) << overhang;
    }
    EXPECT_EQ(voxelize_at(cube, {4.001, 8, 2}, 2, kOne).solid.extent(), (Extent{11, 10, 10}));
    EXPECT_EQ(voxelize_at(cube, {3.999, 8, 2}, 2, kOne).position, (VoxelIndex{1, 4, 1}));
}

TEST(VoxelizeAt, RefusesCornersThatAreNowhere) {
    const Mesh cube = test::cube_mesh(20);
    EXPECT_THROW(voxelize_at(cube, {1e300, 0, 0}, 2, kOne), ResourceError);
    EXPECT_THROW(voxelize_at(cube, {0, std::numeric_limits<double>::quiet_NaN(), 0}, 2, kOne), ResourceError);
}

}  // namespace
}  // namespace spectralpack
