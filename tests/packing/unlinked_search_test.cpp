#include "packing/interlocking/unlinked_search.hpp"

#include <gtest/gtest.h>

#include "disassembly/scenes.hpp"
#include "packing/best_admitted.hpp"
#include "packing/job/tray_filler.hpp"
#include "packing/mesh_parts.hpp"
#include "search/brute_force.hpp"
#include "search/plain_region.hpp"

namespace spectralpack::test {
namespace {

/// The best of the candidates from which there is a way past each object, no others being admitted.
SearchResult plain_best(const Tray& tray, Shape shape, const CostModel& model) {
    const int s = tray.detail();
    const Admits admits = shape.admits;
    shape.admits = [&](int index, const VoxelIndex& q) {
        if (admits && !admits(index, q)) return false;
        const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(index)];
        const BitGrid solid = link_sample(s == 1 ? *oriented.solid : *oriented.fine);
        for (ObjectId id = 0; id < tray.object_count(); ++id) {
            if (!tray.find(id)) continue;
            const TrayObject object = on_finest(tray.object(id));
            const FreePositions free = free_beside(*object.solid, solid);
            const VoxelIndex at = VoxelIndex{s * q.x, s * q.y, s * q.z} - object.position - free.origin;
            if (!free.free.extent().contains(at)) continue;
            if (!plain_region(free).get(at.x, at.y, at.z)) return false;
        }
        return true;
    };
    return BruteForceSearch().best_placement(tray, shape, model, {});
}

SceneLimits scenes_in(int detail) {
    SceneLimits limits;
    limits.least = {6, 6, 5};
    limits.most = {12, 9, 7};
    limits.detail = detail;
    limits.objects = 6;
    return limits;
}

TEST(UnlinkedSearch, AnswersTheBestOfWhatIsUnlinked) {
    expect_the_best_of_the_admitted<UnlinkedSearch>(scenes_in(1), 150, plain_best);
}

TEST(UnlinkedSearch, DecidesInTheVoxelsThatCollisionsAreDecidedOn) {
    expect_the_best_of_the_admitted<UnlinkedSearch>(scenes_in(3), 50, plain_best);
}

TEST(UnlinkedSearch, AnswersWithNothingThatTheShapeDoesNotAdmit) {
    const auto engine = make_cpu_search({}, Workers(2));
    UnlinkedSearch search(*engine);
    int differs = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        RandomStream random(seed);
        Scene scene = random_scene(random, scenes_in(1), 1 + 100 * seed);
        for (Shape shape : scene.shapes) {
            const CostModel model = random_model(random);
            const SearchResult any = plain_best(scene.tray, shape, model);
            shape.admits = [](int index, const VoxelIndex& q) { return (index + q.x + q.y + q.z) % 3 != 0; };
            const SearchResult answer = search.best_placement(scene.tray, shape, model, {});
            ASSERT_EQ(answer.best, plain_best(scene.tray, shape, model).best) << "seed " << seed;
            differs += answer.best != any.best;
        }
    }
    EXPECT_GT(differs, 10);
}

TEST(LinkSample, IsRowsSpreadOverTheSolidWholeForSmallOnes) {
    for (const int step : {1, 2, 4}) {
        BitGrid solid({5, 30 * step + step - 1, 3});
        solid.fill(true);
        const BitGrid sample = link_sample(solid);
        for_each_voxel(solid.extent(), [&](int x, int y, int z) {
            ASSERT_EQ(sample.get(x, y, z), (y + z) % step == 0) << step << ": " << x << " " << y << " " << z;
        });
    }
}

/// A chest whose lid has a hole, and a cube too large for that, which stands closest within.
FilledTray chest_and_cube(Links links) {
    const MeshParts parts{{merged(chest_mesh(26, 2, true), placed(frame_mesh(26, 11, 2), {0, 0, 24})), cube_mesh(14)}};
    ShapeStore shapes([&](int part, const Workers&) { return parts.shape(part); }, Workers(1));
    FillOptions setup;
    setup.tray.size = {60, 26, 26};
    setup.tray.voxel_size = 1;
    setup.container.size = {60, 26, 26};
    setup.interlock = Interlock::post;
    setup.links = links;
    setup.left = setup.to_put_back = [](int, int) {};
    const std::unique_ptr<PlacementSearch> search = make_cpu_search({}, Workers(1));
    TrayFiller filler(setup, {*search, shapes, Workers(1)}, [&](int part) { return parts.scaled(part); });
    FilledTray result;
    filler.fill(
        {0, {{0, 0}, {1, 0}}, false, 0}, [](std::size_t) {}, result);
    EXPECT_EQ(result.placed.size(), 2u);
    EXPECT_TRUE(result.plan && result.plan->complete);
    return result;
}

TEST(UnlinkedSearch, SparesTakingOutWhatWouldBeHeld) {
    EXPECT_EQ(chest_and_cube(Links::allow).report.counts.removed, 1);
    EXPECT_EQ(chest_and_cube(Links::avoid).report.counts.removed, 0);
}

}  // namespace
}  // namespace spectralpack::test
