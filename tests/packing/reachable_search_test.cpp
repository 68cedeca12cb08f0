#include "packing/reachable_search.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "core/random.hpp"
#include "search/brute_force.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

/// Positions reachable from outside, by plain breadth-first search over the definition's free positions.
FreePositions plain_reachable(const Tray& tray, const Shape& shape, int index) {
    FreePositions free = BruteForceSearch().free_positions(tray, shape, index, {});
    const Extent& e = free.free.extent();
    BitGrid reached(e);
    std::deque<VoxelIndex> open;
    const auto reach = [&](const VoxelIndex& q) {
        if (!e.contains(q) || !free.free.get(q.x, q.y, q.z) || reached.get(q.x, q.y, q.z)) return;
        reached.set(q.x, q.y, q.z);
        open.push_back(q);
    };
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; ++y) {
            for (int x = 0; x < e.x; ++x) {
                const bool rim = x == 0 || y == 0 || z == 0 || x == e.x - 1 || y == e.y - 1 || z == e.z - 1;
                if (rim) reach({x, y, z});
            }
        }
    }
    while (!open.empty()) {
        const VoxelIndex at = open.front();
        open.pop_front();
        for (int move = 0; move < 6; ++move) {
            VoxelIndex next = at;
            next[move / 2] += move % 2 == 0 ? 1 : -1;
            reach(next);
        }
    }
    return {free.origin, std::move(reached)};
}

/// The definition: the best of the candidates that are reachable, no others being admitted.
SearchResult plain_best(const Tray& tray, Shape shape, const CostModel& model) {
    std::vector<FreePositions> reached;
    for (std::size_t i = 0; i < shape.orientations.size(); ++i) {
        reached.push_back(plain_reachable(tray, shape, static_cast<int>(i)));
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
