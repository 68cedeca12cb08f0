#include "disassembly/ways/flood_fill.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "core/random.hpp"
#include "search/cpu/cpu_search.hpp"

namespace spectralpack {
namespace {

BitGrid filled(const Extent& extent) {
    BitGrid grid(extent);
    grid.fill(true);
    return grid;
}

bool is_outside(const VoxelIndex& q, const Extent& solid, const VoxelBox& rest) {
    for (int axis = 0; axis < 3; ++axis) {
        if (q[axis] + solid[axis] <= rest.lo[axis] || q[axis] >= rest.hi[axis]) return true;
    }
    return false;
}

/// Steps of a shortest way outside through positions visited, by plain breadth-first search; -1 where there is none.
int plain_steps(ReachableRegion& region, const VoxelIndex& start, const Extent& solid, const VoxelBox& rest) {
    const Extent& e = region.extent();
    Grid<int> steps(e, -1);
    std::deque<VoxelIndex> open{start - region.origin()};
    steps.at(open.front().x, open.front().y, open.front().z) = 0;
    while (!open.empty()) {
        const VoxelIndex at = open.front();
        open.pop_front();
        if (is_outside(at + region.origin(), solid, rest)) return steps.at(at.x, at.y, at.z);
        for (int move = 0; move < 6; ++move) {
            VoxelIndex next = at;
            next[move / 2] += move % 2 == 0 ? 1 : -1;
            if (!e.contains(next) || !region.visited(next + region.origin()) || steps.at(next.x, next.y, next.z) >= 0)
                continue;
            steps.at(next.x, next.y, next.z) = steps.at(at.x, at.y, at.z) + 1;
            open.push_back(next);
        }
    }
    return -1;
}

// Rows of up to three words, so that ways lead from word to word.
TEST(FloodFill, FindsShortestWaysThroughWhatWasVisited) {
    int long_ways = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        TraySetup setup;
        const Extent n{6 + static_cast<int>(random.below(150)), 6 + static_cast<int>(random.below(6)), 6};
        setup.size = {1.0 * n.x, 1.0 * n.y, 1.0 * n.z};
        setup.voxel_size = 1;
        Tray tray(setup);
        const Extent a{1 + static_cast<int>(random.below(2)), 1 + static_cast<int>(random.below(2)), 1};
        const auto solid = std::make_shared<const BitGrid>(filled(a));
        BitGrid walls(n);
        const std::uint64_t share = 20 + random.below(40);
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y) {
                for (int x = 0; x < n.x; ++x) {
                    if (random.below(100) < share) walls.set(x, y, z);
                }
            }
        }
        tray.add({std::make_shared<const BitGrid>(walls), {}, 0, false});
        const auto engine = make_cpu_search({}, Workers(1));
        const auto tiles = engine->free_tiles(tray, solid, {});
        ReachableRegion region(*tiles, a, whole(n), {});
        Shape shape;
        shape.orientations.resize(1);
        shape.orientations.front().solid = solid;
        const FreePositions free = engine->free_positions(tray, shape, 0, {});
        const Extent& e = free.free.extent();
        for (int asked = 0; asked < 20; ++asked) {
            const VoxelIndex at{static_cast<int>(random.below(static_cast<std::uint64_t>(e.x))),
                                static_cast<int>(random.below(static_cast<std::uint64_t>(e.y))),
                                static_cast<int>(random.below(static_cast<std::uint64_t>(e.z)))};
            const VoxelIndex start = free.origin + at;
            if (!region.free(start) || region.visited(start) || !region.contains(start)) continue;
            // The first walk ends outside, later ones perhaps where they meet what has a way.
            const std::vector<VoxelIndex> way = FloodFill(region).way_out(start);
            ASSERT_FALSE(way.empty());
            EXPECT_EQ(way.front(), start);
            EXPECT_TRUE(is_outside(way.back(), a, whole(n)));
            int steps = 0;
            for (std::size_t k = 1; k < way.size(); ++k) {
                VoxelIndex d = way[k] - way[k - 1], here = way[k - 1];
                EXPECT_EQ((d.x != 0) + (d.y != 0) + (d.z != 0), 1);
                if (k > 1) {
                    const VoxelIndex before = way[k - 1] - way[k - 2];
                    EXPECT_EQ(before.x * d.x + before.y * d.y + before.z * d.z, 0);
                }
                for (; !(here == way[k]); ++steps) {
                    for (int axis = 0; axis < 3; ++axis) {
                        here[axis] += (d[axis] > 0) - (d[axis] < 0);
                    }
                    ASSERT_TRUE(region.visited(here));
                    const VoxelIndex i = here - free.origin;
                    ASSERT_TRUE(free.free.get(i.x, i.y, i.z));
                }
            }
            EXPECT_EQ(steps, plain_steps(region, start, a, whole(n)));
            long_ways += steps > 4;
        }
    }
    EXPECT_GT(long_ways, 50);
}

TEST(FloodFill, EndsEarlyWhenStopped) {
    // A hollow of 8000 positions with a hole in the far corner.
    TraySetup setup;
    setup.size = {22, 22, 22};
    setup.voxel_size = 1;
    Tray tray(setup);
    BitGrid walls = filled({22, 22, 22});
    subtract(walls, filled({20, 20, 20}), {1, 1, 1});
    subtract(walls, filled({1, 1, 1}), {21, 20, 20});
    tray.add({std::make_shared<const BitGrid>(walls), {}, 0, false});
    const auto solid = std::make_shared<const BitGrid>(filled({1, 1, 1}));
    const ObjectId self = tray.add({solid, {3, 3, 3}, 0, false});
    const auto engine = make_cpu_search({}, Workers(1));
    const auto tiles = engine->free_tiles(tray, solid, {self, 1});
    ReachableRegion region(*tiles, {1, 1, 1}, whole({22, 22, 22}), {});
    ASSERT_TRUE(region.contains({3, 3, 3}));
    EXPECT_FALSE(FloodFill(region).way_out({3, 3, 3}).empty());
    StopSource stop;
    stop.request(StopReason::time_limit);
    EXPECT_TRUE(FloodFill(region, stop.token()).way_out({3, 3, 3}).empty());
}

}  // namespace
}  // namespace spectralpack
