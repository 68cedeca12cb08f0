/// What the cpu engine keeps while objects come and go: a tray that is emptied to an earlier state and filled up again,
/// over and over, against the definition or an engine that has seen nothing yet, and what it derives from the tray
/// against its definition voxel by voxel.

#include <gtest/gtest.h>

#include <algorithm>

#include "search/brute_force.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "search/random_scene.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack::test {
namespace {

/// Takes out the last objects, or some of them from anywhere.
void take_out(Scene& scene, RandomStream& random) {
    const auto present = static_cast<int>(scene.present.size());
    if (present == 0) return;
    const bool last = one_in(random, 2);
    for (int left = std::min(present, between(random, 1, one_in(random, 4) ? present : 4)); left > 0; --left) {
        const std::size_t k = last ? scene.present.size() - 1 : random.below(scene.present.size());
        scene.tray.remove(scene.present[k]);
        scene.present.erase(scene.present.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

/// Puts back what stood there before, at the same place: another object with the same voxels.
void put_back(Scene& scene, ObjectId id) {
    const TrayObject object = scene.tray.object(id);
    scene.present.push_back(scene.tray.add(object));
}

/// Asks about the scene's shapes while it is filled and emptied by turns.
void fill_and_empty(PlacementSearch& search, Scene& scene, RandomStream& random, int rounds) {
    const CostModel model = random_model(random);
    for (int round = 0; round < rounds; ++round) {
        for (int left = between(random, 1, 5); left > 0; --left) {
            const Shape& shape = scene.shapes[random.below(scene.shapes.size())];
            const CostModel other = one_in(random, 8) ? random_model(random) : model;
            const SearchResult result = search.best_placement(scene.tray, shape, other, {});
            if (result.best) place(scene, shape, result.best->index, result.best->position);
            if (one_in(random, 6)) add_random_object(scene, random);
        }
        if (scene.present.empty()) continue;
        const ObjectId again = scene.present[random.below(scene.present.size())];
        take_out(scene, random);
        if (one_in(random, 3)) take_out(scene, random);
        if (one_in(random, 4) && !scene.tray.find(again)) put_back(scene, again);
        if (one_in(random, 6)) {  // what comes and goes between two searches
            add_random_object(scene, random);
            scene.tray.remove(scene.present.back());
            scene.present.pop_back();
        }
    }
}

/// Asks an engine that is new each time.
class AfreshSearch final : public PlacementSearch {
  public:
    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        return make_cpu_search({}, Workers(1))->best_placement(tray, shape, model, stop);
    }
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return make_cpu_search({}, Workers(1))->free_positions(tray, shape, index, query);
    }
    const char* name() const override { return "afresh"; }
    std::int64_t memory() const override { return 0; }
};

struct RemovalCase {
    const char* name;
    SceneLimits limits;
    bool wide = false;  ///< a tray of many bricks, of which what comes and goes is a small part
    CpuOptions options = {};
    std::uint64_t seeds = 12;
};

std::ostream& operator<<(std::ostream& out, const RemovalCase& c) { return out << c.name; }

SceneLimits limits(int detail, int gap_classes) {
    SceneLimits limits;
    limits.least = {5, 4, 4};
    limits.most = {16, 12, 9};
    limits.detail = detail;
    limits.gap_classes = gap_classes;
    limits.reach = 3;
    limits.objects = 0;
    return limits;
}

/// The scene's shapes before a larger tray of the same kind.
Scene widened(const Scene& scene, RandomStream& random) {
    TraySetup setup = scene.tray.setup();
    const Extent n = random_extent(random, {130, 20, 12}, {300, 50, 30});
    for (int axis = 0; axis < 3; ++axis) {
        setup.size[axis] = n[axis] * setup.voxel_size;
    }
    setup.blocked = {};
    Scene wide{Tray(setup), scene.shapes, {}};
    setup.blocked = random_blocked(random, wide.tray.extent());
    wide.tray = Tray(setup);
    return wide;
}

class CpuSearchRemoval : public testing::TestWithParam<RemovalCase> {
  protected:
    Scene scene(RandomStream& random, std::uint64_t seed) const {
        Scene scene = random_scene(random, GetParam().limits, 1 + 100 * seed);
        return GetParam().wide ? widened(scene, random) : scene;
    }
    VerifyingSearch search() const {
        std::unique_ptr<PlacementSearch> definition = std::make_unique<BruteForceSearch>();
        if (GetParam().wide) definition = std::make_unique<AfreshSearch>();  // loops over voxels would take too long
        return {make_cpu_search(GetParam().options, Workers(2)), std::move(definition), {}};
    }
};

TEST_P(CpuSearchRemoval, AnswersAlikeWhileObjectsComeAndGo) {
    std::int64_t verified = 0;
    for (std::uint64_t seed = 0; seed < GetParam().seeds; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(1000 + seed);
        Scene tray = scene(random, seed);
        VerifyingSearch verifying = search();
        ASSERT_NO_THROW(fill_and_empty(verifying, tray, random, 14));
        verified += verifying.verified();
    }
    EXPECT_GT(verified, static_cast<std::int64_t>(GetParam().seeds) * 14);
}

/// Candidates that were turned down may be admitted once something is gone.
TEST_P(CpuSearchRemoval, AsksAgainWhetherCandidatesAreAdmitted) {
    for (std::uint64_t seed = 0; seed < GetParam().seeds; ++seed) {
        SCOPED_TRACE(seed);
        RandomStream random(2000 + seed);
        Scene tray = scene(random, seed);
        for (Shape& shape : tray.shapes) {
            shape.copies = 200;
            // The more stands in the tray, the fewer.
            shape.admits = [&tray](int index, const VoxelIndex& q) {
                const auto standing = static_cast<int>(tray.present.size());
                return (7 * q.x + 3 * q.y + 5 * q.z + index) % 11 >= std::min(9, standing);
            };
        }
        VerifyingSearch verifying = search();
        ASSERT_NO_THROW(fill_and_empty(verifying, tray, random, 14));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Trays, CpuSearchRemoval,
    testing::Values(RemovalCase{"small", {}, false, {}, 60},
                    RemovalCase{"wide_gaps", {.most = {8, 7, 6}, .gap_classes = 4, .reach = 9}, false, {}, 40},
                    RemovalCase{"bricks", limits(1, 1), true}, RemovalCase{"classes", limits(1, 4), true},
                    RemovalCase{"detail", limits(2, 3), true},
                    RemovalCase{"large", limits(1, 2), true, {.large_from = 0}},
                    RemovalCase{"large_detail", limits(2, 2), true, {.large_from = 0, .bytes = false}},
                    RemovalCase{"words", limits(1, 2), true, {.bytes = false}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(CpuSearch, AnswersTheDefinitionWhileASpeckComesAndGoes) {
    RandomStream random(3);
    Tray tray(box_tray({250, 30, 30}));
    Shape shape{1, 0, {}, 200};
    shape.orientations.push_back(plain_shape(std::make_shared<BitGrid>(random_solid(random, {9, 8, 7}))));
    VerifyingSearch search(make_cpu_search({}, Workers(2)), std::make_unique<BruteForceSearch>(), {});
    const auto speck = std::make_shared<BitGrid>(Extent{3, 3, 3});
    speck->fill(true);
    std::vector<ObjectId> stack;
    for (int step = 0; step < 40; ++step) {
        const SearchResult result = search.best_placement(tray, shape, {4, HeightAt::bottom}, {});
        ASSERT_TRUE(result.best);
        stack.push_back(tray.add({shape.orientations[0].solid.share(), result.best->position}));
        const ObjectId id = tray.add({speck, {between(random, 0, 247), 27, 27}});
        search.best_placement(tray, shape, {4, HeightAt::bottom}, {});
        tray.remove(id);
        if (step % 4 == 3) {
            tray.remove(stack.back());
            stack.pop_back();
        }
    }
}

TEST(DistanceGrid, RisesWhereObjectsGo) {
    RandomStream random(14);
    for (int i = 0; i < 40; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {70, 33, 21});
        const Ceiling ceiling = one_in(random, 2) ? Ceiling::open : Ceiling::closed;
        TraySetup setup = box_tray(n);
        setup.ceiling = ceiling;
        Tray tray(setup);
        DistanceGrid phi(n, ceiling);
        std::vector<ObjectId> standing;
        for (int step = 0; step < 12; ++step) {
            if (standing.size() > 3 && one_in(random, 2)) {
                std::vector<VoxelBox> reaches;
                for (int left = between(random, 1, 3); left > 0; --left) {
                    const std::size_t k = random.below(standing.size());
                    reaches.push_back(phi.reach_of(tray.object(standing[k]).box()));
                    tray.remove(standing[k]);
                    standing.erase(standing.begin() + static_cast<std::ptrdiff_t>(k));
                }
                const DistanceGrid before = phi;
                const ChangedLayers changed = phi.remove(reaches, {&tray.occupied(0)}, Workers(2));
                for_each_voxel(n, [&](int x, int y, int z) {
                    const VoxelIndex v{x, y, z};
                    if (z >= phi.top() || !intersection({v, v + VoxelIndex{1, 1, 1}}, changed.at(z)).empty()) return;
                    EXPECT_EQ(before.at(x, y, z), phi.at(x, y, z));
                });
            } else {
                const auto solid =
                    std::make_shared<BitGrid>(random_solid(random, random_extent(random, {1, 1, 1}, {9, 9, 9})));
                const VoxelIndex at{between(random, -9, n.x), between(random, -9, n.y), between(random, -9, n.z)};
                phi.raise(at.z + solid->extent().z + between(random, 0, 3), Workers(2));
                phi.add(*solid, at, Workers(2));
                standing.push_back(tray.add({solid, at}));
            }
            const Grid<std::int32_t> expected = manhattan_distance(tray.omega_place(), ceiling);
            for_each_voxel(n, [&](int x, int y, int z) {
                if (z < phi.top()) {
                    EXPECT_EQ(phi.at(x, y, z), expected.at(x, y, z));
                }
                EXPECT_LE(expected.at(x, y, z), phi.most());
            });
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(TrayTables, KnowWherePhiFellWhateverCameAndWent) {
    RandomStream random(15);
    for (int i = 0; i < 30; ++i) {
        Tray tray(box_tray(random_extent(random, {8, 8, 8}, {60, 30, 20})));
        const Extent n = tray.extent();
        TrayTables tables;
        std::vector<ObjectId> standing;
        struct Then {
            ObjectId objects;
            Grid<std::int32_t> phi;
        };
        std::vector<Then> earlier;
        for (int step = 0; step < 30; ++step) {
            for (int left = between(random, 1, 4); left > 0; --left) {
                if (!standing.empty() && one_in(random, 2)) {
                    const std::size_t k = one_in(random, 2) ? standing.size() - 1 : random.below(standing.size());
                    tray.remove(standing[k]);
                    standing.erase(standing.begin() + static_cast<std::ptrdiff_t>(k));
                    continue;
                }
                const auto solid =
                    std::make_shared<BitGrid>(random_solid(random, random_extent(random, {1, 1, 1}, {9, 9, 9})));
                standing.push_back(tray.add(
                    {solid,
                     {between(random, -4, n.x - 1), between(random, -4, n.y - 1), between(random, -4, n.z - 1)}}));
            }
            tables.follow(tray, 0, Workers(2));
            tables.raise(n.z, Workers(2));
            const Grid<std::int32_t> phi = manhattan_distance(tray.omega_place(), Ceiling::closed);
            if (!earlier.empty()) {
                const Then& then = earlier[random.below(earlier.size())];
                const std::vector<VoxelBox> fallen = tables.fallen_since(then.objects);
                for_each_voxel(n, [&](int x, int y, int z) {
                    if (phi.at(x, y, z) >= then.phi.at(x, y, z)) return;
                    const VoxelIndex v{x, y, z};
                    EXPECT_TRUE(std::ranges::any_of(fallen, [&](const VoxelBox& box) {
                        return !intersection(box, {v, v + VoxelIndex{1, 1, 1}}).empty();
                    }));
                });
            }
            earlier.push_back({tray.object_count(), phi});
            if (::testing::Test::HasFailure()) return;
        }
        EXPECT_EQ(tables.epoch(), 1u) << "all of it is one epoch";
    }
}

}  // namespace
}  // namespace spectralpack::test
