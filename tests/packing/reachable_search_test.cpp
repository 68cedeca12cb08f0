#include "packing/interlocking/reachable_search.hpp"

#include <gtest/gtest.h>

#include "packing/best_admitted.hpp"
#include "search/brute_force.hpp"
#include "search/plain_region.hpp"

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

template <class Search>
void expect_the_best_of_the_reachable() {
    SceneLimits limits;
    limits.least = {6, 6, 5};
    limits.objects = 12;
    expect_the_best_of_the_admitted<Search>(limits, 150, plain_best);
}

TEST(ReachableSearch, AnswersTheBestOfWhatCanBeReached) { expect_the_best_of_the_reachable<ReachableSearch>(); }

/// Of these solids a sample is less than the whole.
struct FewRowsFirst : ReachableSearch {
    explicit FewRowsFirst(PlacementSearch& engine) : ReachableSearch(engine, nullptr, 2) {}
};

TEST(ReachableSearch, AnswersTheSameWithFewRowsOfTheSolidAskedFirst) {
    expect_the_best_of_the_reachable<FewRowsFirst>();
}

/// There is no room for anything that a walk comes by.
struct ForgetsAllWalks : ReachableSearch {
    explicit ForgetsAllWalks(PlacementSearch& engine) : ReachableSearch(engine, nullptr, 10, 0) {}
};

TEST(ReachableSearch, AnswersTheSameWhateverIsRemembered) { expect_the_best_of_the_reachable<ForgetsAllWalks>(); }

}  // namespace
}  // namespace spectralpack::test
