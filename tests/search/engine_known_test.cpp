/// What every engine must answer where the answer is known in advance.

#include <array>
#include <vector>

#include "engine_fixture.hpp"

namespace spectralpack::test {
namespace {

TEST_P(EngineTest, FitsPartsIntoSharedVoxels) {
    // Two boxes of one and a half voxels side by side fill a tray of three.
    TraySetup setup = box_tray({3, 2, 2});
    setup.detail = 2;
    Tray tray(setup);
    const auto fine = full_box({3, 4, 4});
    Shape shape{1, 0, {plain_shape(full_box({2, 2, 2}))}};
    shape.orientations[0].reach = {1.5, 2, 2};
    shape.orientations[0].fine = fine;
    shape.orientations[0].widened = {{fine, {}}};
    tray.add(fine_object(fine, {3, 0, 0}, 2, 0));
    const auto result = make_engine()->best_placement(tray, shape, {}, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.best->position, (VoxelIndex{0, 0, 0}));
    EXPECT_EQ(result.best->proximity, 4);  // of the voxels it shares nothing is left to go
    tray.add(fine_object(fine, {0, 0, 0}, 2, 0));
    EXPECT_EQ(tray.occupied(0).count(), 12);
    EXPECT_FALSE(make_engine()->best_placement(tray, shape, {}, {}).best);
}

TEST_P(EngineTest, PutsTheFirstBoxIntoTheCorner) {
    const Tray tray(box_tray({9, 7, 5}));
    for (const double penalty : {0.0, 4.0, 1e8}) {
        const auto result = make_engine()->best_placement(tray, one_box(1, {3, 2, 1}), {penalty, {}}, {});
        ASSERT_TRUE(result.best);
        EXPECT_EQ(result.best->position, (VoxelIndex{0, 0, 0}));
        // Layer 0: the distance to the floor is 1 throughout.
        EXPECT_EQ(result.best->proximity, 6);
        EXPECT_EQ(result.best->cost, (Cost{6, 0}));
    }
}

TEST_P(EngineTest, TellsTheCostsOfTheWinnersNeighbours) {
    // One voxel in the corner of an open tray: beside it the distance is 1 too, outside it is 0.
    TraySetup setup = box_tray({9, 7, 4});
    setup.ceiling = Ceiling::open;
    const Tray tray(setup);
    const auto result = make_engine()->best_placement(tray, one_box(1, {1, 1, 1}), {64, {}}, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.best->position, (VoxelIndex{0, 0, 0}));
    EXPECT_EQ(result.best->neighbours,
              (std::array<Cost, 6>{Cost{0, 0}, Cost{1, 0}, Cost{0, 0}, Cost{1, 0}, Cost{-1, 0}, Cost{2, 0}}));
}

TEST_P(EngineTest, FindsTheOnlyPlaceForAnObjectAsLargeAsTheTray) {
    const auto engine = make_engine();
    Tray tray(box_tray({6, 5, 4}));
    const Shape shape = one_box(1, {6, 5, 4});
    const auto result = engine->best_placement(tray, shape, {}, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.best->position, (VoxelIndex{0, 0, 0}));
    const ObjectId speck = tray.add({full_box({1, 1, 1}), {5, 4, 3}, 0, false});
    EXPECT_FALSE(engine->best_placement(tray, shape, {}, {}).best);
    tray.remove(speck);
    EXPECT_EQ(engine->best_placement(tray, shape, {}, {}).best, result.best);
    EXPECT_FALSE(engine->best_placement(tray, one_box(2, {7, 5, 4}), {}, {}).best);
}

TEST_P(EngineTest, FindsTheHoleThatFits) {
    const auto engine = make_engine();
    Tray tray(box_tray({12, 9, 7}));
    BitGrid block({12, 9, 7});
    block.fill(true);
    subtract(block, *full_box({3, 2, 2}), {7, 4, 3});
    tray.add({std::make_shared<const BitGrid>(block), {0, 0, 0}, 0, false});
    const auto fits = engine->best_placement(tray, one_box(1, {3, 2, 2}), {1e8, {}}, {});
    ASSERT_TRUE(fits.best);
    EXPECT_EQ(fits.best->position, (VoxelIndex{7, 4, 3}));
    EXPECT_FALSE(engine->best_placement(tray, one_box(2, {2, 3, 2}), {0, {}}, {}).best);
    // It is free to stand there, and cannot leave by any step.
    const auto free = engine->free_positions(tray, one_box(1, {3, 2, 2}), 0, {});
    const VoxelIndex at = VoxelIndex{7, 4, 3} - free.origin;
    EXPECT_TRUE(free.free.get(at.x, at.y, at.z));
    EXPECT_FALSE(free.free.get(at.x + 1, at.y, at.z));
    EXPECT_FALSE(free.free.get(at.x, at.y, at.z + 1));
}

TEST_P(EngineTest, FindsNothingInAFullTrayOrABlockedOne) {
    const auto engine = make_engine();
    Tray full(box_tray({5, 4, 3}));
    full.add({full_box({5, 4, 3}), {0, 0, 0}, 0, false});
    EXPECT_FALSE(engine->best_placement(full, one_box(1, {1, 1, 1}), {}, {}).best);

    TraySetup setup = box_tray({5, 4, 3});
    setup.blocked = *full_box({5, 4, 3});
    const Tray blocked(setup);
    EXPECT_FALSE(engine->best_placement(blocked, one_box(1, {1, 1, 1}), {}, {}).best);
    // A virtual container stops no motion, a physical one does.
    EXPECT_EQ(engine->free_positions(blocked, one_box(1, {1, 1, 1}), 0, {}).free.count(), 7 * 6 * 5);
    setup.blocked_is_physical = true;
    EXPECT_EQ(engine->free_positions(Tray(setup), one_box(1, {1, 1, 1}), 0, {}).free.count(), 7 * 6 * 5 - 5 * 4 * 3);
}

TEST_P(EngineTest, BreaksTiesByOrientationThenZThenYThenX) {
    // Two equal orientations: the first wins.
    const Tray tray(box_tray({7, 5, 3}));
    Shape shape = one_box(1, {7, 5, 3});
    shape.orientations.push_back(shape.orientations[0]);
    shape.orientations[1].orientation = 4;
    const auto engine = make_engine();
    const auto twin = engine->best_placement(tray, shape, {0, {}}, {});
    ASSERT_TRUE(twin.best);
    EXPECT_EQ(twin.best->index, 0);
    // The least rho is 3, anywhere along the walls: of these the one with the least z, y, x.
    const auto corner = engine->best_placement(tray, one_box(2, {1, 1, 3}), {0, {}}, {});
    ASSERT_TRUE(corner.best);
    EXPECT_EQ(corner.best->position, (VoxelIndex{0, 0, 0}));
}

TEST_P(EngineTest, MeasuresHeightAtTheTopWhereAsked) {
    // Lying (3 x 1 x 1) the box ends lower than standing (1 x 1 x 3), whatever the proximity.
    const Tray tray(box_tray({7, 5, 4}));
    Shape shape{1, 0, {plain_shape(full_box({1, 1, 3})), plain_shape(full_box({3, 1, 1}))}};
    shape.orientations[1].orientation = 1;
    const auto result = make_engine()->best_placement(tray, shape, {1e8, HeightAt::top}, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.best->index, 1);
    EXPECT_EQ(result.best->cost, (Cost{1, 3}));
}

TEST_P(EngineTest, KeepsAGapFromObjectsButNotFromWalls) {
    TraySetup setup = box_tray({12, 3, 2});
    setup.gap_classes = {0, 1};
    Tray tray(setup);
    tray.add({full_box({2, 3, 2}), {0, 0, 0}, 0, false});
    BitGrid wide({4, 3, 2});
    wide.fill(true);
    Shape shape{1, 1, {plain_shape(full_box({2, 3, 2}), 2)}};
    const WidenedVoxels widened{LazyGrid(wide), {-1, 0, 0}};
    shape.orientations[0].widened = {widened, widened};
    const auto engine = make_engine();
    const FreePositions moving = engine->free_positions(tray, shape, 0, {});
    for (const int expected : {3, 6, 9}) {
        const auto result = engine->best_placement(tray, shape, {4, {}}, {});
        ASSERT_TRUE(result.best);
        EXPECT_EQ(result.best->position, (VoxelIndex{expected, 0, 0}));
        tray.add({full_box({2, 3, 2}), result.best->position, 1, false});
    }
    EXPECT_FALSE(engine->best_placement(tray, shape, {4, {}}, {}).best);
    // Motion is free of gaps: the object may touch.
    const VoxelIndex touching = VoxelIndex{2, 0, 0} - moving.origin;
    EXPECT_TRUE(moving.free.get(touching.x, touching.y, touching.z));
}

TEST_P(EngineTest, NeverWrapsWhatOverhangs) {
    // The widened object reaches far beyond the grid at x = 0; the only object stands at the far
    // end.
    TraySetup setup = box_tray({8, 3, 2});
    setup.gap_classes = {3};
    Tray tray(setup);
    tray.add({full_box({1, 3, 2}), {7, 0, 0}, 0, false});
    BitGrid wide({9, 9, 8});
    wide.fill(true);
    Shape shape{1, 0, {plain_shape(full_box({3, 3, 2}))}};
    shape.orientations[0].widened = {{LazyGrid(wide), {-3, -3, -3}}};
    const auto result = make_engine()->best_placement(tray, shape, {}, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.best->position, (VoxelIndex{0, 0, 0}));
}

TEST_P(EngineTest, StopsWhenToldTo) {
    const Tray tray(box_tray({6, 5, 4}));
    StopSource source;
    const auto engine = make_engine();
    EXPECT_FALSE(engine->best_placement(tray, one_box(1, {2, 2, 2}), {}, source.token()).stopped);
    source.request(StopReason::cancelled);
    EXPECT_TRUE(engine->best_placement(tray, one_box(1, {2, 2, 2}), {}, source.token()).stopped);
    const auto again = engine->best_placement(tray, one_box(1, {2, 2, 2}), {}, {});
    EXPECT_FALSE(again.stopped);
    EXPECT_TRUE(again.best);
}

TEST_P(EngineTest, AnswersAlikeWithAnyNumberOfThreads) {
    std::vector<std::unique_ptr<PlacementSearch>> many;
    for (const int threads : {1, 2, 5}) {
        many.push_back(make_engine(threads));
    }
    RandomStream random(3);
    SceneLimits limits;
    limits.most = {20, 14, 11};
    limits.orientations = 9;
    for (int i = 0; i < 10; ++i) {
        Scene scene = random_scene(random, limits, 1 + 100 * static_cast<std::uint64_t>(i));
        for (const Shape& shape : scene.shapes) {
            const CostModel model = random_model(random);
            const auto expected = many[0]->best_placement(scene.tray, shape, model, {});
            const FreePositions free = many[0]->free_positions(scene.tray, shape, 0, {});
            for (const auto& engine : many) {
                EXPECT_EQ(engine->best_placement(scene.tray, shape, model, {}).best, expected.best);
                EXPECT_EQ(engine->free_positions(scene.tray, shape, 0, {}).free, free.free);
            }
        }
    }
}

TEST_P(EngineTest, HoldsMemoryOnceItHasWorked) {
    const auto engine = make_engine();
    const Tray tray(box_tray({300, 200, 100}));
    EXPECT_GE(engine->memory(), 0);
    engine->best_placement(tray, one_box(1, {3, 2, 2}), {}, {});
    EXPECT_GT(engine->memory(), 300 * 200 * 100 / 8);
}

TEST_P(EngineTest, GivesMemoryBackAndAnswersAsBefore) {
    const auto engine = make_engine();
    RandomStream random(5);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Scene scene = random_scene(random, {}, 1 + 100 * seed);
        for (const Shape& shape : scene.shapes) {
            const CostModel model = random_model(random);
            const SearchResult before = engine->best_placement(scene.tray, shape, model, {});
            const FreePositions free = engine->free_positions(scene.tray, shape, 0, {});
            const std::int64_t held = engine->memory();
            engine->forget();
            EXPECT_LE(engine->memory(), held);
            EXPECT_EQ(engine->best_placement(scene.tray, shape, model, {}).best, before.best);
            EXPECT_EQ(engine->free_positions(scene.tray, shape, 0, {}).free, free.free);
        }
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EngineTest);
INSTANTIATE_TEST_SUITE_P(Engines, EngineTest, testing::ValuesIn(engines()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace spectralpack::test
