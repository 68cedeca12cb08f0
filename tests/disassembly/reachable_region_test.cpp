#include "disassembly/ways/reachable_region.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/plain_region.hpp"

namespace spectralpack {
namespace {

bool is_outside(const VoxelIndex& q, const Extent& solid, const VoxelBox& rest) {
    for (int axis = 0; axis < 3; ++axis) {
        if (q[axis] + solid[axis] <= rest.lo[axis] || q[axis] >= rest.hi[axis]) return true;
    }
    return false;
}

// Rows of up to three words, so that ways lead from word to word.
TEST(ReachableRegion, HoldsWhatReachesOutsideThroughRandomVoxels) {
    int inside = 0, closed = 0;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const Extent n{6 + static_cast<int>(random.below(150)), 5 + static_cast<int>(random.below(5)), 5};
        TraySetup setup;
        setup.size = {1.0 * n.x, 1.0 * n.y, 1.0 * n.z};
        setup.voxel_size = 1;
        Tray tray(setup);
        BitGrid walls(n);
        const std::uint64_t share = 30 + random.below(45);
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y) {
                for (int x = 0; x < n.x; ++x) {
                    if (random.below(100) < share) walls.set(x, y, z);
                }
            }
        }
        tray.add({std::make_shared<const BitGrid>(walls), {}, 0, false});
        const Extent a{1 + static_cast<int>(random.below(2)), 1 + static_cast<int>(random.below(2)), 1};
        BitGrid full(a);
        full.fill(true);
        Shape shape;
        shape.orientations.resize(1);
        shape.orientations.front().solid = std::make_shared<const BitGrid>(full);
        const auto engine = make_cpu_search({}, Workers(1));
        const FreePositions free = engine->free_positions(tray, shape, 0, {});
        const BitGrid expected = test::plain_region(free);
        const auto tiles = engine->free_tiles(tray, shape.orientations.front().solid.share(), {});
        ReachableRegion region(*tiles, a, whole(n), {});
        const Extent& e = free.free.extent();
        for (int asked = 0; asked < 1500; ++asked) {
            const VoxelIndex at{static_cast<int>(random.below(static_cast<std::uint64_t>(e.x))),
                                static_cast<int>(random.below(static_cast<std::uint64_t>(e.y))),
                                static_cast<int>(random.below(static_cast<std::uint64_t>(e.z)))};
            const bool found = expected.get(at.x, at.y, at.z);
            if (random.below(8) == 0) {
                const VoxelIndex by{static_cast<int>(random.below(70)), static_cast<int>(random.below(12)), 2};
                region.look_around({free.origin + at - by, free.origin + at + by});
            }
            const bool told = region.free(free.origin + at);
            if (!free.free.get(at.x, at.y, at.z)) {
                ASSERT_FALSE(told);
                continue;
            }
            ASSERT_TRUE(told || !found);  // not, in a closed region found closed
            ASSERT_EQ(region.contains(free.origin + at), found);
            ASSERT_EQ(region.visited(free.origin + at), found);
            ASSERT_EQ(region.free(free.origin + at), found);
            ASSERT_EQ(
                intersection(region.visited_box(), {free.origin + at, free.origin + at + VoxelIndex{1, 1, 1}}).empty(),
                false);
            if (!is_outside(free.origin + at, a, whole(n))) ++(found ? inside : closed);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(closed, 1000);
}

TEST(ReachableRegion, EndsEarlyWhenStopped) {
    TraySetup setup;
    setup.size = {30, 30, 30};
    setup.voxel_size = 1;
    const Tray tray(setup);
    BitGrid dot({1, 1, 1});
    dot.fill(true);
    const auto engine = make_cpu_search({}, Workers(1));
    const auto tiles = engine->free_tiles(tray, std::make_shared<const BitGrid>(dot), {});
    StopSource stop;
    stop.request(StopReason::cancelled);
    ReachableRegion region(*tiles, {1, 1, 1}, whole({30, 30, 30}), stop.token());
    EXPECT_FALSE(region.contains({15, 15, 15}));
}

}  // namespace
}  // namespace spectralpack
