#include "packing/interlocking/samples.hpp"

#include <gtest/gtest.h>

#include "search/plain_region.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

/// Mostly full.
BitGrid thick_noise(RandomStream& random, const Extent& extent) {
    BitGrid bits(extent);
    for_each_voxel(extent, [&](int x, int y, int z) { bits.set(x, y, z, !one_in(random, 12)); });
    return bits;
}

TEST(LinkCells, CollideOnlyWhereAllTheirPositionsDo) {
    RandomStream random(11);
    int blocked = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const BitGrid object = thick_noise(random, random_extent(random, {1, 1, 1}, {70, 7, 7}));
        const BitGrid sample = random_bits(random, random_extent(random, {1, 1, 1}, {70, 6, 6}), 2);
        const BitGrid object_cells = object_in_cells(object), sample_cells = sample_in_cells(sample);
        const Extent &n = object.extent(), &a = sample.extent();
        for_each_voxel({n.x + a.x, n.y + a.y, n.z + a.z}, [&](int x, int y, int z) {
            const VoxelIndex q{x - a.x, y - a.y, z - a.z};
            const bool collides = intersects(object_cells, sample_cells, cell_of(q));
            if (!collides) return;
            ++blocked;
            ASSERT_TRUE(intersects(object, sample, q)) << trial << ": " << q.x << " " << q.y << " " << q.z;
        });
    }
    EXPECT_GT(blocked, 10'000);
}

TEST(LinkCells, AreOutsideWhereAnyOfTheirPositionsIs) {
    for (int n = 1; n <= 4; ++n) {
        for (int a = 1; a <= 4; ++a) {
            const int cells = object_in_cells(BitGrid({1, n, n})).extent().y;
            const int sample = sample_in_cells(BitGrid({1, a, a})).extent().y;
            for (int y = -a - 2; y <= n + 2; ++y) {
                const int cell = cell_of({0, y, 0}).y;
                const bool outside = (y >= n && n > 1) || y + a <= 0;  // one voxel across is no cell, and holds nothing
                EXPECT_TRUE(!outside || cell >= cells || cell + sample <= 0) << n << " " << a << " " << y;
            }
        }
    }
}

TEST(LinkCells, KeepHoldingWhatAThickCageHolds) {
    BitGrid cage({14, 14, 14});
    cage.fill(true);
    for_each_voxel({8, 8, 8}, [&](int x, int y, int z) { cage.set(3 + x, 3 + y, 3 + z, false); });
    BitGrid ball({4, 4, 4});
    ball.fill(true);
    const auto reaches_outside = [](const BitGrid& object, const BitGrid& solid, const VoxelIndex& from) {
        const FreePositions free = free_beside(object, solid);
        const VoxelIndex at = from - free.origin;
        return plain_region(free).get(at.x, at.y, at.z);
    };
    const VoxelIndex inside{5, 5, 5};
    EXPECT_FALSE(reaches_outside(cage, ball, inside));
    EXPECT_FALSE(reaches_outside(object_in_cells(cage), sample_in_cells(ball), cell_of(inside)));
}

}  // namespace
}  // namespace spectralpack::test
