/// What the cpu engine makes of a part: runs, covers, depths and cells.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "search/cpu/forms.hpp"
#include "search/cpu/shapes/orientation_runs.hpp"

namespace spectralpack::test {
namespace {

TEST(Runs, CoverEachVoxelOnceAndAreMaximal) {
    RandomStream random(1);
    for (int i = 0; i < 60; ++i) {
        const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {140, 6, 9}));
        const std::vector<std::int64_t> counts = count_runs(solid);
        for (int axis = 0; axis < 3; ++axis) {
            const Runs runs = runs_along(solid, axis);
            EXPECT_EQ(static_cast<std::int64_t>(runs.runs.size()), counts[static_cast<std::size_t>(axis)]);
            EXPECT_EQ(runs.voxels, solid.count());
            BitGrid drawn(solid.extent());
            for (const auto& run : runs.runs) {
                VoxelIndex v = run.start;
                for (int k = 0; k < run.length; ++k, ++v[axis]) {
                    EXPECT_FALSE(drawn.get(v.x, v.y, v.z));
                    drawn.set(v.x, v.y, v.z);
                }
                // Nothing beyond either end.
                const auto solid_at = [&](const VoxelIndex& w) {
                    return solid.extent().contains(w) && solid.get(w.x, w.y, w.z);
                };
                EXPECT_FALSE(solid_at(v));
                v = run.start;
                --v[axis];
                EXPECT_FALSE(solid_at(v));
            }
            EXPECT_EQ(drawn, solid);
        }
        EXPECT_EQ(static_cast<std::int64_t>(fewest_runs(solid).runs.size()), *std::ranges::min_element(counts));
    }
}

/// The pieces' voxels; they must lie in the grid, which lies at `offset`.
BitGrid drawn(const Pieces& pieces, const Extent& extent, const VoxelIndex& offset = {}) {
    BitGrid bits(extent);
    for (const Pieces::OfForm& of : pieces.forms) {
        for (const VoxelIndex& corner : pieces.corners_of(of)) {
            for_each_voxel_of(of.form, corner - offset, [&](const VoxelIndex& v) {
                ASSERT_TRUE(extent.contains(v));
                bits.set(v.x, v.y, v.z);
            });
        }
    }
    return bits;
}

TEST(Cover, HoldsAllThatIsWantedAndNothingBeyondTheSolid) {
    RandomStream random(13);
    int large = 0;
    for (int i = 0; i < 80; ++i) {
        const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {90, 40, 40}));
        BitGrid wanted = solid;
        if (one_in(random, 2)) {
            subtract(wanted, random_solid(random, random_extent(random, {1, 1, 1}, {60, 30, 30})), {3, 2, 1});
        }
        const Forms& forms = BitTables::forms_for(between(random, 1, 2));
        const Pieces pieces = cover(solid, wanted, forms);
        const std::vector<Form> known = in_order(forms);
        std::uint32_t end = 0;
        for (const Pieces::OfForm& of : pieces.forms) {
            const Form form{of.form.level == 0 ? 1 : of.form.axes, of.form.level};
            EXPECT_TRUE(std::ranges::find(known, form) != known.end());
            EXPECT_EQ(std::exchange(end, of.end), of.begin);
        }
        EXPECT_EQ(end, pieces.corners.size());
        const BitGrid covered = drawn(pieces, solid.extent());
        BitGrid beyond = covered;
        subtract(beyond, solid, {});
        EXPECT_TRUE(beyond.none());
        subtract(wanted, covered, {});
        EXPECT_TRUE(wanted.none());
        large += std::ranges::any_of(pieces.forms, [](const auto& of) { return of.form.voxels() > 32; });
    }
    EXPECT_GT(large, 10);
}

TEST(Cover, TakesACubeAtOnce) {
    BitGrid solid({16, 16, 16});
    solid.fill(true);
    EXPECT_EQ(cover(solid, solid, BitTables::kForms).corners.size(), 1u);
}

/// What cells say, whatever their order.
std::set<std::tuple<std::int64_t, std::uint32_t, std::uint16_t>> placed_cells(const CellList& list) {
    std::set<std::tuple<std::int64_t, std::uint32_t, std::uint16_t>> cells;
    for (const SolidCell& cell : list.cells) {
        cells.insert({cell.offset, cell.weight, cell.drop});
    }
    return cells;
}

TEST(OrientationRuns, TurnLikeTheirVoxels) {
    RandomStream random(14);
    TrayTables tables;
    TraySetup setup;
    setup.size = {100, 90, 80};
    tables.follow(Tray(setup), 3, Workers(1));
    int fine = 0;
    for (int i = 0; i < 60; ++i) {
        const Extent extent = random_extent(random, {2, 2, 2}, {70, 30, 20});
        const auto solid = std::make_shared<const BitGrid>(random_solid(random, extent));
        const AxisTurn turn = random_turn(random, i % 2 == 1);
        const auto solid_then = std::make_shared<const BitGrid>(turned(*solid, turn));
        const WidenedVoxels wide = random_widened(random, *solid, 3);
        const WidenedVoxels wide_then = turned(wide, extent, turn);
        const MadeRuns before = make_runs({0, {}, {}, solid, {wide}}, 1, tables, Workers(1));
        const OrientationRuns runs = turned(before.runs, turn, extent, 1, before.depths, tables);
        EXPECT_EQ(drawn(runs.widened.front().pieces, wide_then.voxels.extent(), wide_then.offset), *wide_then.voxels);
        const Runs expected = runs_along(*solid_then, runs.solid.axis);
        EXPECT_EQ(runs.solid.runs, expected.runs);
        EXPECT_EQ(runs.solid.voxels, expected.voxels);
        EXPECT_EQ(runs.least, Depths(*solid_then, expected.axis).sums(expected));
        const OrientationRuns made = make_runs({0, {}, {}, solid_then, {}}, 1, tables, Workers(1)).runs;
        EXPECT_FALSE(runs.cells.cells.empty());
        EXPECT_EQ(placed_cells(runs.cells), placed_cells(made.cells));
        EXPECT_EQ(placed_cells(runs.small_cells), placed_cells(made.small_cells));
        fine += !runs.small_cells.cells.empty();
    }
    EXPECT_GT(fine, 0);
}

TEST(Depths, AreTheDistanceToTheOutside) {
    RandomStream random(7);
    for (int i = 0; i < 60; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {i % 2 ? 150 : 12, i % 3 ? 9 : 140, 11});
        BitGrid solid = random_solid(random, n);
        if (i % 4 == 0) solid.fill(true);
        BitGrid outside(n);
        for_each_voxel(n, [&](int x, int y, int z) { outside.set(x, y, z, !solid.get(x, y, z)); });
        const Grid<std::int32_t> depth = manhattan_distance(outside, Ceiling::closed);
        for (int axis = 0; axis < 3; ++axis) {
            const Runs runs = runs_along(solid, axis);
            const std::vector<std::uint32_t> sums = Depths(solid, runs.axis).sums(runs);
            ASSERT_EQ(sums.size(), runs.runs.size());
            for (std::size_t k = 0; k < sums.size(); ++k) {
                std::uint32_t expected = 0;
                VoxelIndex v = runs.runs[k].start;
                for (int step = 0; step < runs.runs[k].length; ++step, ++v[axis]) {
                    expected += static_cast<std::uint32_t>(std::min(kDeepest, depth.at(v.x, v.y, v.z)));
                }
                EXPECT_EQ(sums[k], expected);
            }
        }
    }
}

TEST(Cells, NeverClaimsMoreThanTheProximityOfAFreePosition) {
    RandomStream random(8);
    constexpr int kBlock = TrayTables::kBlock;
    int telling = 0;
    for (int i = 0; i < 40; ++i) {
        const Extent n = random_extent(random, {20, 20, 20}, {70, 50, 40});
        BitGrid occupied(n);
        DistanceGrid phi(n, Ceiling::closed);
        phi.raise(n.z, Workers(1));
        BlockMinima minima(n, kBlock);
        minima.update(phi, whole(n), Workers(1));
        for (int objects = between(random, 0, 3); objects > 0; --objects) {
            const BitGrid object = random_solid(random, random_extent(random, {1, 1, 1}, {9, 7, 5}));
            const VoxelIndex at{between(random, 0, n.x), between(random, 0, n.y), between(random, 0, n.z)};
            unite(occupied, object, at);
            minima.update(phi, phi.add(object, at, Workers(1)).hull(), Workers(2));
        }
        const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {17, 15, 13}));
        const Extent& a = solid.extent();
        const Runs runs = fewest_runs(solid);
        const Depths depths(solid, runs.axis);
        const TurnedDepths as_it_is(depths, {}, a);
        for (const int edge : {kBlock, 2 * kBlock}) {
            const CellList list = list_cells(runs, a, minima, phi.most(), edge, 1000, as_it_is);
            for (int question = 0; question < 200; ++question) {
                const VoxelIndex q{between(random, 0, n.x - a.x), between(random, 0, n.y - a.y),
                                   between(random, 0, n.z - a.z)};
                if (intersects(occupied, solid, q)) continue;
                std::int64_t rho = 0;
                for_each_voxel(a, [&](int x, int y, int z) {
                    if (solid.get(x, y, z)) rho += phi.at(q.x + x, q.y + y, q.z + z);
                });
                const std::uint16_t* block = minima.at({q.x / kBlock, q.y / kBlock, q.z / kBlock});
                std::int64_t bound = list.least;
                for (const SolidCell& cell : list.cells) {
                    bound += std::int64_t{cell.weight} * std::max(0, block[cell.offset] - cell.drop);
                }
                EXPECT_LE(bound, rho);
                telling += bound > list.least;
            }
        }
    }
    EXPECT_GT(telling, 100);
}

}  // namespace
}  // namespace spectralpack::test
