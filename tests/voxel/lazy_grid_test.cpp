#include "voxel/lazy_grid.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "core/parallel.hpp"

namespace spectralpack {
namespace {

BitGrid with_a_voxel(const Extent& extent, const VoxelIndex& at) {
    BitGrid grid(extent);
    grid.set(at.x, at.y, at.z);
    return grid;
}

TEST(LazyGrid, IsMadeOnceWhoeverAsks) {
    const Workers workers(4);
    for (int i = 0; i < 200; ++i) {
        std::atomic<int> made = 0;
        const LazyGrid grid({5, 4, 3}, [&] {
            ++made;
            return with_a_voxel({5, 4, 3}, {1, 2, 0});
        });
        const LazyGrid copy = grid;
        EXPECT_EQ(copy.extent(), (Extent{5, 4, 3}));
        EXPECT_EQ(copy.bytes(), 0);
        EXPECT_EQ(made, 0);
        workers.for_each(8, [&](std::int64_t k) { EXPECT_TRUE((k % 2 == 0 ? grid : copy)->get(1, 2, 0)); });
        EXPECT_EQ(made, 1);
        EXPECT_EQ(&*grid, copy.share().get());
        EXPECT_EQ(copy.bytes(), grid->bytes());
    }
}

TEST(LazyGrid, IsEqualToItselfAlone) {
    const LazyGrid none, a(with_a_voxel({2, 2, 2}, {})), b(with_a_voxel({2, 2, 2}, {})), same = a;
    EXPECT_TRUE(a == same);
    EXPECT_FALSE(a == b);
    EXPECT_EQ(*a, *b);
    EXPECT_FALSE(none);
    EXPECT_EQ(none.share(), nullptr);
    EXPECT_EQ(none.bytes(), 0);
    EXPECT_FALSE(LazyGrid(std::shared_ptr<const BitGrid>()));
}

TEST(LazyGrid, OutlivesWhatItIsTurnedFrom) {
    const AxisTurn turn{{1, 0, 2}, {false, false, true}};
    LazyGrid grid(with_a_voxel({5, 4, 3}, {1, 2, 0}));
    const BitGrid expected = turned(*grid, turn);
    const LazyGrid derived = turned(grid, turn);
    const std::shared_ptr<const BitGrid> held = grid.share();
    grid = {};
    EXPECT_EQ(derived.extent(), expected.extent());
    EXPECT_EQ(held.use_count(), 2);
    EXPECT_EQ(*derived, expected);
    EXPECT_EQ(held.use_count(), 1);  // what it was made from is not held any longer
}

TEST(LazyGrid, IsMadeLaterWhereThatFailedBefore) {
    int tries = 0;
    const LazyGrid grid({1, 1, 1}, [&] {
        if (++tries == 1) throw std::runtime_error("no memory");
        return with_a_voxel({1, 1, 1}, {});
    });
    EXPECT_THROW(*grid, std::runtime_error);
    EXPECT_EQ(grid.bytes(), 0);
    EXPECT_EQ(grid->count(), 1);
}

}  // namespace
}  // namespace spectralpack
