#include "packing/reachable_search.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "search/brute_force.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/plain_region.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

/// The definition: the best of the candidates that are reachable, no others being admitted.
SearchResult plain_best(const Tray& tray, Shape shape, const CostModel& model) {
    std::vector<FreePositions> reached;
    for (std::size_t i = 0; i < shape.orientations.size(); ++i) {
        const FreePositions free = BruteForceSearch().free_positions(tray, shape, static_cast<int>(i), {});
        reached.push_back({free.origin, plain_region(free)});
    }
    shape.admits = [&](int index, const VoxelIndex& q) {
        const FreePositions& of = reached[static_cast<std::size_t>(index)];
        const VoxelIndex at = q - of.origin;
        return of.free.get(at.x, at.y, at.z);
    };
    return BruteForceSearch().best_placement(tray, shape, model, {});
}

TEST(ReachableSearch, AnswersTheBestOfWhatCanBeReached) {
    const auto engine = make_cpu_search({}, Workers(2));
    ReachableSearch reachable(*engine);
    int differs = 0, answers = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        SceneLimits limits;
        limits.least = {6, 6, 5};
        limits.objects = 12;
        Scene scene = random_scene(random, limits, 1 + 100 * seed);
        for (int step = 0; step < 4; ++step) {
            for (const Shape& shape : scene.shapes) {
                const CostModel model = random_model(random);
                const SearchResult answer = reachable.best_placement(scene.tray, shape, model, {});
                ASSERT_EQ(answer.best, plain_best(scene.tray, shape, model).best);
                differs += answer.best != engine->best_placement(scene.tray, shape, model, {}).best;
                answers += answer.best.has_value();
                if (answer.best && one_in(random, 2)) place(scene, shape, answer.best->index, answer.best->position);
            }
            if (one_in(random, 2)) random_change(scene, random);
        }
    }
    EXPECT_GT(answers, 100);
    EXPECT_GT(differs, 10) << "scenes in which it matters";
}

}  // namespace
}  // namespace spectralpack::test
