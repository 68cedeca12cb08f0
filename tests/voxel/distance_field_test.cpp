#include "voxel/distance_field.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/random.hpp"

namespace spectralpack {
namespace {

/// Every voxel against every occupied voxel and every wall.
Grid<std::int32_t> plain_distance(const BitGrid& occupied, Ceiling ceiling) {
    const Extent& n = occupied.extent();
    Grid<std::int32_t> phi(n);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                int least = std::min({x + 1, n.x - x, y + 1, n.y - y, z + 1});
                if (ceiling == Ceiling::closed) least = std::min(least, n.z - z);
                for (int c = 0; c < n.z; ++c) {
                    for (int b = 0; b < n.y; ++b) {
                        for (int a = 0; a < n.x; ++a) {
                            if (!occupied.get(a, b, c)) continue;
                            least = std::min(least, std::abs(a - x) + std::abs(b - y) + std::abs(c - z));
                        }
                    }
                }
                phi.at(x, y, z) = least;
            }
        }
    }
    return phi;
}

TEST(ManhattanDistance, IsThatToTheNearestOccupiedVoxelOrWall) {
    RandomStream random(1);
    for (const Extent& n :
         {Extent{1, 1, 1}, {9, 14, 11}, {70, 5, 6}, {3, 20, 17}, {64, 4, 9}, {5, 1, 30}, {129, 6, 2}}) {
        for (const int voxels : {0, 1, 3, 40, 500}) {
            BitGrid occupied(n);
            for (int i = 0; i < voxels; ++i) {
                const auto along = [&](int size) {
                    return static_cast<int>(random.below(static_cast<std::uint64_t>(size)));
                };
                const int x = along(n.x), y = along(n.y), z = along(n.z);
                occupied.set(x, y, z);
            }
            for (const Ceiling ceiling : {Ceiling::closed, Ceiling::open}) {
                ASSERT_TRUE(manhattan_distance(occupied, ceiling) == plain_distance(occupied, ceiling))
                    << n.x << " x " << n.y << " x " << n.z << ", " << voxels;
            }
        }
    }
}

TEST(ManhattanDistance, OfAFullAndOfAnEmptyGrid) {
    BitGrid full({67, 3, 4});
    full.fill(true);
    EXPECT_EQ(manhattan_distance(full, Ceiling::open), Grid<std::int32_t>({67, 3, 4}, 0));
    EXPECT_EQ(manhattan_distance(BitGrid(Extent{}), Ceiling::closed), Grid<std::int32_t>(Extent{}));
    // An open ceiling is no nearer than the floor: up there the walls decide.
    EXPECT_EQ(manhattan_distance(BitGrid({9, 9, 20}), Ceiling::open).at(4, 4, 19), 5);
}

}  // namespace
}  // namespace spectralpack
