#include "disassembly/flood_fill.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <map>

#include "core/random.hpp"
#include "search/cpu/cpu_search.hpp"

namespace spectralpack {
namespace {

BitGrid filled(const Extent& extent) {
    BitGrid grid(extent);
    grid.fill(true);
    return grid;
}

/// Steps of a shortest way by plain breadth-first search; -1 where there is none.
int plain_steps(const FreePositions& free, const VoxelIndex& start, const Extent& solid, const VoxelBox& rest) {
    const auto outside = [&](const VoxelIndex& q) {
        for (int axis = 0; axis < 3; ++axis) {
            if (q[axis] + solid[axis] <= rest.lo[axis] || q[axis] >= rest.hi[axis]) return true;
        }
        return false;
    };
    const Extent& e = free.free.extent();
    Grid<int> steps(e, -1);
    std::deque<VoxelIndex> open{start - free.origin};
    steps.at(open.front().x, open.front().y, open.front().z) = 0;
    while (!open.empty()) {
        const VoxelIndex at = open.front();
        open.pop_front();
        if (outside(at + free.origin)) return steps.at(at.x, at.y, at.z);
        for (int move = 0; move < 6; ++move) {
            VoxelIndex next = at;
            next[move / 2] += move % 2 == 0 ? 1 : -1;
            if (!e.contains(next) || !free.free.get(next.x, next.y, next.z) || steps.at(next.x, next.y, next.z) >= 0)
                continue;
            steps.at(next.x, next.y, next.z) = steps.at(at.x, at.y, at.z) + 1;
            open.push_back(next);
        }
    }
    return -1;
}

TEST(FloodFill, FindsShortestWaysThroughRandomVoxels) {
    int found = 0, closed = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        RandomStream random(seed);
        TraySetup setup;
        const Extent n{6 + static_cast<int>(random.below(8)), 6 + static_cast<int>(random.below(5)), 5};
        setup.size = {1.0 * n.x, 1.0 * n.y, 1.0 * n.z};
        setup.voxel_size = 1;
        Tray tray(setup);
        const Extent a{1 + static_cast<int>(random.below(2)), 1 + static_cast<int>(random.below(2)), 1};
        const VoxelIndex start{n.x / 2, n.y / 2, n.z / 2};
        const auto solid = std::make_shared<const BitGrid>(filled(a));
        BitGrid walls(n);
        const std::uint64_t share = random.below(60);
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y) {
                for (int x = 0; x < n.x; ++x) {
                    if (random.below(100) < share) walls.set(x, y, z);
                }
            }
        }
        subtract(walls, *solid, start);
        tray.add({std::make_shared<const BitGrid>(walls), {}, 0, false});
        const ObjectId self = tray.add({solid, start, 0, false});
        const VoxelBox rest = whole(n);
        Shape shape;
        shape.orientations.resize(1);
        shape.orientations.front().solid = solid;
        const auto engine = make_cpu_search({}, Workers(1));
        const auto tiles = engine->free_tiles(tray, solid, {self, 1});
        FloodFill flood(*tiles, a, rest);
        const std::vector<VoxelIndex> way = flood.way_out(start);
        const FreePositions free = engine->free_positions(tray, shape, 0, {self, 1});
        const int expected = plain_steps(free, start, a, rest);
        if (expected < 0) {
            EXPECT_TRUE(way.empty());
            ++closed;
            continue;
        }
        ++found;
        ASSERT_FALSE(way.empty());
        EXPECT_EQ(way.front(), start);
        int steps = 0;
        for (std::size_t k = 1; k < way.size(); ++k) {
            VoxelIndex d = way[k] - way[k - 1], at = way[k - 1];
            EXPECT_EQ((d.x != 0) + (d.y != 0) + (d.z != 0), 1);
            for (; !(at == way[k]); ++steps) {
                for (int axis = 0; axis < 3; ++axis) {
                    at[axis] += (d[axis] > 0) - (d[axis] < 0);
                }
                const VoxelIndex i = at - free.origin;
                ASSERT_TRUE(free.free.get(i.x, i.y, i.z));
            }
        }
        EXPECT_EQ(steps, expected);
    }
    EXPECT_GT(found, 50);
    EXPECT_GT(closed, 20);
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
    const auto way = [&](const StopToken& stop) {
        const auto tiles = engine->free_tiles(tray, solid, {self, 1});
        return FloodFill(*tiles, {1, 1, 1}, whole({22, 22, 22}), stop).way_out({3, 3, 3});
    };
    EXPECT_FALSE(way({}).empty());
    StopSource stop;
    stop.request(StopReason::time_limit);
    EXPECT_TRUE(way(stop.token()).empty());
}

}  // namespace
}  // namespace spectralpack
