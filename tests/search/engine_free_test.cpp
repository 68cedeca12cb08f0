/// What every engine must tell of free positions.

#include <bit>

#include "engine_fixture.hpp"

namespace spectralpack::test {
namespace {

TEST_P(EngineTest, TellsFreePositionsInTilesOfAnyVoxels) {
    const auto engine = make_engine();
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        RandomStream random(seed);
        Scene scene = random_scene(random, {}, 1);
        for (const Shape& shape : scene.shapes) {
            FreeQuery query;
            query.padding = between(random, 1, 3);
            if (!scene.present.empty()) query.without = scene.present[random.below(scene.present.size())];
            query.for_readers = one_in(random, 2);
            const auto tiles = engine->free_tiles(scene.tray, shape.orientations.front().solid.share(), query);
            const FreePositions all = engine->free_positions(scene.tray, shape, 0, query);
            ASSERT_EQ(tiles->origin(), all.origin);
            ASSERT_EQ(tiles->extent(), all.free.extent());
            const Extent& e = all.free.extent();
            const bool each = random.below(2) == 0;  // asked for by itself
            for (int z = 0; z < e.z; ++z) {
                for (int y = 0; y < e.y; ++y) {
                    for (int i = 0; i < all.free.words_per_row(); ++i) {
                        constexpr int kRows = FreeTileReader::kRows;
                        const auto row = static_cast<std::size_t>(y % kRows);
                        FreeTileReader::Rows wanted{};
                        wanted[row] = each ? std::uint64_t{1} << random.below(64) : ~std::uint64_t{0};
                        const FreeTileReader::Told told = tiles->tell(i, y / kRows, z, wanted);
                        EXPECT_EQ(told.known[row] & wanted[row], wanted[row]);
                        for (std::size_t k = 0; k < kRows; ++k) {
                            const int at = kRows * (y / kRows) + static_cast<int>(k);
                            const std::uint64_t truth = at < e.y ? all.free.row(at, z)[i] : 0;
                            ASSERT_EQ(told.free[k] & told.known[k], truth & told.known[k]);
                            ASSERT_EQ(told.free[k] & ~told.known[k], 0u);
                        }
                    }
                }
            }
        }
    }
}

TEST_P(EngineTest, PadsFreePositionsSoThatTheOutermostAreOutside) {
    Tray tray(box_tray({6, 5, 4}));
    tray.add({full_box({6, 5, 4}), {0, 0, 0}, 0, false});
    for (const int padding : {1, 2, 5}) {
        const FreePositions free =
            make_engine()->free_positions(tray, one_box(1, {3, 1, 2}), 0, {std::nullopt, padding});
        EXPECT_EQ(free.origin, (VoxelIndex{-2 - padding, -padding, -1 - padding}));
        const Extent e{8 + 2 * padding, 5 + 2 * padding, 5 + 2 * padding};
        EXPECT_EQ(free.free.extent(), e);
        EXPECT_EQ(free.free.count(), e.count() - 8 * 5 * 5);
        EXPECT_TRUE(free.free.get(padding - 1, padding, padding));
        EXPECT_FALSE(free.free.get(padding, padding, padding));
    }
}

TEST_P(EngineTest, TakesAnObjectOutButNotWhatItShares) {
    Tray tray(box_tray({6, 5, 4}));
    const ObjectId first = tray.add({full_box({2, 5, 4}), {0, 0, 0}, 0, false});
    tray.add({full_box({2, 5, 4}), {1, 0, 0}, 0, false});
    const Shape voxel = one_box(1, {1, 1, 1});
    const FreePositions free = make_engine()->free_positions(tray, voxel, 0, {first, 1});
    EXPECT_TRUE(free.free.get(1, 1, 1));   // position (0, 0, 0) was the first's alone
    EXPECT_FALSE(free.free.get(2, 1, 1));  // (1, 0, 0) was shared
    EXPECT_FALSE(free.free.get(3, 1, 1));
    EXPECT_TRUE(free.free.get(4, 1, 1));
}

TEST_P(EngineTest, ReadersThatShareATrayReadItAsItIs) {
    Tray tray(box_tray({8, 4, 4}));
    const auto engine = make_engine();
    const auto voxel = full_box({1, 1, 1});
    const auto free_in_tray = [&](FreeTileReader& reader) {
        FreeTileReader::Rows all;
        all.fill(~std::uint64_t{0});
        int count = 0;
        for (int z = 1; z <= 4; ++z) {
            const FreeTileReader::Told told = reader.tell(0, 0, z, all);
            for (int y = 1; y <= 4; ++y) {
                count += std::popcount(told.free[static_cast<std::size_t>(y)] & std::uint64_t{0x1FE});
            }
        }
        return count;
    };
    const auto first = engine->free_tiles(tray, voxel, {.for_readers = true});
    const auto second = engine->free_tiles(tray, voxel, {.for_readers = true});
    EXPECT_EQ(free_in_tray(*first), 8 * 4 * 4);
    EXPECT_EQ(free_in_tray(*second), 8 * 4 * 4);
    tray.add({full_box({2, 1, 1}), {3, 2, 1}, 0, false});
    const auto third =
        engine->free_tiles(tray, voxel, {.for_readers = true});  // the others live, and are not to be asked
    EXPECT_EQ(free_in_tray(*third), 8 * 4 * 4 - 2);
}

}  // namespace
}  // namespace spectralpack::test
