#include "search/verifying_search.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "brute_force.hpp"
#include "random_scene.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::test {
namespace {

/// Tells the truth but for what its lies do to it.
class Liar : public BruteForceSearch {
  public:
    std::function<void(SearchResult&)> lie = [](SearchResult&) {};
    std::function<void(FreePositions&)> lie_free = [](FreePositions&) {};

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        SearchResult result = BruteForceSearch::best_placement(tray, shape, model, stop);
        lie(result);
        return result;
    }
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        FreePositions free = BruteForceSearch::free_positions(tray, shape, index, query);
        lie_free(free);
        return free;
    }
    const char* name() const override { return "liar"; }
};

Scene small_scene() {
    TraySetup setup;
    setup.size = {6, 5, 4};
    setup.voxel_size = 1;
    BitGrid bits({2, 1, 1});
    bits.fill(true);
    const auto solid = std::make_shared<const BitGrid>(bits);
    const WidenedVoxels wide{solid, {}};
    const OrientedShape oriented{3, {2, 1, 1}, {}, solid, {wide}};
    Scene scene{Tray(setup), {Shape{42, 0, {oriented}}}, {}};
    place(scene, scene.shapes[0], 0, {0, 0, 0});
    return scene;
}

VerifyingSearch verifying(std::unique_ptr<Liar> engine, const VerifyingOptions& options = {}) {
    return {std::move(engine), std::make_unique<BruteForceSearch>(), options};
}

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const InternalError& error) {
        return error.what();
    }
    return "";
}

void expect_mentions(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
    }
}

TEST(VerifyingSearch, FindsEveryKindOfDifference) {
    const Scene scene = small_scene();
    const std::vector<std::function<void(SearchResult&)>> lies{
        [](SearchResult& r) { r.best.reset(); },
        [](SearchResult& r) { r.best->index = 1; },
        [](SearchResult& r) { r.best->position.z += 1; },
        [](SearchResult& r) { r.best->proximity += 1; },
        [](SearchResult& r) { r.best->cost.primary += 1e-9; },
        [](SearchResult& r) { r.best->cost.secondary -= 1; },
        [](SearchResult& r) { r.best->neighbours[5].primary += 1; }};
    for (std::size_t i = 0; i < lies.size(); ++i) {
        auto liar = std::make_unique<Liar>();
        liar->lie = lies[i];
        VerifyingSearch search = verifying(std::move(liar));
        const std::string message = message_of([&] { search.best_placement(scene.tray, scene.shapes[0], {}, {}); });
        expect_mentions(message, {"shape 42", "version 1", "liar", "brute force", "(2, 0, 0)"});
        EXPECT_EQ(search.verified(), 0) << i;
    }
}

TEST(VerifyingSearch, FindsDifferencesInFreePositions) {
    const Scene scene = small_scene();
    const std::vector<std::function<void(FreePositions&)>> lies{
        [](FreePositions& f) { f.free.set(2, 1, 1, !f.free.get(2, 1, 1)); }, [](FreePositions& f) { f.origin.y -= 1; },
        [](FreePositions& f) { f.free = BitGrid(); }};
    for (const auto& lie : lies) {
        auto liar = std::make_unique<Liar>();
        liar->lie_free = lie;
        VerifyingSearch search = verifying(std::move(liar));
        const std::string message = message_of([&] { search.free_positions(scene.tray, scene.shapes[0], 0, {}); });
        expect_mentions(message, {"shape 42", "orientation 3", "version 1"});
    }
}

TEST(VerifyingSearch, PassesTruthOnAndCounts) {
    const Scene scene = small_scene();
    VerifyingSearch search = verifying(std::make_unique<Liar>());
    const auto expected = BruteForceSearch().best_placement(scene.tray, scene.shapes[0], {}, {});
    EXPECT_EQ(search.best_placement(scene.tray, scene.shapes[0], {}, {}).best, expected.best);
    search.free_positions(scene.tray, scene.shapes[0], 0, {});
    EXPECT_EQ(search.verified(), 2);
    EXPECT_STREQ(search.name(), "liar");
}

TEST(VerifyingSearch, SamplesBySeedAndCallNumberAlone) {
    const Scene scene = small_scene();
    const auto verified_calls = [&](std::uint64_t seed, int free_queries_between) {
        VerifyingSearch search = verifying(std::make_unique<Liar>(), {20, 200, seed});
        std::vector<int> calls;
        for (int call = 0; call < 200; ++call) {
            const std::int64_t before = search.verified();
            search.best_placement(scene.tray, scene.shapes[0], {}, {});
            if (search.verified() > before) calls.push_back(call);
            for (int i = 0; i < free_queries_between; ++i) {
                search.free_positions(scene.tray, scene.shapes[0], 0, {});
            }
        }
        return calls;
    };
    const std::vector<int> calls = verified_calls(1, 0);
    EXPECT_EQ(calls, verified_calls(1, 2));
    EXPECT_NE(calls, verified_calls(2, 0));
    EXPECT_GT(calls.size(), 8u);  // 20 expected; 4 standard deviations are 17
    EXPECT_LT(calls.size(), 40u);
}

TEST(VerifyingSearch, ASampleOfAllIsAll) {
    const Scene scene = small_scene();
    for (const std::int64_t sample : {0, 3, 10}) {
        VerifyingSearch search = verifying(std::make_unique<Liar>(), {sample, 3, 5});
        for (int call = 0; call < 9; ++call) {
            search.best_placement(scene.tray, scene.shapes[0], {}, {});
        }
        EXPECT_EQ(search.verified(), 9);
    }
}

TEST(VerifyingSearch, DoesNotCompareStoppedAnswers) {
    const Scene scene = small_scene();
    auto liar = std::make_unique<Liar>();
    liar->lie = [](SearchResult& r) { r = {std::nullopt, true}; };
    VerifyingSearch search = verifying(std::move(liar));
    EXPECT_TRUE(search.best_placement(scene.tray, scene.shapes[0], {}, {}).stopped);
    EXPECT_EQ(search.verified(), 0);
}

}  // namespace
}  // namespace spectralpack::test
