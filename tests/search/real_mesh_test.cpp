/// Engines on shapes made of meshes, packed one after another: voxels, gaps and search together.

#include <gtest/gtest.h>

#include "brute_force.hpp"
#include "engines.hpp"
#include "search/verifying_search.hpp"
#include "spectralpack/orientations.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

class RealMeshTest : public testing::TestWithParam<EngineFactory> {};

std::vector<Mesh> meshes() {
    const Mesh frame = merged(merged(box_mesh({0, 0, 0}, {9, 2, 2}), box_mesh({0, 7, 0}, {9, 9, 2})),
                              merged(box_mesh({0, 0, 0}, {2, 9, 2}), box_mesh({7, 0, 0}, {9, 9, 2})));
    return {frame, torus_mesh(3.2, 1.1, 20, 10), sphere_mesh(2.3, 8), box_mesh({0, 0, 0}, {4, 2, 1}), cube_mesh(0.8)};
}

/// Two copies of every mesh, each where the search says; `gaps[i % gaps]` is the gap of mesh i.
std::vector<BestPlacement> pack(VerifyingSearch& search, const char* rotations, const std::vector<double>& gaps,
                                const CostModel& model, Ceiling ceiling) {
    const Workers workers(2);
    TraySetup setup;
    setup.size = {23.5, 17, 13};
    setup.voxel_size = 1;
    setup.gap_classes = gaps;
    setup.ceiling = ceiling;
    Tray tray(setup);
    std::vector<BestPlacement> placements;
    std::uint64_t id = 1;
    for (const Mesh& mesh : meshes()) {
        const Shape shape = make_shape(id, mesh, orientation_set(rotations), setup.voxel_size, 1,
                                       gaps[id % gaps.size()], gaps, workers);
        ++id;
        for (int copy = 0; copy < 2; ++copy) {
            const auto best = search.best_placement(tray, shape, model, {}).best;
            if (!best) continue;
            const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best->index)];
            const ObjectId object = tray.add({oriented.solid.share(), best->position, shape.gap_class, false});
            search.free_positions(tray, shape, best->index, {object, 1});
            placements.push_back(*best);
        }
    }
    return placements;
}

TEST_P(RealMeshTest, PacksAsTheDefinitionDoes) {
    VerifyingSearch search(GetParam().make(Workers(2)), std::make_unique<BruteForceSearch>(), {});
    const auto tight = pack(search, "90", {0}, {4, HeightAt::bottom}, Ceiling::closed);
    const auto apart = pack(search, "90", {0, 0.3, 1.5}, {1e8, HeightAt::bottom}, Ceiling::closed);
    pack(search, "180", {0.2}, {0, HeightAt::top}, Ceiling::open);
    pack(search, "none", {2.5}, {4, HeightAt::bottom}, Ceiling::open);
    EXPECT_EQ(tight.size(), 10u);
    EXPECT_GE(apart.size(), 5u);
    EXPECT_GT(search.verified(), 40);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealMeshTest);
INSTANTIATE_TEST_SUITE_P(Engines, RealMeshTest, testing::ValuesIn(engines()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace spectralpack::test
