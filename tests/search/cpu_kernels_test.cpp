/// The inner loops of the cpu engine on every instruction set that this machine has.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "random_scene.hpp"
#include "search/cpu/kernels.hpp"
#include "search/cpu/plan.hpp"
#include "search/cpu/tray_tables.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu_kernels_test.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "search/cpu/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spectralpack::test {
namespace HWY_NAMESPACE {

/// All look-ups for `layers` tiles from the one at `tile` up.
void LookUp(const BitTables& bits, const LookupPlan& plan, const std::uint64_t* tile, int layers, std::uint64_t* live) {
    using spectralpack::HWY_NAMESPACE::BlockTiles;
    const std::size_t all = plan.batches.size();
    if (layers == 1) {
        BlockTiles<1>(tile, bits.next(), bits.up(), plan, 0, all, live);
    } else {
        BlockTiles<BitTables::kTileLayers>(tile, bits.next(), bits.up(), plan, 0, all, live);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack::test
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack::test {

HWY_EXPORT(LookUp);

namespace {

/// A tray with a few voxels taken and a part with many, and the look-ups for it.
struct Question {
    explicit Question(RandomStream& random) : tray(setup()) {
        tray.add({std::make_shared<const BitGrid>(random_bits(random, tray.extent(), 90)), {}});
        solid = std::make_shared<const BitGrid>(random_solid(random, random_extent(random, {20, 1, 1}, {62, 4, 3})));
        tables.follow(tray, 0, true, Workers(1));
        const auto wide = std::make_shared<const WidenedVoxels>(WidenedVoxels{*solid, {}});
        const OrientationRuns runs = make_runs({0, {}, {}, solid, {wide}}, 1, true, tables.frame(), Workers(1));
        plan = plan_collision(runs, tables, 0).of_positions;
    }
    static TraySetup setup() {
        TraySetup setup;
        setup.voxel_size = 1;
        setup.size = {190, 30, 20};
        return setup;
    }

    Tray tray;
    TrayTables tables;
    std::shared_ptr<const BitGrid> solid;
    LookupPlan plan;
};

TEST(Kernels, LookUpsClearWhatCollidesWhereverThatIsInItsWord) {
    RandomStream random(3);
    std::int64_t cleared = 0, left = 0;
    for (int round = 0; round < 200; ++round) {
        const Question question(random);
        const BitGrid& occupied = question.tray.occupied(0);
        const int layers = one_in(random, 3) ? BitTables::kTileLayers : 1;
        const VoxelIndex corner{64 * between(random, 0, 1), 8 * between(random, 0, 2), between(random, 0, 12)};
        // What is asked about lies anywhere in the words, from a bit to all.
        const int begin = between(random, 0, 63), end = between(random, begin, 63);
        std::vector<std::uint64_t> asked, expected;
        for (int row = 0; row < kTileRows * layers; ++row) {
            std::uint64_t bits = 0, free = 0;
            for (int x = begin; x <= end; ++x) {
                if (one_in(random, 4)) continue;
                const VoxelIndex q = corner + VoxelIndex{x, row % kTileRows, row / kTileRows};
                bits |= std::uint64_t{1} << x;
                if (!intersects(occupied, *question.solid, q)) free |= std::uint64_t{1} << x;
            }
            asked.push_back(bits);
            expected.push_back(free);
            left += std::popcount(free);
            cleared += std::popcount(bits & ~free);
        }
        const BitTables& bits = question.tables.bits();
        for (const std::string& name : instruction_sets()) {
            use_instruction_set(name);
            std::vector<std::uint64_t> live = asked;
            HWY_DYNAMIC_DISPATCH(LookUp)
            (bits, question.plan, bits.tile(corner.x / 64, corner.y, corner.z), layers, live.data());
            EXPECT_EQ(live, expected) << name;
        }
        use_instruction_set("");
    }
    EXPECT_GT(cleared, 1000);
    EXPECT_GT(left, 1000);
}

}  // namespace
}  // namespace spectralpack::test
#endif
