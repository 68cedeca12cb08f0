/// What is the cpu engine's own: many copies in larger trays, memory, instruction sets. That it
/// answers the definition at all is engine_test.cpp's business.

#include <gtest/gtest.h>

#include "search/brute_force.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/cpu/tables/kernels.hpp"
#include "search/engines.hpp"
#include "search/random_scene.hpp"
#include "search/verifying_search.hpp"
#include "spectralpack/orientations.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

/// Trays of several bricks per axis, shapes from specks to a third of the tray.
SceneLimits middling_scene() {
    SceneLimits limits;
    limits.least = {65, 9, 5};
    limits.most = {90, 26, 17};
    limits.shapes = 4;
    limits.orientations = 2;
    limits.objects = 3;
    return limits;
}

/// Packs copies of every shape by turns until none fits or `most` are placed, now and then taking
/// one out, and asks with changing cost models. Returns all answers.
std::vector<SearchResult> pack_copies(PlacementSearch& search, Scene scene, RandomStream random, int most) {
    std::vector<SearchResult> answers;
    for (int i = 0; i < most; ++i) {
        const Shape& shape = scene.shapes[random.below(scene.shapes.size())];
        const CostModel model = random_model(random);
        answers.push_back(search.best_placement(scene.tray, shape, model, {}));
        if (answers.back().best) {
            place(scene, shape, answers.back().best->index, answers.back().best->position);
        }
        if (one_in(random, 15)) random_change(scene, random);
    }
    return answers;
}

TEST(CpuSearch, AnswersTheDefinitionForCopyAfterCopy) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        const Scene scene = random_scene(random, middling_scene());
        CpuOptions options;
        if (seed % 2 == 1) options.large_from = 0;
        options.bytes = seed < 2;
        VerifyingSearch search(make_cpu_search(options, Workers(2)), std::make_unique<BruteForceSearch>(), {});
        EXPECT_NO_THROW(pack_copies(search, scene, random, 25));
    }
}

/// Frames, thin and thick by turns, in trays whose middle is far from everything: what an engine knows of what is near
/// alone has to serve for places that are not.
void expect_answers_in_the_open(const CpuOptions& options) {
    std::unique_ptr<PlacementSearch> definition;
    for (const EngineFactory& engine : engines()) {
        if (engine.name == "reference") definition = engine.make(Workers(1));
    }
    if (!definition) GTEST_SKIP() << "skipped: this build has no reference engine, and loops over voxels take too long";
    VerifyingSearch search(make_cpu_search(options, Workers(2)), std::move(definition), {});
    int placed = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Tray tray(box_tray({between(random, 64, 74), between(random, 60, 66), between(random, 56, 66)}));
        const auto frame = [&](const Extent& e) {
            BitGrid solid(e);
            for_each_voxel(e, [&](int x, int y, int z) {
                const int edges = (x % (e.x - 1) == 0) + (y % (e.y - 1) == 0) + (z % (e.z - 1) == 0);
                solid.set(x, y, z, edges > 1 || one_in(random, 500));
            });
            return std::make_shared<const BitGrid>(std::move(solid));
        };
        std::vector<Shape> shapes;
        for (std::uint64_t id = 0; id < 3; ++id) {
            Shape shape{3 * seed + id + 1, 0, {}};
            const Extent least = id == 0 ? Extent{29, 29, 29} : Extent{30, 26, 22};
            const Extent most = id == 0 ? Extent{36, 36, 32} : Extent{40, 40, 28};
            for (int k = 0; k < (id == 2 ? 2 : 1); ++k) {
                shape.orientations.push_back(plain_shape(frame(random_extent(random, least, most))));
            }
            shapes.push_back(std::move(shape));
        }
        for (int step = 0; step < 24; ++step) {
            // Something small, somewhere: what lies far off comes nearer to it.
            const auto crumb =
                std::make_shared<BitGrid>(random_solid(random, random_extent(random, {1, 1, 1}, {4, 4, 4})));
            const Extent& n = tray.extent();
            const ObjectId id = tray.add(
                {crumb, {between(random, 0, n.x - 4), between(random, 0, n.y - 4), between(random, 0, n.z - 4)}});
            if (step == 15) tray.remove(id);
            Shape& shape = shapes[step % 3];
            shape.copies = one_in(random, 4) ? 1 : one_in(random, 3) ? 2 : 200;
            CostModel model;
            model.height_penalty = step < 12 ? 4 : 1e5;
            if (step > 20) model.height_at = HeightAt::top;
            SearchResult result;
            ASSERT_NO_THROW(result = search.best_placement(tray, shape, model, {}));
            if (!result.best || step % 4 != 3) continue;
            const auto index = static_cast<std::size_t>(result.best->index);
            tray.add({shape.orientations[index].solid.share(), result.best->position});
            ++placed;
        }
    }
    EXPECT_GT(placed, 10);
}

TEST(CpuSearch, AnswersTheDefinitionForCopiesInTheOpen) { expect_answers_in_the_open({}); }

TEST(CpuSearch, AnswersTheDefinitionForCopiesInTheOpenOfLargeTrays) { expect_answers_in_the_open({.large_from = 0}); }

TEST(CpuSearch, AnswersAlikeWhateverItMayRemember) {
    RandomStream random(10);
    SceneLimits limits = middling_scene();
    limits.shapes = 6;
    for (int i = 0; i < 3; ++i) {
        const Scene scene = random_scene(random, limits);
        std::vector<std::vector<SearchResult>> all;
        for (const std::int64_t memory : {std::int64_t{0}, std::int64_t{20'000}, std::int64_t{1} << 28}) {
            const auto search = make_cpu_search({memory}, Workers(2));
            all.push_back(pack_copies(*search, scene, random, 60));
        }
        for (std::size_t k = 0; k < all[0].size(); ++k) {
            EXPECT_EQ(all[0][k].best, all[1][k].best);
            EXPECT_EQ(all[0][k].best, all[2][k].best);
        }
    }
}

TEST(CpuSearch, RemembersWithinItsMemory) {
    RandomStream random(11);
    SceneLimits limits = middling_scene();
    limits.shapes = 8;
    const Scene scene = random_scene(random, limits);
    const auto none = make_cpu_search({0}, Workers(1));
    const auto some = make_cpu_search({40'000}, Workers(1));
    const auto all = make_cpu_search({}, Workers(1));
    for (PlacementSearch* search : {none.get(), some.get(), all.get()}) {
        pack_copies(*search, scene, random, 30);
        for (const Shape& shape : scene.shapes) {
            search->best_placement(scene.tray, shape, {}, {});
        }
    }
    EXPECT_LE(some->memory(), all->memory());
    // One shape's states are always held while it is searched for.
    EXPECT_LT(none->memory(), all->memory());
}

TEST(CpuSearch, KeepsLessOfWhatIsAskedAboutOnce) {
    RandomStream random(13);
    SceneLimits limits = middling_scene();
    limits.objects = 0;  // so that something is left to remember
    const Scene scene = random_scene(random, limits);
    const auto memory_for = [&](bool once) {
        Shape shape = scene.shapes.front();
        shape.copies = once ? 1 : 2;
        const auto search = make_cpu_search({}, Workers(1));
        search->best_placement(scene.tray, shape, {}, {});
        return search->memory();
    };
    EXPECT_LT(memory_for(true), memory_for(false));
}

TEST(CpuSearch, NeedsNoVoxelsOfTurnedOrientations) {
    const auto search = make_cpu_search({}, Workers(2));
    for (const int detail : {1, 2}) {
        TraySetup setup;
        setup.size = {20, 20, 20};
        setup.voxel_size = 1;
        setup.detail = detail;
        setup.gap_classes = {0.5};
        const Shape shape = make_shape(1, bracket(), orientation_set("90"), 1, detail, 0.5, {0.5}, Workers(2));
        ASSERT_TRUE(search->best_placement(Tray(setup), shape, {}, {}).best);
        for (const OrientedShape& oriented : shape.orientations) {
            if (!oriented.is_turned()) continue;
            EXPECT_EQ(oriented.solid.bytes() + oriented.fine.bytes() + oriented.widened.front().voxels.bytes(), 0);
        }
    }
}

TEST(CpuSearch, KeepsNothingOfATrayThatIsGone) {
    RandomStream random(12);
    const Scene scene = random_scene(random, middling_scene());
    const Shape& shape = scene.shapes.front();
    const auto search = make_cpu_search({}, Workers(1));
    search->best_placement(scene.tray, shape, {}, {});
    search->best_placement(scene.tray, shape, {}, {});
    const std::int64_t before = search->memory();
    {
        const Tray tray = scene.tray;
        search->free_positions(tray, shape, 0, {});
        EXPECT_GT(search->memory(), before);
        search->best_placement(scene.tray, shape, {}, {});
        EXPECT_GT(search->memory(), before) << "it may be asked about again";
    }
    search->best_placement(scene.tray, shape, {}, {});
    EXPECT_EQ(search->memory(), before);
}

TEST(CpuSearch, AnswersAlikeOnEveryInstructionSet) {
    EXPECT_FALSE(instruction_sets().empty());
    RandomStream random(12);
    const Scene scene = random_scene(random, middling_scene());
    std::vector<std::vector<SearchResult>> all;
    for (const std::string& name : instruction_sets()) {
        SCOPED_TRACE(name);
        use_instruction_set(name);
        for (const bool bytes : {true, false}) {
            CpuOptions options;
            options.large_from = 0;
            options.bytes = bytes;
            VerifyingSearch search(make_cpu_search(options, Workers(2)), std::make_unique<BruteForceSearch>(), {});
            EXPECT_NO_THROW(all.push_back(pack_copies(search, scene, random, 20)));
        }
    }
    use_instruction_set("");
    for (const auto& answers : all) {
        for (std::size_t k = 0; k < all[0].size(); ++k) {
            EXPECT_EQ(answers[k].best, all[0][k].best);
        }
    }
}

}  // namespace
}  // namespace spectralpack::test
