#include "voxel/near_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "random_mesh.hpp"
#include "voxel/centre_distances.hpp"
#include "voxel/near_triangle.hpp"

namespace spectralpack {
namespace {

std::vector<VoxelIndex> random_voxels(const Extent& extent, int count, RandomStream& random) {
    std::vector<VoxelIndex> voxels;
    for (int i = 0; i < count; ++i) {
        VoxelIndex voxel;
        for (int axis = 0; axis < 3; ++axis) {
            voxel[axis] = static_cast<int>(random.below(static_cast<std::uint64_t>(extent[axis])));
        }
        voxels.push_back(voxel);
    }
    return voxels;
}

TEST(CentreDistances, TellWhatIsNearAndWhatIsFar) {
    RandomStream random(3);
    for (int round = 0; round < 12; ++round) {
        const Extent n{5 + static_cast<int>(random.below(75)), 9, 40};
        const std::vector<VoxelIndex> voxels = random_voxels(n, 1 + 3 * round, random);
        BitGrid entered(n);
        for (const VoxelIndex& v : voxels) {
            entered.set(v.x, v.y, v.z);
        }
        const double reach = 0.5 + 8 * random.unit();
        ASSERT_TRUE(centres_can_tell(n, reach));
        const ToldByCentres told = told_by_centres(entered, reach, Workers(1 + round % 3));
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y) {
                for (int x = 0; x < n.x; ++x) {
                    double least = 1e9;
                    for (const VoxelIndex& v : voxels) {
                        least = std::min(least, std::hypot(v.x - x, v.y - y, v.z - z));
                    }
                    ASSERT_EQ(told.near.get(x, y, z), least < reach - 1e-5);
                    ASSERT_EQ(told.far.get(x, y, z), least >= reach + std::numbers::sqrt3 + 1e-5);
                }
            }
        }
    }
}

TEST(CentreDistances, CannotTellOfGapsThatAreTooLong) {
    EXPECT_TRUE(centres_can_tell({300, 300, 300}, 120));
    EXPECT_FALSE(centres_can_tell({300, 300, 300}, 127));
    EXPECT_FALSE(centres_can_tell({300, 300, 300}, 1e12));
    EXPECT_FALSE(centres_can_tell({3000, 3000, 3000}, 20));
}

/// Of few triangles and of many, by way of all of them and by way of each voxel.
TEST(NearMesh, IsWhatItsTrianglesAreNearTo) {
    const Vec3 corner{-30.3, -28.1, -29.7};
    for (const Mesh& mesh : {test::cube_mesh(20), test::torus_mesh(15, 5), test::torus_mesh(14, 6, 120, 60)}) {
        const GridMesh grid_mesh(mesh, corner, 1);
        const VoxelIndex first{-3, 2, -1};
        for (const double reach : {1.71, 4.03, 6.22, 11.34}) {  // no tops of tori so far from layers
            BitGrid plain({75, 68, 71});
            plain.set(40, 30, 30);  // stays, wherever it is
            BitGrid grid = plain, threaded = plain;
            for (std::int64_t i = 0; i < grid_mesh.size(); ++i) {
                set_near(plain, first, grid_mesh[i], reach, Workers(1));
            }
            set_near(grid, first, grid_mesh, reach, Workers(1));
            set_near(threaded, first, grid_mesh, reach, Workers(3));
            EXPECT_TRUE(grid == plain) << mesh.triangles.size() << " triangles, " << reach;
            EXPECT_TRUE(threaded == plain) << mesh.triangles.size() << " triangles, " << reach;
        }
    }
}

}  // namespace
}  // namespace spectralpack
