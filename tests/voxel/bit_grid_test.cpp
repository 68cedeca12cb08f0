#include "voxel/bit_grid.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "plain_voxels.hpp"
#include "voxel/enclosed.hpp"

namespace spectralpack {
namespace {

int between(RandomStream& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
}

Extent any_extent(RandomStream& random) {
    // Rows of less than a word, of whole words and of several.
    const int x = random.below(4) == 0 ? 64 * between(random, 1, 4) : between(random, 1, 200);
    const int y = between(random, 1, 8);
    return {x, y, between(random, 1, 8)};
}

BitGrid any_grid(const Extent& n, int per_cent, RandomStream& random) {
    BitGrid grid(n);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                grid.set(x, y, z, between(random, 0, 100) < per_cent);
            }
        }
    }
    return grid;
}

/// Calls visit(x, y, z of the target, whether the source has a voxel there).
template <class Visit>
void for_each_pair(const Extent& n, const BitGrid& source, const VoxelIndex& at, Visit visit) {
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                const VoxelIndex i = VoxelIndex{x, y, z} - at;
                visit(x, y, z, source.extent().contains(i) && source.get(i.x, i.y, i.z));
            }
        }
    }
}

TEST(BitGrid, UniteSubtractAndIntersectAreVoxelByVoxel) {
    int met = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        RandomStream random(seed);
        const int per_cent = between(random, 0, 30);
        const BitGrid target = any_grid(any_extent(random), per_cent, random);
        const BitGrid source = any_grid(any_extent(random), per_cent, random);
        const int dx = between(random, -210, 210), dy = between(random, -6, 7);
        const VoxelIndex at{dx, dy, between(random, -6, 7)};
        BitGrid united(target.extent()), subtracted(target.extent());
        bool meet = false;
        for_each_pair(target.extent(), source, at, [&](int x, int y, int z, bool bit) {
            united.set(x, y, z, target.get(x, y, z) || bit);
            subtracted.set(x, y, z, target.get(x, y, z) && !bit);
            meet = meet || (target.get(x, y, z) && bit);
        });
        BitGrid result = target;
        unite(result, source, at);
        ASSERT_TRUE(result == united) << seed;  // spare bits included
        result = target;
        subtract(result, source, at);
        ASSERT_TRUE(result == subtracted) << seed;
        ASSERT_EQ(intersects(target, source, at), meet) << seed;
        met += meet ? 1 : 0;
    }
    EXPECT_GT(met, 50);
    EXPECT_LT(met, 350);
}

TEST(BitGrid, FillAndCountLeaveTheSpareBitsAlone) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        RandomStream random(seed);
        const Extent n = any_extent(random);
        BitGrid grid(n);
        EXPECT_TRUE(grid.none());
        EXPECT_EQ(grid.count(), 0);
        grid.fill(true);
        EXPECT_EQ(grid.count(), n.count());
        BitGrid by_voxel(n);
        for_each_pair(n, grid, {}, [&](int x, int y, int z, bool bit) { by_voxel.set(x, y, z, bit); });
        EXPECT_EQ(by_voxel, grid);
        const int x = between(random, 0, n.x), y = between(random, 0, n.y);
        grid.set(x, y, n.z - 1, false);
        EXPECT_FALSE(grid.get(x, y, n.z - 1));
        EXPECT_EQ(grid.count(), n.count() - 1);
        grid.fill(false);
        EXPECT_EQ(grid, BitGrid(n));
    }
}

TEST(FillEnclosed, IsTheVoxelByVoxelFlood) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        RandomStream random(seed);
        // From open to nearly full; at about two thirds solid, paths wind.
        const int per_cent = between(random, 5, 95);
        const BitGrid grid = any_grid(any_extent(random), per_cent, random);
        BitGrid expected = grid, filled = grid;
        test::plain_fill(expected);
        fill_enclosed(filled);
        ASSERT_TRUE(filled == expected) << seed;
    }
}

TEST(FillEnclosed, FollowsALabyrinth) {
    // One corridor that winds through every layer: rows are visited many times.
    const Extent n{131, 21, 9};
    BitGrid grid(n);
    grid.fill(true);
    for (int z = 1; z < n.z - 1; z += 2) {
        for (int y = 1; y < n.y - 1; y += 2) {
            for (int x = 1; x < n.x - 1; ++x) {
                grid.set(x, y, z, false);
            }
            if (y + 2 < n.y - 1) grid.set(y % 4 == 1 ? n.x - 2 : 1, y + 1, z, false);
        }
        if (z + 2 < n.z - 1) grid.set(z % 4 == 1 ? n.x - 2 : 1, z % 4 == 1 ? n.y - 2 : 1, z + 1, false);
    }
    BitGrid closed = grid;
    fill_enclosed(closed);
    EXPECT_EQ(closed.count(), n.count());
    grid.set(0, 1, 1, false);
    BitGrid open = grid;
    fill_enclosed(open);
    EXPECT_EQ(open, grid);
}

}  // namespace
}  // namespace spectralpack
