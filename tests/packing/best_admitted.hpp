#pragma once
/// Engines that answer with the best of some candidates only, against the definition on random scenes.

#include <gtest/gtest.h>

#include "search/cpu/cpu_search.hpp"
#include "search/random_scene.hpp"
#include "support/sanitized.hpp"

namespace spectralpack::test {

/// `plain_best(tray, shape, model)`: the definition. `Search` is made from an engine.
template <class Search, class PlainBest>
void expect_the_best_of_the_admitted(const SceneLimits& limits, std::uint64_t scenes, const PlainBest& plain_best) {
    const auto engine = make_cpu_search({}, Workers(2));
    Search search(*engine);
    int differs = 0, answers = 0;
    for (std::uint64_t seed = 0; seed < trials(scenes); ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(seed);
        Scene scene = random_scene(random, limits, 1 + 100 * seed);
        for (int step = 0; step < 4; ++step) {
            for (std::size_t i = 0; i < scene.shapes.size(); i += one_in(random, 2)) {  // some copies of each
                const Shape& shape = scene.shapes[i];
                const CostModel model = random_model(random);
                const SearchResult answer = search.best_placement(scene.tray, shape, model, {});
                ASSERT_EQ(answer.best, plain_best(scene.tray, shape, model).best);
                differs += answer.best != engine->best_placement(scene.tray, shape, model, {}).best;
                answers += answer.best.has_value();
                if (answer.best && one_in(random, 2)) place(scene, shape, answer.best->index, answer.best->position);
            }
            if (one_in(random, 2)) random_change(scene, random);
            if (one_in(random, 6)) search.forget();
        }
    }
    EXPECT_GT(answers, trials(100));
    if (!kSanitized) {  // of the first scenes it may matter in none
        EXPECT_GT(differs, 10) << "scenes in which it matters";
    }
}

}  // namespace spectralpack::test
