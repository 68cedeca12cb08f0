/// What every engine must answer: the definition (brute_force.hpp) on small random scenes, and
/// answers that are known in advance.

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "engines.hpp"
#include "random_scene.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack::test {
namespace {

class EngineTest : public testing::TestWithParam<EngineFactory> {
  protected:
    std::unique_ptr<PlacementSearch> make_engine(int threads = 2) const { return GetParam().make(Workers(threads)); }
    /// The engine with the definition looking over its shoulder: throws at the first difference.
    VerifyingSearch make_verified() const { return {make_engine(), std::make_unique<BruteForceSearch>(), {}}; }
};

std::shared_ptr<const BitGrid> full_box(const Extent& extent) {
    BitGrid box(extent);
    box.fill(true);
    return std::make_shared<const BitGrid>(std::move(box));
}

Shape one_box(std::uint64_t id, const Extent& extent) { return {id, 0, {plain_shape(full_box(extent))}}; }

/// Asks for every shape of the scene, and for free positions with and without an object.
void ask_everything(VerifyingSearch& search, Scene& scene, RandomStream& random) {
    for (const Shape& shape : scene.shapes) {
        CostModel model = random_model(random);
        AllowedLayers allowed;
        if (one_in(random, 4)) {
            allowed = random_layers(shape, scene.tray.extent().z, random);
            model.allowed = &allowed;
        }
        const SearchResult result = search.best_placement(scene.tray, shape, model, {});
        EXPECT_FALSE(result.stopped);
        const int index = between(random, 0, static_cast<int>(shape.orientations.size()) - 1);
        FreeQuery query;
        query.padding = between(random, 1, 3);
        if (!scene.present.empty() && one_in(random, 2)) {
            query.without = scene.present[random.below(scene.present.size())];
        }
        search.free_positions(scene.tray, shape, index, query);
        // As a packing does, so that the tray fills up with objects that touch.
        if (result.best && one_in(random, 3)) {
            place(scene, shape, result.best->index, result.best->position);
        }
    }
}

void check_random_scenes(VerifyingSearch search, const SceneLimits& limits, std::uint64_t seeds) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, limits, 1 + 100 * seed);
        for (int step = 0; step < 5; ++step) {
            ASSERT_NO_THROW(ask_everything(search, scene, random));
            random_change(scene, random);
        }
    }
    EXPECT_GT(search.verified(), static_cast<std::int64_t>(seeds) * 10);
}

TEST_P(EngineTest, AnswersTheDefinitionInRandomScenes) { check_random_scenes(make_verified(), {}, 150); }

TEST_P(EngineTest, AnswersTheDefinitionInLongRows) {
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        check_random_scenes(make_verified(), long_scene(axis), 8);
    }
}

/// Layer after layer fills up, of which the lowest that has room wins: what an engine knows of a layer, of places that
/// were nearly as good and of how far up it has to look serves the next copy.
TEST_P(EngineTest, AnswersTheDefinitionForCopiesUnderASteepPenalty) {
    VerifyingSearch search = make_verified();
    int placed = 0;
    for (std::uint64_t seed = 32; seed < 48; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const double penalty = std::vector{1e8, 3e3, 1e4, 1e5}[seed % 4];
        Tray tray(box_tray({between(random, 20, 70), between(random, 6, 10), between(random, 16, 28)}));
        std::vector<Shape> shapes;
        for (std::uint64_t id = 0; id < 2; ++id) {
            Shape shape{2 * seed + id + 1, 0, {}};
            for (int k = 0; k < 3; ++k) {
                const Extent e = random_extent(random, {2, 2, 2}, {9, 5, 5});
                shape.orientations.push_back(plain_shape(std::make_shared<BitGrid>(random_solid(random, e))));
            }
            shapes.push_back(std::move(shape));
        }
        for (int copy = 0; copy < 60; ++copy) {
            const Shape& shape = shapes[copy % 8 == 7 ? 1 : 0];
            CostModel model;
            model.height_penalty = copy % 15 == 14 ? 4 : penalty;  // now and then more layers can win
            SearchResult result;
            ASSERT_NO_THROW(result = search.best_placement(tray, shape, model, {}));
            if (!result.best) continue;
            const auto index = static_cast<std::size_t>(result.best->index);
            tray.add({shape.orientations[index].solid.share(), result.best->position});
            ++placed;
        }
    }
    EXPECT_GT(placed, 120);
}

/// In which an engine may look at parts of words only.
TEST_P(EngineTest, AnswersTheDefinitionInGapsOfLongRows) {
    VerifyingSearch search = make_verified();
    int placed = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const Extent n{between(random, 70, 150), between(random, 3, 6), between(random, 2, 5)};
        Tray tray(box_tray(n));
        const int gap = between(random, 8, 60), from = between(random, 0, n.x - gap);
        BitGrid rest = random_bits(random, n, 60);
        for_each_voxel(n, [&](int x, int y, int z) {
            if (x < from || x >= from + gap) rest.set(x, y, z);
        });
        tray.add({std::make_shared<const BitGrid>(std::move(rest)), {}});
        for (std::uint64_t i = 0; i < 6; ++i) {
            const Extent e{between(random, gap / 3, gap), between(random, 1, n.y / 2), between(random, 1, n.z)};
            const auto solid = std::make_shared<const BitGrid>(random_bits(random, e, 3));
            if (solid->none()) continue;
            const Shape shape{1 + 10 * seed + i, 0, {plain_shape(solid)}};
            CostModel model;
            model.height_penalty = one_in(random, 2) ? 4 : 0;
            SearchResult result;
            ASSERT_NO_THROW(result = search.best_placement(tray, shape, model, {}));
            if (!result.best) continue;
            tray.add({solid, result.best->position});
            ++placed;
        }
    }
    EXPECT_GT(placed, 60);
}

TEST_P(EngineTest, AnswersTheDefinitionWithWideGaps) {
    SceneLimits limits;
    limits.most = {8, 7, 6};
    limits.reach = 9;  // beyond the grid on every side: nothing may wrap
    limits.gap_classes = 4;
    check_random_scenes(make_verified(), limits, 40);
}

TEST_P(EngineTest, AnswersTheDefinitionWithFinerCollisionVoxels) {
    SceneLimits limits;
    limits.detail = 3;
    check_random_scenes(make_verified(), limits, 100);
    limits.most = {8, 7, 6};
    limits.reach = 9;
    check_random_scenes(make_verified(), limits, 20);
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        limits = long_scene(axis);
        limits.detail = 3;
        check_random_scenes(make_verified(), limits, 4);
    }
}

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

TEST_P(EngineTest, KeepsSeveralTraysAndTheirCopiesApart) {
    VerifyingSearch search = make_verified();
    RandomStream random(7);
    std::vector<Scene> scenes;
    scenes.push_back(random_scene(random, {}, 1));
    scenes.push_back(scenes[0]);  // the same shapes in a tray that goes its own way from here
    scenes.push_back(random_scene(random, {}, 100));
    for (int step = 0; step < 30; ++step) {
        Scene& scene = scenes[random.below(scenes.size())];
        random_change(scene, random);
        ASSERT_NO_THROW(ask_everything(search, scene, random));
        if (one_in(random, 10)) scenes[1] = scenes[0];
    }
}

TEST_P(EngineTest, AnswersWithWhatIsAdmitted) {
    VerifyingSearch search = make_verified();
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, {}, 1 + 100 * seed);
        // What a shape is refused only becomes more while the tray fills up.
        std::vector<std::map<int, BitGrid>> refused(scene.shapes.size());  // by orientation
        for (int step = 0; step < 5; ++step) {
            for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
                Shape& shape = scene.shapes[i];
                const CostModel model = random_model(random);
                for (int index = 0; index < static_cast<int>(shape.orientations.size()); ++index) {
                    const Extent count =
                        scene.tray.candidates(shape.orientations[static_cast<std::size_t>(index)].reach);
                    if (count.empty() || one_in(random, 3)) continue;
                    BitGrid& of = refused[i].try_emplace(index, count).first->second;
                    for (int k = between(random, 0, static_cast<int>(count.count())); k > 0; --k) {
                        of.set(between(random, 0, count.x - 1), between(random, 0, count.y - 1),
                               between(random, 0, count.z - 1));
                    }
                }
                shape.admits = [of = &refused[i]](int index, const VoxelIndex& q) {
                    const auto found = of->find(index);
                    return found == of->end() || !found->second.get(q.x, q.y, q.z);
                };
                SearchResult result;
                ASSERT_NO_THROW(result = search.best_placement(scene.tray, shape, model, {}));
                if (result.best && one_in(random, 3)) {
                    place(scene, shape, result.best->index, result.best->position);
                }
            }
        }
    }
}

TEST_P(EngineTest, LooksOnlyNearWhatLeftAFullTray) {
    VerifyingSearch search = make_verified();
    int found = 0, none = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        SceneLimits limits;
        limits.reach = 4;
        limits.most = seed % 4 < 2 ? Extent{6, 30, 8} : Extent{6, 8, 30};
        limits.detail = 1 + static_cast<int>(seed % 2);
        Scene scene = random_scene(random, limits, 1 + 100 * seed);
        Shape& shape = scene.shapes.front();
        for (;;) {
            const SearchResult result = search.best_placement(scene.tray, shape, {}, {});
            if (!result.best) break;
            place(scene, shape, result.best->index, result.best->position);
        }
        for (int gone = between(random, 1, 3); gone > 0 && !scene.present.empty(); --gone) {
            const std::size_t k = random.below(scene.present.size());
            shape.only_near.push_back(scene.tray.object(scene.present[k]).box());
            scene.tray.remove(scene.present[k]);
            scene.present.erase(scene.present.begin() + static_cast<std::ptrdiff_t>(k));
        }
        const CostModel model = random_model(random);
        for (bool again = true; again;) {
            SearchResult result;
            ASSERT_NO_THROW(result = search.best_placement(scene.tray, shape, model, {}));
            again = result.best.has_value();
            ++(again ? found : none);
            if (again) place(scene, shape, result.best->index, result.best->position);
            if (!one_in(random, 3)) continue;
            const Shape& other = scene.shapes.back();
            ASSERT_NO_THROW(result = search.best_placement(scene.tray, other, model, {}));
            if (result.best) place(scene, other, result.best->index, result.best->position);
        }
    }
    EXPECT_GT(found, 50);
    EXPECT_GT(none, 20);
}

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

TEST_P(EngineTest, FillsATrayAndEmptiesItAgain) {
    VerifyingSearch search = make_verified();
    RandomStream random(11);
    SceneLimits limits;
    limits.objects = 0;
    limits.least = {9, 7, 5};
    Scene scene = random_scene(random, limits);
    const CostModel model{4, HeightAt::bottom};
    const auto answers = [&] {
        std::vector<SearchResult> all;
        for (const Shape& shape : scene.shapes) {
            all.push_back(search.best_placement(scene.tray, shape, model, {}));
        }
        return all;
    };
    const std::vector<SearchResult> empty = answers();
    for (const Shape& shape : scene.shapes) {
        for (;;) {
            const SearchResult result = search.best_placement(scene.tray, shape, model, {});
            if (!result.best) break;
            place(scene, shape, result.best->index, result.best->position);
        }
    }
    EXPECT_FALSE(scene.present.empty());
    for (const SearchResult& result : answers()) {
        EXPECT_FALSE(result.best);
    }
    shuffle(scene.present, random);
    for (const ObjectId id : scene.present) {
        scene.tray.remove(id);
        search.best_placement(scene.tray, scene.shapes[0], model, {});
    }
    const std::vector<SearchResult> again = answers();
    for (std::size_t i = 0; i < empty.size(); ++i) {
        EXPECT_EQ(empty[i].best, again[i].best);
    }
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

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EngineTest);
INSTANTIATE_TEST_SUITE_P(Engines, EngineTest, testing::ValuesIn(engines()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace spectralpack::test
