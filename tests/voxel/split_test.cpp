/// Fine voxels in their parts and in coarse voxels, against loops over voxels.

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "voxel/split.hpp"

namespace spectralpack::test {
namespace {

BitGrid noise(RandomStream& random, const Extent& extent, std::uint64_t most_in) {
    BitGrid bits(extent);
    for (int z = 0; z < extent.z; ++z) {
        for (int y = 0; y < extent.y; ++y) {
            for (int x = 0; x < extent.x; ++x) {
                bits.set(x, y, z, random.below(most_in) != 0);
            }
        }
    }
    return bits;
}

/// Fine voxel `at` of a grid whose voxel (0,0,0) is `first`.
bool set_at(const BitGrid& fine, const VoxelIndex& first, const VoxelIndex& at) {
    const VoxelIndex v = at - first;
    return fine.extent().contains(v) && fine.get(v.x, v.y, v.z);
}

int random_between(RandomStream& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low + 1)));
}

TEST(Split, PartsAndCoarseVoxelsHoldWhatTheFineOnesDo) {
    RandomStream random(5);
    for (int trial = 0; trial < 200; ++trial) {
        const int s = random_between(random, 1, 4);
        const Extent extent{random_between(random, 1, 150), random_between(random, 1, 9), random_between(random, 1, 9)};
        const BitGrid fine = noise(random, extent, trial % 2 == 0 ? 30 : 3);
        const VoxelIndex at{random_between(random, -9, 9), random_between(random, -9, 9),
                            random_between(random, -9, 9)};
        const SplitVoxels parts = split(fine, at, s);
        const CoarseVoxels reached = reached_voxels(fine, at, s), filled = filled_voxels(fine, at, s);
        ASSERT_EQ(parts.parts.size(), static_cast<std::size_t>(part_count(s)));
        ASSERT_EQ(reached.voxels.extent(), filled.voxels.extent());
        std::int64_t fine_voxels = 0;
        for (const BitGrid& part : parts.parts) {
            ASSERT_EQ(part.extent(), reached.voxels.extent());
            fine_voxels += part.count();
        }
        EXPECT_EQ(fine_voxels, fine.count());
        const Extent& e = reached.voxels.extent();
        for (int z = 0; z < e.z; ++z) {
            for (int y = 0; y < e.y; ++y) {
                for (int x = 0; x < e.x; ++x) {
                    const VoxelIndex coarse = VoxelIndex{x, y, z} + reached.offset;
                    bool some = false, all = true;
                    for (int p = 0; p < part_count(s); ++p) {
                        const VoxelIndex v{s * coarse.x + p % s, s * coarse.y + p / s % s, s * coarse.z + p / s / s};
                        const bool set = set_at(fine, at, v);
                        some = some || set;
                        all = all && set;
                        ASSERT_EQ(parts.parts[static_cast<std::size_t>(p)].get(x, y, z), set);
                    }
                    ASSERT_EQ(reached.voxels.get(x, y, z), some);
                    ASSERT_EQ(filled.voxels.get(x, y, z), all);
                }
            }
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
