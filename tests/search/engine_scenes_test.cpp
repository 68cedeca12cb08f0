/// What every engine must answer on random scenes: the definition (brute_force.hpp).

#include <map>
#include <vector>

#include "engine_fixture.hpp"

namespace spectralpack::test {
namespace {

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

}  // namespace
}  // namespace spectralpack::test
