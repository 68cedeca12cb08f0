/// What the cpu engine keeps of a tray, against its definition voxel by voxel.

#include <gtest/gtest.h>

#include <algorithm>

#include "random_scene.hpp"
#include "search/cpu/depths.hpp"
#include "search/cpu/incumbent.hpp"
#include "search/cpu/plan.hpp"
#include "search/cpu/runs.hpp"
#include "search/cpu/tray_tables.hpp"

namespace spectralpack::test {
namespace {

TEST(Runs, CoverEachVoxelOnceAndAreMaximal) {
    RandomStream random(1);
    for (int i = 0; i < 60; ++i) {
        const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {140, 6, 9}));
        const std::vector<std::int64_t> counts = count_runs(solid);
        for (int axis = 0; axis < 3; ++axis) {
            const Runs runs = runs_along(solid, axis);
            EXPECT_EQ(static_cast<std::int64_t>(runs.runs.size()),
                      counts[static_cast<std::size_t>(axis)]);
            EXPECT_EQ(runs.voxels, solid.count());
            BitGrid drawn(solid.extent());
            for (const auto& run : runs.runs) {
                VoxelIndex v = run.start;
                for (int k = 0; k < run.length; ++k, ++v[axis]) {
                    EXPECT_FALSE(drawn.get(v.x, v.y, v.z));
                    drawn.set(v.x, v.y, v.z);
                }
                // Nothing beyond either end.
                const auto solid_at = [&](const VoxelIndex& w) {
                    return solid.extent().contains(w) && solid.get(w.x, w.y, w.z);
                };
                EXPECT_FALSE(solid_at(v));
                v = run.start;
                --v[axis];
                EXPECT_FALSE(solid_at(v));
            }
            EXPECT_EQ(drawn, solid);
        }
        EXPECT_EQ(static_cast<std::int64_t>(fewest_runs(solid).runs.size()),
                  *std::ranges::min_element(counts));
    }
}

TEST(BitTables, AreDilationsByPowersOfTwo) {
    RandomStream random(2);
    for (int i = 0; i < 12; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {90, 12, 10});
        const int margin = between(random, 0, 3);
        const BitGrid occupied = random_bits(random, n, 9);
        BitTables tables(n, margin, 1, 1, 1);
        tables.refresh(1, {&occupied}, whole(n));
        for (int question = 0; question < 4000; ++question) {
            const int axis = between(random, 0, 2), level = between(random, 0, BitTables::kLevels);
            VoxelIndex at;
            for (int a = 0; a < 3; ++a) {
                at[a] = between(random, -margin, n[a] + margin - 1);
            }
            bool expected = false;
            VoxelIndex v = at;
            for (int k = 0; k < 1 << level; ++k, ++v[axis]) {
                expected |= n.contains(v) && occupied.get(v.x, v.y, v.z);
            }
            const BitTables::Place place = tables.place(1, axis, level, at);
            const std::uint64_t word = tables.tile(0, 0, 0)[place.offset];
            EXPECT_EQ((word >> place.shift & 1) != 0, expected);
            EXPECT_EQ(tables.tile(0, 0, 0)[tables.place(0, axis, level, at).offset], 0u);
        }
    }
}

TEST(BitTables, FollowChangesAsIfMadeAfresh) {
    RandomStream random(3);
    const Extent n{100, 17, 23};
    BitGrid occupied(n);
    BitTables tables(n, 2, 1, 1, 0);
    for (int i = 0; i < 40; ++i) {
        const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {70, 9, 9}));
        const Extent& e = solid.extent();
        const VoxelIndex at{between(random, -5, n.x), between(random, -5, n.y),
                            between(random, -5, n.z)};
        one_in(random, 3) ? subtract(occupied, solid, at) : unite(occupied, solid, at);
        tables.refresh(0, {&occupied}, {at, at + VoxelIndex{e.x, e.y, e.z}});
        BitTables fresh(n, 2, 1, 1, 0);
        fresh.refresh(0, {&occupied}, whole(n));
        EXPECT_TRUE(fresh == tables);
    }
}

TEST(DistanceGrid, IsTheManhattanDistanceAfterEveryAddition) {
    RandomStream random(4);
    for (int i = 0; i < 20; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {50, 33, 21});
        const Ceiling ceiling = one_in(random, 2) ? Ceiling::open : Ceiling::closed;
        BitGrid occupied(n);
        DistanceGrid phi(n, ceiling);
        for (int step = 0; step < 6; ++step) {
            const Grid<std::int32_t> before = manhattan_distance(occupied, ceiling);
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {9, 9, 9}));
            const VoxelIndex at{between(random, -9, n.x), between(random, -9, n.y),
                                between(random, -9, n.z)};
            unite(occupied, solid, at);
            const VoxelBox changed = phi.add(solid, at, Workers(2));
            const Grid<std::int32_t> expected = manhattan_distance(occupied, ceiling);
            for_each_voxel(n, [&](int x, int y, int z) {
                EXPECT_EQ(phi.at(x, y, z), expected.at(x, y, z));
                EXPECT_LE(phi.at(x, y, z), phi.most());
                const VoxelIndex v{x, y, z};
                const VoxelBox voxel{v, v + VoxelIndex{1, 1, 1}};
                if (intersection(voxel, changed).empty()) {
                    EXPECT_EQ(before.at(x, y, z), expected.at(x, y, z));
                }
            });
            phi.tighten_most();
            EXPECT_EQ(phi.most(), *std::ranges::max_element(expected.values()));
        }
    }
}

TEST(SumTables, GiveTheSumOfEveryRunOfPooledDistances) {
    RandomStream random(5);
    for (const int block : {1, 2, 4, 8}) {
        const bool apart = block == 2 || block == 4;
        const Extent n = random_extent(random, {5, 4, 3}, {70, 19, 23});
        DistanceGrid phi(n, Ceiling::closed);
        SumTables tables(n, block, apart);
        tables.update(phi, whole(n), Workers(1));
        for (int step = 0; step < 5; ++step) {
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {9, 7, 5}));
            const VoxelIndex at{between(random, 0, n.x), between(random, 0, n.y),
                                between(random, 0, n.z)};
            tables.update(phi, phi.add(solid, at, Workers(1)), Workers(2));
        }
        const auto pooled = [&](const VoxelIndex& v) {
            int least = apart ? SumTables::kMostPooled : phi.most();
            for_each_voxel({block, block, block}, [&](int x, int y, int z) {
                const VoxelIndex w = v + VoxelIndex{x, y, z};
                if (!n.contains(w) || (apart && phi.at(w.x, w.y, w.z) == 0)) return;
                least = std::min<int>(least, phi.at(w.x, w.y, w.z));
            });
            return least;
        };
        for (int question = 0; question < 500; ++question) {
            const int axis = between(random, 0, 2);
            VoxelIndex from{between(random, 0, n.x - 1), between(random, 0, n.y - 1),
                            between(random, 0, n.z - 1)};
            VoxelIndex to = from;
            to[axis] = between(random, from[axis], n[axis]);
            int expected = 0;
            for (VoxelIndex v = from; v[axis] < to[axis]; ++v[axis]) {
                expected += pooled(v);
            }
            const std::uint16_t* base = tables.base(0, 0, 0);
            EXPECT_EQ(static_cast<std::uint16_t>(base[tables.offset(axis, to)] -
                                                 base[tables.offset(axis, from)]),
                      expected);
        }
    }
}

TEST(SumPlan, SplitsWhatSixteenBitsCannotHold) {
    BitGrid solid({200, 2, 3});
    solid.fill(true);
    const OrientationRuns runs = make_runs({0, {}, {}, std::make_shared<const BitGrid>(solid), {}}, 1, true);
    const SumTables tables({210, 9, 8}, 1, false);
    for (const int most : {1, 150, 5000, 65535}) {
        const SumPlan plan = plan_sum(runs, tables, most);
        std::int64_t voxels = 0;
        for (const SumBatch& batch : plan.batches) {
            std::int64_t in_batch = 0;
            for (std::int32_t i = batch.begin; i < batch.end; ++i) {
                const SumLoad& load = plan.loads[static_cast<std::size_t>(i)];
                in_batch += load.plus - load.minus;  // along x: elements are voxels
            }
            EXPECT_LE(in_batch * most, 65535);
            voxels += in_batch;
        }
        EXPECT_EQ(voxels, solid.count());
    }
}

TEST(Depths, AreTheDistanceToTheOutside) {
    RandomStream random(7);
    for (int i = 0; i < 60; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {i % 2 ? 150 : 12, i % 3 ? 9 : 140, 11});
        BitGrid solid = random_solid(random, n);
        if (i % 4 == 0) solid.fill(true);
        BitGrid outside(n);
        for_each_voxel(n, [&](int x, int y, int z) { outside.set(x, y, z, !solid.get(x, y, z)); });
        const Grid<std::int32_t> depth = manhattan_distance(outside, Ceiling::closed);
        for (int axis = 0; axis < 3; ++axis) {
            const Runs runs = runs_along(solid, axis);
            const std::vector<std::uint32_t> sums = depth_sums(solid, runs, runs);
            ASSERT_EQ(sums.size(), runs.runs.size());
            for (std::size_t k = 0; k < sums.size(); ++k) {
                std::uint32_t expected = 0;
                VoxelIndex v = runs.runs[k].start;
                for (int step = 0; step < runs.runs[k].length; ++step, ++v[axis]) {
                    expected += static_cast<std::uint32_t>(std::min(kDeepest, depth.at(v.x, v.y, v.z)));
                }
                EXPECT_EQ(sums[k], expected);
            }
        }
    }
}

TEST(ProximityLimit, IsTheGreatestProximityThatCouldWin) {
    RandomStream random(6);
    for (int i = 0; i < 2000; ++i) {
        const CostModel model = random_model(random);
        const int layers = between(random, 1, 9), reference = between(random, 1, 200);
        Placed best;
        best.proximity = between(random, 0, 5000);
        best.position.z = between(random, 0, 150);
        best.cost =
            cost_of(model, best.position.z, between(random, 1, 9), reference, best.proximity);
        best.index = between(random, 0, 3);
        const int index = between(random, 0, 3), z = between(random, 0, 150);
        const std::int64_t limit = proximity_limit(model, z, layers, reference, best, index);
        const auto wins = [&](std::int64_t rho) {
            const Cost cost = cost_of(model, z, layers, reference, rho);
            return cost < best.cost || (cost == best.cost && index <= best.index);
        };
        const std::int64_t above_all = 1'000'000'000'000;
        EXPECT_TRUE(limit < 0 || wins(std::min(limit, above_all)));
        EXPECT_TRUE(limit == kNoLimit || !wins(limit + 1));
    }
    EXPECT_EQ(proximity_limit({}, 3, 2, 10, std::nullopt, 0), kNoLimit);
}

}  // namespace
}  // namespace spectralpack::test
