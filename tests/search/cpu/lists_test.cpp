/// The lists of look-ups and of loads, and what a scan asks of them: stretches, limits.

#include <gtest/gtest.h>

#include <algorithm>

#include "search/cpu/forms.hpp"
#include "search/cpu/scan/incumbent.hpp"
#include "search/cpu/scan/stretches.hpp"
#include "search/cpu/shapes/orientation_lists.hpp"

namespace spectralpack::test {
namespace {

TEST(Lookups, PruneTheLongerTheMoreLoadsFollowAndAlwaysLookUpAll) {
    TraySetup setup;
    setup.size = {200, 180, 160};
    setup.detail = 2;
    Tray tray(setup);
    BitGrid ball({50, 50, 50});
    for_each_voxel(ball.extent(), [&](int x, int y, int z) {
        const auto off = [](int v) { return (2 * v - 49) * (2 * v - 49); };
        ball.set(x, y, z, off(x) + off(y) + off(z) < 50 * 50);
    });
    const auto fine = std::make_shared<const BitGrid>(ball);
    tray.add(fine_object(fine, {8, 6, 4}, 2, 0));
    TrayTables tables;
    tables.follow(tray, 0, Workers(1));
    const auto solid = std::make_shared<const BitGrid>(reached_voxels(*fine, {}, 2).voxels);
    const WidenedVoxels wide{fine, {}};
    const OrientationRuns runs = make_runs({0, {}, {}, solid, {wide}, fine}, 2, tables, Workers(2)).runs;
    const std::size_t pieces = runs.widened.front().pieces.corners.size(),
                      core = runs.widened.front().core.corners.size();
    ASSERT_GT(core, 0u);
    std::vector<std::int32_t> all;
    std::size_t pruning = 0;
    for (const std::size_t loads : {std::size_t{0}, std::size_t{600}, std::size_t{1'000'000}}) {
        const CollisionLookups list = list_lookups(runs, tables, loads);
        EXPECT_GT(list.pruning, pruning);
        pruning = list.pruning;
        std::vector<std::int32_t> offsets = list.of_positions.offsets;
        EXPECT_EQ(offsets.size(), pieces + core);
        std::ranges::sort(offsets);
        if (all.empty()) all = offsets;
        EXPECT_EQ(offsets, all);
    }
}

TEST(Lookups, WhatRulesOutAStackCollidesInAllOfIt) {
    RandomStream random(11);
    std::int64_t ruled_out = 0;
    for (int round = 0; round < 40; ++round) {
        TraySetup setup;
        const int s = setup.detail = 1 + round % 2;
        setup.size = {140, 36, 30};
        setup.voxel_size = 1;
        Tray tray(setup);
        BitGrid occupied({s * 140, s * 36, s * 30});
        const auto box = [&](const Extent& most) {
            BitGrid full(random_extent(random, {1, 1, 1}, most));
            full.fill(true);
            return full;
        };
        for (int i = 0; i < 12; ++i) {
            const BitGrid solid = box({40, 20, 20});
            const VoxelIndex at{between(random, 0, s * 100), between(random, 0, s * 16), between(random, 0, s * 10)};
            unite(occupied, solid, at);
            tray.add(fine_object(std::make_shared<const BitGrid>(solid), at, s, 0));
        }
        BitGrid part = box({40, 24, 24});
        unite(part, random_solid(random, part.extent()), {});
        subtract(part, random_bits(random, part.extent(), 60), {});
        const auto fine = std::make_shared<const BitGrid>(part);
        const auto solid = std::make_shared<const BitGrid>(reached_voxels(*fine, {}, s).voxels);
        const WidenedVoxels wide{fine, {}};
        TrayTables tables;
        tables.follow(tray, 0, Workers(1));
        const OrientationRuns runs =
            make_runs({0, {}, {}, solid, {wide}, s > 1 ? LazyGrid(fine) : LazyGrid()}, s, tables, Workers(2)).runs;
        const LookupList list = list_lookups(runs, tables, 0).of_stacks;
        const BitTables& bits = tables.bits();
        const Extent last{140 - solid->extent().x, 36 - solid->extent().y, 30 - solid->extent().z};
        for_each_voxel({last.x + 1, last.y + 1, last.z + 1}, [&](int x, int y, int z) {
            const std::uint64_t* word = bits.tile(x / 64, y, z);
            const bool meets_any = std::ranges::any_of(list.groups, [&](const LookupGroup& group) {
                const int bit = x % 64 + static_cast<int>(group.shift);
                return std::any_of(list.offsets.begin() + group.begin, list.offsets.begin() + group.end,
                                   [&](std::int32_t offset) { return bit_from(word + offset, bits.next(), bit); });
            });
            if (!meets_any) return;
            for (int i = 0; i < BitTables::kTileLayers && z + i <= last.z; ++i) {
                ++ruled_out;
                EXPECT_TRUE(intersects(occupied, *fine, {s * x, s * y, s * (z + i)}));
            }
        });
    }
    EXPECT_GT(ruled_out, 50'000);
}

TEST(Loads, SplitsWhatSixteenBitsCannotHold) {
    BitGrid solid({200, 2, 3});
    solid.fill(true);
    const OrientationRuns runs =
        make_runs({0, {}, {}, std::make_shared<const BitGrid>(solid), {}}, 1, TrayTables(), Workers(1)).runs;
    const SumLayout tables({210, 9, 8}, 1);
    for (const int range : {255, 65535}) {
        for (const int most : {1, 21, 150, 5000, 65535}) {
            if (most > range) continue;
            const LoadList list = list_loads(runs, order_of_loads(runs.solid), tables, range, most);
            std::int64_t voxels = 0;
            for (const SumBatch& batch : list.batches) {
                std::int64_t in_batch = 0, least = 0;
                for (std::int32_t i = batch.begin; i < batch.end; ++i) {
                    const SumLoad& load = list.loads[static_cast<std::size_t>(i)];
                    const std::int64_t length = load.plus - load.minus;  // along x: elements are voxels
                    EXPECT_LE(length * most, range);
                    EXPECT_EQ(load.least > 0, length == 200) << "nothing is known of parts of a run";
                    in_batch += length;
                    least += load.least;
                }
                EXPECT_EQ(batch.least, least);
                EXPECT_LE(in_batch * most, 65535);
                voxels += in_batch;
            }
            EXPECT_EQ(voxels, solid.count());
        }
    }
}

TEST(Stretches, HoldEachBitOnceAndBeginWithOne) {
    RandomStream random(7);
    std::size_t fullest = 0;
    for (int i = 0; i < 500; ++i) {
        std::uint64_t rows[2] = {};
        Stretches<128> stretches;
        const int often = between(random, 1, 12);
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 64; ++x) {
                rows[y] |= static_cast<std::uint64_t>(between(random, 0, often) == 0) << x;
            }
            stretches.add(y, rows[y]);
        }
        std::uint64_t held[2] = {};
        for (const Stretch& stretch : stretches.all()) {
            EXPECT_EQ(stretch.lanes & 1, 1u);
            EXPECT_LT(stretch.lanes, 1u << kStretch);
            const std::uint64_t bits = static_cast<std::uint64_t>(stretch.lanes) << stretch.x;
            EXPECT_EQ(held[stretch.y] & bits, 0u);
            held[stretch.y] |= bits;
        }
        EXPECT_EQ(held[0], rows[0]);
        EXPECT_EQ(held[1], rows[1]);
        fullest = std::max(fullest, stretches.all().size());
    }
    Stretches<128> full;
    full.add(0, ~std::uint64_t{0});
    full.add(1, ~std::uint64_t{0});
    EXPECT_EQ(full.all().size(), 8u);
    EXPECT_GT(fullest, 4u);
}

TEST(ProximityLimit, IsTheGreatestProximityThatCouldWin) {
    RandomStream random(6);
    for (int i = 0; i < 2000; ++i) {
        const CostModel model = random_model(random);
        const int layers = between(random, 1, 9), reference = between(random, 1, 200);
        ScoredPosition best;
        best.proximity = between(random, 0, 5000);
        best.position.z = between(random, 0, 150);
        best.cost = cost_of(model, best.position.z, between(random, 1, 9), reference, best.proximity);
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
