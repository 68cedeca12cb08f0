/// The inner loops of the cpu engine on every instruction set that this machine has.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "search/cpu/shapes/orientation_lists.hpp"
#include "search/cpu/tables/kernels.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "search/random_scene.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/kernels_test.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "search/cpu/scan/scan_kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spectralpack::test {
namespace HWY_NAMESPACE {

/// All look-ups for `layers` tiles from the one at `tile` up.
void LookUp(const BitTables& bits, const LookupList& list, const std::uint64_t* tile, int layers, std::uint64_t* live) {
    using spectralpack::HWY_NAMESPACE::PruneTiles;
    const std::size_t all = list.batches.size();
    if (layers == 1) {
        PruneTiles<1>(tile, bits.next(), bits.up(), list, 0, all, live);
    } else {
        PruneTiles<BitTables::kTileLayers>(tile, bits.next(), bits.up(), list, 0, all, live);
    }
}

std::uint32_t AskCells(const std::uint16_t* minima, const CellList& list, std::uint32_t limit, std::uint32_t stop_above,
                       std::uint32_t lanes, std::uint32_t& bound) {
    return spectralpack::HWY_NAMESPACE::WithinLimit(minima, list, limit, stop_above, lanes, bound);
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack::test
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack::test {

HWY_EXPORT(LookUp);
HWY_EXPORT(AskCells);

namespace {

/// A tray with a few voxels taken and a part with many, and the look-ups for it.
struct Question {
    explicit Question(RandomStream& random) : tray(setup()) {
        tray.add({std::make_shared<const BitGrid>(random_bits(random, tray.extent(), 90)), {}});
        solid = std::make_shared<const BitGrid>(random_solid(random, random_extent(random, {20, 1, 1}, {62, 4, 3})));
        tables.follow(tray, 0, Workers(1));
        const WidenedVoxels wide{solid, {}};
        const OrientationRuns runs = make_runs({0, {}, {}, solid, {wide}}, 1, tables, Workers(1)).runs;
        list = list_lookups(runs, tables, 0).of_positions;
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
    LookupList list;
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
            (bits, question.list, bits.tile(corner.x / 64, corner.y, corner.z), layers, live.data());
            EXPECT_EQ(live, expected) << name;
        }
        use_instruction_set("");
    }
    EXPECT_GT(cleared, 1000);
    EXPECT_GT(left, 1000);
}

TEST(Kernels, CellsTellWhichBlocksAreNearAndHowFarTheyAreIfNoneIs) {
    RandomStream random(9);
    int near = 0, far = 0;
    for (int round = 0; round < 400; ++round) {
        CellList list;
        list.least = between(random, 0, 50);
        for (int i = between(random, 1, 30); i > 0; --i) {
            list.cells.push_back({{},
                                  between(random, 0, 60),
                                  static_cast<std::uint32_t>(between(random, 1, 64)),
                                  static_cast<std::uint16_t>(between(random, 0, 9))});
        }
        std::vector<std::uint16_t> minima(60 + 32 + BlockMinima::kOverrun);
        for (std::uint16_t& value : minima) {
            value = static_cast<std::uint16_t>(between(random, 0, 40));
        }
        const auto limit = static_cast<std::uint32_t>(between(random, 0, 4000));
        const auto stop_above = limit + static_cast<std::uint32_t>(between(random, 0, 1000));
        const auto lanes =
            static_cast<std::uint32_t>(random.below(3) == 0 ? 1u << random.below(32) : random.below(1u << 31));
        if (lanes == 0) continue;
        std::uint32_t expected = 0, least = ~0u;
        for (int i = 0; i < 32; ++i) {
            if ((lanes >> i & 1) == 0) continue;
            auto rho = static_cast<std::uint32_t>(list.least);
            for (const SolidCell& cell : list.cells) {
                const std::uint16_t value = minima[static_cast<std::size_t>(cell.offset + i)];
                rho += cell.weight * static_cast<std::uint32_t>(std::max(value, cell.drop) - cell.drop);
            }
            if (rho <= limit) expected |= 1u << i;
            least = std::min(least, rho);
        }
        ++(expected != 0 ? near : far);
        for (const std::string& name : instruction_sets()) {
            use_instruction_set(name);
            std::uint32_t bound = 1'000'000;
            EXPECT_EQ(HWY_DYNAMIC_DISPATCH(AskCells)(minima.data(), list, limit, stop_above, lanes, bound), expected)
                << name;
            if (expected != 0) {
                EXPECT_EQ(bound, 1'000'000u);
            } else {
                EXPECT_LE(bound, least);
                EXPECT_GT(bound, std::min(list.least > limit ? limit : stop_above, least - 1));
            }
        }
        use_instruction_set("");
    }
    EXPECT_GT(near, 50);
    EXPECT_GT(far, 50);
}

}  // namespace
}  // namespace spectralpack::test
#endif
