/// What the cpu engine keeps of a tray, against its definition voxel by voxel.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "random_scene.hpp"
#include "search/cpu/cover.hpp"
#include "search/cpu/crowd_tables.hpp"
#include "search/cpu/depths.hpp"
#include "search/cpu/dilated_layers.hpp"
#include "search/cpu/incumbent.hpp"
#include "search/cpu/plan.hpp"
#include "search/cpu/runs.hpp"
#include "search/cpu/stretches.hpp"
#include "search/cpu/tray_tables.hpp"

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

/// One of them.
Form random_form(RandomStream& random, const Forms& forms) {
    const int axes = between(random, 1, forms.cubes ? 7 : 6);
    const bool run = axes == 1 || axes == 2 || axes == 4;
    return {axes, run ? between(random, 0, forms.run_levels) : between(random, Forms::kFirstPlate, forms.last_plate)};
}

template <class Visit>
void for_each_voxel_of(const Form& form, const VoxelIndex& corner, const Visit& visit) {
    for_each_voxel({form.size(0), form.size(1), form.size(2)}, [&](int x, int y, int z) {
        visit(corner + VoxelIndex{x, y, z});
    });
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

/// Where a piece lies in bit tables.
BitTables::Place place_of(const BitTables& bits, int layer, const Form& form, const VoxelIndex& d) {
    return bits.place(BitTables::SpotsOf(bits, layer, form)(d));
}

/// A bit of a row whose next word lies `next` words on.
bool bit_from(const std::uint64_t* word, std::ptrdiff_t next, int bit) {
    return word[bit / 64 * next] >> (bit % 64) & 1;
}

TEST(BitTables, AreDilationsByRunsPlatesAndCubes) {
    RandomStream random(2);
    for (int i = 0; i < 24; ++i) {
        const int s = between(random, 1, 3);
        const Extent n = random_extent(random, {1, 1, 1}, i % 3 == 0 ? Extent{70, 12, 90} : Extent{130, 12, 10});
        const int margin = between(random, 0, 3);
        BitGrid occupied = random_bits(random, {s * n.x, s * n.y, s * n.z}, 60);
        BitTables tables({n, margin, s, 2, 0});
        const auto refresh = [&](const VoxelBox& changed) {
            const SplitVoxels split_up = split(occupied, {}, s);
            std::vector<const BitGrid*> parts;
            for (const BitGrid& part : split_up.parts) {
                parts.push_back(&part);
            }
            tables.refresh(1, parts, changed);
        };
        refresh(whole(n));
        VoxelBox box;
        for (int a = 0; a < 3; ++a) {
            box.lo[a] = between(random, 0, n[a] - 1);
            box.hi[a] = between(random, box.lo[a] + 1, n[a]);
        }
        const VoxelIndex size = box.hi - box.lo;
        for_each_voxel({s * size.x, s * size.y, s * size.z}, [&](int x, int y, int z) {
            occupied.set(s * box.lo.x + x, s * box.lo.y + y, s * box.lo.z + z, one_in(random, 90));
        });
        refresh(box);
        for (int question = 0; question < 1000; ++question) {
            const Form form = random_form(random, BitTables::forms_for(s));
            VoxelIndex at;
            for (int a = 0; a < 3; ++a) {
                at[a] = between(random, -s * margin, s * (n[a] + margin) - 1);
            }
            bool expected = false;
            for_each_voxel_of(form, at, [&](const VoxelIndex& v) {
                expected |= occupied.extent().contains(v) && occupied.get(v.x, v.y, v.z);
            });
            const BitTables::Place place = place_of(tables, 1, form, at);
            const std::uint64_t word = tables.tile(0, 0, 0)[place.offset];
            ASSERT_EQ((word >> place.shift & 1) != 0, expected);
            ASSERT_EQ(tables.tile(0, 0, 0)[place_of(tables, 0, form, at).offset], 0u);
        }
    }
}

TEST(CrowdTables, TellWhatCollidesWhereverInABlock) {
    RandomStream random(4);
    const Workers one(1);
    constexpr int b = CrowdTables::kBlock;
    int crowded = 0, open = 0;
    for (int i = 0; i < 24; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {300, 50, 20});
        const int margin = between(random, 0, 3);
        const BitGrid occupied = random_bits(random, n, between(random, 1, 40));
        BitTables bits({n, margin, 1, 1, 0});
        bits.refresh(0, {&occupied}, whole(n));
        CrowdTables crowd(bits);
        crowd.refresh(bits, 0, whole(n), one);
        for (int question = 0; question < 1000; ++question) {
            const Form form = random_form(random, BitTables::kForms);
            if (!crowd.holds(0, form)) continue;
            // A piece at displacement d, of a block of positions that begins at 4 B.
            VoxelIndex block, d;
            for (int a = 0; a < 3; ++a) {
                block[a] = between(random, 0, (n[a] - 1) / b);
                d[a] = between(random, -margin, n[a] + margin - 1 - b * block[a]);
            }
            bool all = true, all_within_reach = true;
            for_each_voxel({2 * b - 1, 2 * b - 1, 2 * b - 1}, [&](int x, int y, int z) {
                VoxelIndex at;
                const VoxelIndex step{x, y, z};
                for (int a = 0; a < 3; ++a) {
                    at[a] = (b * block[a] + d[a] + margin) / b * b - margin + step[a];
                    if (at[a] >= n[a] + margin) return;
                }
                const BitTables::Place place = place_of(bits, 0, form, at);
                const bool meets = bits.tile(0, 0, 0)[place.offset] >> place.shift & 1;
                all_within_reach = all_within_reach && meets;
                const VoxelIndex within = at - d - VoxelIndex{b * block.x, b * block.y, b * block.z};
                if (Extent{b, b, b}.contains(within)) all = all && meets;
            });
            const BitTables::Place place = crowd.place(BitTables::SpotsOf(bits, 0, form)(d));
            const std::uint64_t* tile =
                crowd.tile(block.x / CrowdTables::kTileX, block.y / CrowdTables::kTileY, block.z);
            const std::uint64_t* word = tile + place.offset + block.y % CrowdTables::kTileY;
            const int bit = block.x % CrowdTables::kTileX + place.shift;
            const bool told = bit_from(word, crowd.next(), bit);
            ASSERT_EQ(told, all_within_reach);
            ASSERT_TRUE(all || !told);
            ++(told ? crowded : open);
        }
    }
    EXPECT_GT(crowded, 300);
    EXPECT_GT(open, 300);
}

TEST(BitTables, FollowChangesAsIfMadeAfresh) {
    RandomStream random(3);
    const Extent n{140, 17, 23};
    const Workers one(1);
    for (int s = 1; s <= 3; ++s) {
        BitGrid occupied({s * n.x, s * n.y, s * n.z});
        BitTables tables({n, 2, s, 1, 0});
        CrowdTables crowd(tables);
        for (int i = 0; i < 30; ++i) {
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {70, 9, 9}));
            const Extent& e = solid.extent();
            const VoxelIndex at{between(random, -5, s * n.x), between(random, -5, s * n.y),
                                between(random, -5, s * n.z)};
            one_in(random, 3) ? subtract(occupied, solid, at) : unite(occupied, solid, at);
            const SplitVoxels split_up = split(occupied, {}, s);
            std::vector<const BitGrid*> parts;
            for (const BitGrid& part : split_up.parts) {
                parts.push_back(&part);
            }
            VoxelBox changed;
            for (int a = 0; a < 3; ++a) {
                changed.lo[a] = floor_div(at[a], s);
                changed.hi[a] = ceil_div(at[a] + e[a], s);
            }
            tables.refresh(0, parts, changed);
            crowd.refresh(tables, 0, changed, one);
            BitTables fresh({n, 2, s, 1, 0});
            fresh.refresh(0, parts, whole(n));
            EXPECT_TRUE(fresh == tables);
            CrowdTables fresh_crowd(fresh);
            fresh_crowd.refresh(fresh, 0, whole(n), one);
            EXPECT_TRUE(fresh_crowd == crowd);
        }
    }
}

std::vector<Form> in_order(const Forms& forms) {
    std::vector<Form> all;
    forms.for_each([&](const Form& form) { all.push_back(form); });
    return all;
}

TEST(Forms, AreNumberedInTheirOrder) {
    for (const Forms& forms : {BitTables::kForms, BitTables::kFineForms}) {
        const std::vector<Form> all = in_order(forms);
        EXPECT_EQ(forms.count(), std::ssize(all));
        for (int i = 0; i < forms.count(); ++i) {
            EXPECT_EQ(forms.index(all[static_cast<std::size_t>(i)]), i);
        }
    }
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
std::set<std::tuple<std::int64_t, std::uint32_t, std::uint16_t>> placed_cells(const CellPlan& plan) {
    std::set<std::tuple<std::int64_t, std::uint32_t, std::uint16_t>> cells;
    for (const SolidCell& cell : plan.cells) {
        cells.insert({cell.offset, cell.weight, cell.drop});
    }
    return cells;
}

TEST(OrientationRuns, TurnLikeTheirVoxels) {
    RandomStream random(14);
    TrayTables tables;
    TraySetup setup;
    setup.size = {100, 90, 80};
    tables.follow(Tray(setup), 3, true, false, Workers(1));
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
        EXPECT_EQ(runs.least, Depths(*solid_then, expected).sums(expected));
        const OrientationRuns made = make_runs({0, {}, {}, solid_then, {}}, 1, tables, Workers(1)).runs;
        EXPECT_FALSE(runs.cells.cells.empty());
        EXPECT_EQ(placed_cells(runs.cells), placed_cells(made.cells));
        EXPECT_EQ(placed_cells(runs.fine_cells), placed_cells(made.fine_cells));
        fine += !runs.fine_cells.cells.empty();
    }
    EXPECT_GT(fine, 0);
}

TEST(DistanceGrid, IsTheManhattanDistanceAfterEveryAddition) {
    RandomStream random(4);
    for (int i = 0; i < 20; ++i) {
        const Extent n = random_extent(random, {1, 1, 1}, {50, 33, 21});
        const Ceiling ceiling = one_in(random, 2) ? Ceiling::open : Ceiling::closed;
        BitGrid occupied(n);
        DistanceGrid phi(n, ceiling);
        for (int step = 0; step < 8; ++step) {
            const Grid<std::int32_t> before = manhattan_distance(occupied, ceiling);
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {9, 9, 9}));
            const VoxelIndex at{between(random, -9, n.x), between(random, -9, n.y), between(random, -9, n.z)};
            if (one_in(random, 3)) {
                const int top = between(random, 0, n.z + 3);
                const int raised = std::max(phi.top(), std::min(top, n.z));
                phi.raise(top, Workers(2));
                EXPECT_EQ(phi.top(), raised);
            }
            phi.raise(at.z + solid.extent().z, Workers(2));
            unite(occupied, solid, at);
            const ChangedLayers changed = phi.add(solid, at, Workers(2));
            const Grid<std::int32_t> expected = manhattan_distance(occupied, ceiling);
            for_each_voxel(n, [&](int x, int y, int z) {
                if (z < phi.top()) {
                    EXPECT_EQ(phi.at(x, y, z), expected.at(x, y, z));
                }
                EXPECT_LE(expected.at(x, y, z), phi.most());
                const VoxelIndex v{x, y, z};
                const VoxelBox voxel{v, v + VoxelIndex{1, 1, 1}};
                if (z < phi.top() && intersection(voxel, changed.at(z)).empty()) {
                    EXPECT_EQ(before.at(x, y, z), expected.at(x, y, z));
                }
            });
            if (phi.top() == n.z) {
                EXPECT_EQ(phi.most(), *std::ranges::max_element(expected.values()));
            }
        }
    }
}

template <class T>
void expect_sums_of_every_run() {
    RandomStream random(5);
    for (int round = 0; round < 24; ++round) {
        const Extent windows[] = {SumLayout::kVoxel, SumLayout::kQuad, SumLayout::kBlock};
        const Extent& window = windows[round % 3];
        const bool apart = round % 3 > 0 && round % 2 > 0;
        const Extent n = random_extent(random, {5, 4, 3}, {70, 19, 23});
        DistanceGrid phi(n, Ceiling::closed);
        phi.raise(n.z, Workers(1));
        SumTables<T> tables(n, window, apart);
        int top = 0;
        const auto follow = [&](int threads) {
            if (between(random, 0, 2) == 0) top = std::max(top, between(random, 0, n.z));
            tables.follow(phi, between(random, 0, top), Workers(threads));  // never falls
            tables.follow(phi, top, Workers(threads));
            EXPECT_EQ(tables.top(), top);
        };
        follow(1);
        for (int step = 0; step < 5; ++step) {
            const BitGrid solid = random_solid(random, random_extent(random, {1, 1, 1}, {9, 7, 5}));
            const VoxelIndex at{between(random, 0, n.x), between(random, 0, n.y), between(random, 0, n.z)};
            const DistanceGrid before = phi;
            phi.add(solid, at, Workers(1));
            ChangedLayers changed(n.z);  // and nothing more
            for_each_voxel(n, [&](int x, int y, int z) {
                if (phi.at(x, y, z) == before.at(x, y, z)) return;
                changed.add({{x, y, z}, {x + 1, y + 1, z + 1}});
            });
            tables.note(changed);
            if (between(random, 0, 3) > 0) follow(2);
        }
        if (round % 2 == 0 || top == 0) top = n.z;
        follow(2);
        const auto pooled = [&](const VoxelIndex& v) {
            int least = apart || SumTables<T>::kBytes ? SumTables<T>::kMostPooled : phi.most();
            for_each_voxel(window, [&](int x, int y, int z) {
                const VoxelIndex w = v + VoxelIndex{x, y, z};
                if (!n.contains(w) || (apart && phi.at(w.x, w.y, w.z) == 0)) return;
                least = std::min<int>(least, phi.at(w.x, w.y, w.z));
            });
            return least;
        };
        for (int question = 0; question < 500; ++question) {
            const int axis = between(random, 0, 2);
            VoxelIndex from{between(random, 0, n.x - 1), between(random, 0, n.y - 1), between(random, 0, top - 1)};
            VoxelIndex to = from;
            to[axis] = between(random, from[axis], axis == 2 ? top : n[axis]);
            int expected = 0;
            for (VoxelIndex v = from; v[axis] < to[axis]; ++v[axis]) {
                expected += pooled(v);
            }
            const T* base = tables.base(0, 0, 0);
            EXPECT_EQ(static_cast<T>(base[tables.offset(axis, to)] - base[tables.offset(axis, from)]),
                      static_cast<T>(expected));
        }
    }
}

TEST(SumTables, GiveTheSumOfEveryRunOfPooledDistances) {
    expect_sums_of_every_run<std::uint16_t>();
    expect_sums_of_every_run<std::uint8_t>();
}

TEST(TrayTables, KeepBytesWhilePhiIsSmall) {
    TraySetup setup;
    setup.size = {60, 60, 60};
    setup.voxel_size = 1;
    Tray tray(setup);
    const auto wall = std::make_shared<BitGrid>(Extent{60, 2, 60});
    wall->fill(true);
    const auto stand = [&](int y) { return tray.add({wall, {0, y, 0}}); };
    TrayTables tables(std::numeric_limits<std::int64_t>::max()), words(0, false);
    const auto follow = [&](bool narrow, bool quads = true) {
        for (TrayTables* each : {&tables, &words}) {
            each->follow(tray, 0, Workers(2));
            if (quads && each->narrow()) each->follow_quads(Workers(2));
            EXPECT_NO_THROW(each->check(tray));
        }
        EXPECT_EQ(tables.narrow(), narrow);
        EXPECT_FALSE(words.narrow());
    };
    follow(false);
    for (TrayTables* each : {&tables, &words}) {
        EXPECT_EQ(each->top(), 0);
        each->raise(20, Workers(2));
        EXPECT_EQ(each->top(), 20);
        EXPECT_NO_THROW(each->check(tray));
    }
    const auto middle = stand(29);
    follow(true);
    tables.raise(1000, Workers(2));
    EXPECT_EQ(tables.top(), 60);
    stand(10);
    follow(true, false);
    const auto last = stand(45);
    follow(true, false);
    follow(true);
    EXPECT_LT(tables.bytes(), words.bytes());
    tray.remove(last);
    follow(true);
    const std::int64_t bytes = tables.bytes(), voxels = tray.extent().count();
    tray.remove(middle);
    follow(false);
    EXPECT_GT(tables.bytes(), bytes + 6 * voxels);  // sums of 16 bits come, those over quads go
    EXPECT_LT(tables.bytes(), bytes + 14 * voxels);
}

TEST(TrayTables, AreRightBelowATopThatRises) {
    RandomStream random(9);
    const Workers workers(2);
    for (int round = 0; round < 24; ++round) {
        TraySetup setup;
        setup.size = {1.0 * between(random, 8, 60), 1.0 * between(random, 8, 50), 1.0 * between(random, 8, 40)};
        setup.voxel_size = 1;
        setup.ceiling = one_in(random, 2) ? Ceiling::open : Ceiling::closed;
        Tray tray(setup);
        const Extent& n = tray.extent();
        TrayTables tables(one_in(random, 2) ? 0 : n.count() + 1, one_in(random, 2));
        std::vector<ObjectId> objects;
        for (int step = 0; step < 16; ++step) {
            const int what = between(random, 0, 7);
            if (what == 0 && !objects.empty()) {
                tray.remove(objects.back());
                objects.pop_back();
            } else if (what < 5) {
                const auto solid =
                    std::make_shared<BitGrid>(random_solid(random, random_extent(random, {1, 1, 1}, {8, 8, 6})));
                const Extent& e = solid->extent();
                const VoxelIndex at{between(random, 0, n.x - e.x), between(random, 0, n.y - e.y),
                                    between(random, 0, std::min(n.z - e.z, tables.top() + between(random, 0, 9)))};
                objects.push_back(tray.add({solid, at}));
            }
            if (one_in(random, 4)) continue;
            tables.follow(tray, 0, workers);
            if (what >= 5) tables.raise(tables.top() + between(random, 1, 5), workers);
            if (tables.narrow() && one_in(random, 2)) tables.follow_quads(workers);
            ASSERT_NO_THROW(tables.check(tray)) << "round " << round << ", step " << step;
        }
    }
}

TEST(CollisionPlan, SiftsTheLongerTheMoreLoadsFollowAndAlwaysLooksUpAll) {
    TraySetup setup;
    setup.size = {200, 180, 160};
    setup.detail = 2;
    Tray tray(setup);
    BitGrid ball({50, 50, 50});
    for_each_voxel(ball.extent(), [&](int x, int y, int z) {
        const auto off = [](int v) { return (2 * v - 49) * (2 * v - 49); };
        ball.set(x, y, z, off(x) + off(y) + off(z) < 50 * 50);
    });
    const auto fine = std::make_shared<const BitGrid>(ball);
    tray.add(fine_object(fine, {8, 6, 4}, 2, 0));
    TrayTables tables;
    tables.follow(tray, 0, Workers(1));
    const auto solid = std::make_shared<const BitGrid>(reached_voxels(*fine, {}, 2).voxels);
    const WidenedVoxels wide{fine, {}};
    const OrientationRuns runs = make_runs({0, {}, {}, solid, {wide}, fine}, 2, tables, Workers(2)).runs;
    const std::size_t pieces = runs.widened.front().pieces.corners.size(),
                      core = runs.widened.front().core.corners.size();
    ASSERT_GT(core, 0u);
    std::vector<std::int32_t> all;
    std::size_t sift = 0;
    for (const std::size_t loads : {std::size_t{0}, std::size_t{600}, std::size_t{1'000'000}}) {
        const CollisionPlan plan = plan_collision(runs, tables, loads);
        EXPECT_GT(plan.sift, sift);
        sift = plan.sift;
        std::vector<std::int32_t> offsets = plan.of_positions.offsets;
        EXPECT_EQ(offsets.size(), pieces + core);
        std::ranges::sort(offsets);
        if (all.empty()) all = offsets;
        EXPECT_EQ(offsets, all);
    }
}

TEST(CollisionPlan, WhatRulesOutAStackCollidesInAllOfIt) {
    RandomStream random(11);
    std::int64_t ruled_out = 0;
    for (int round = 0; round < 40; ++round) {
        TraySetup setup;
        const int s = setup.detail = 1 + round % 2;
        setup.size = {140, 36, 30};
        setup.voxel_size = 1;
        Tray tray(setup);
        BitGrid occupied({s * 140, s * 36, s * 30});
        const auto box = [&](const Extent& most) {
            BitGrid full(random_extent(random, {1, 1, 1}, most));
            full.fill(true);
            return full;
        };
        for (int i = 0; i < 12; ++i) {
            const BitGrid solid = box({40, 20, 20});
            const VoxelIndex at{between(random, 0, s * 100), between(random, 0, s * 16), between(random, 0, s * 10)};
            unite(occupied, solid, at);
            tray.add(fine_object(std::make_shared<const BitGrid>(solid), at, s, 0));
        }
        BitGrid part = box({40, 24, 24});
        unite(part, random_solid(random, part.extent()), {});
        subtract(part, random_bits(random, part.extent(), 60), {});
        const auto fine = std::make_shared<const BitGrid>(part);
        const auto solid = std::make_shared<const BitGrid>(reached_voxels(*fine, {}, s).voxels);
        const WidenedVoxels wide{fine, {}};
        TrayTables tables;
        tables.follow(tray, 0, Workers(1));
        const OrientationRuns runs =
            make_runs({0, {}, {}, solid, {wide}, s > 1 ? LazyGrid(fine) : LazyGrid()}, s, tables, Workers(2)).runs;
        const LookupPlan plan = plan_collision(runs, tables, 0).of_stacks;
        const BitTables& bits = tables.bits();
        const Extent last{140 - solid->extent().x, 36 - solid->extent().y, 30 - solid->extent().z};
        for_each_voxel({last.x + 1, last.y + 1, last.z + 1}, [&](int x, int y, int z) {
            const std::uint64_t* word = bits.tile(x / 64, y, z);
            const bool meets_any = std::ranges::any_of(plan.groups, [&](const LookupGroup& group) {
                const int bit = x % 64 + static_cast<int>(group.shift);
                return std::any_of(plan.offsets.begin() + group.begin, plan.offsets.begin() + group.end,
                                   [&](std::int32_t offset) { return bit_from(word + offset, bits.next(), bit); });
            });
            if (!meets_any) return;
            for (int i = 0; i < BitTables::kTileLayers && z + i <= last.z; ++i) {
                ++ruled_out;
                EXPECT_TRUE(intersects(occupied, *fine, {s * x, s * y, s * (z + i)}));
            }
        });
    }
    EXPECT_GT(ruled_out, 50'000);
}

TEST(Stretches, HoldEachBitOnceAndBeginWithOne) {
    RandomStream random(7);
    std::size_t fullest = 0;
    for (int i = 0; i < 500; ++i) {
        std::uint64_t rows[2] = {};
        Stretches<128> stretches;
        const int often = between(random, 1, 12);
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 64; ++x) {
                rows[y] |= static_cast<std::uint64_t>(between(random, 0, often) == 0) << x;
            }
            stretches.add(y, rows[y]);
        }
        std::uint64_t held[2] = {};
        for (const Stretch& stretch : stretches.all()) {
            EXPECT_EQ(stretch.lanes & 1, 1u);
            EXPECT_LT(stretch.lanes, 1u << kStretch);
            const std::uint64_t bits = static_cast<std::uint64_t>(stretch.lanes) << stretch.x;
            EXPECT_EQ(held[stretch.y] & bits, 0u);
            held[stretch.y] |= bits;
        }
        EXPECT_EQ(held[0], rows[0]);
        EXPECT_EQ(held[1], rows[1]);
        fullest = std::max(fullest, stretches.all().size());
    }
    Stretches<128> full;
    full.add(0, ~std::uint64_t{0});
    full.add(1, ~std::uint64_t{0});
    EXPECT_EQ(full.all().size(), 8u);
    EXPECT_GT(fullest, 4u);
}

TEST(SumPlan, SplitsWhatSixteenBitsCannotHold) {
    BitGrid solid({200, 2, 3});
    solid.fill(true);
    const OrientationRuns runs =
        make_runs({0, {}, {}, std::make_shared<const BitGrid>(solid), {}}, 1, TrayTables(), Workers(1)).runs;
    const SumLayout tables({210, 9, 8}, 1);
    for (const int range : {255, 65535}) {
        for (const int most : {1, 21, 150, 5000, 65535}) {
            if (most > range) continue;
            const SumPlan plan = plan_sum(runs, order_of_loads(runs.solid), tables, range, most);
            std::int64_t voxels = 0;
            for (const SumBatch& batch : plan.batches) {
                std::int64_t in_batch = 0, least = 0;
                for (std::int32_t i = batch.begin; i < batch.end; ++i) {
                    const SumLoad& load = plan.loads[static_cast<std::size_t>(i)];
                    const std::int64_t length = load.plus - load.minus;  // along x: elements are voxels
                    EXPECT_LE(length * most, range);
                    EXPECT_EQ(load.least > 0, length == 200) << "nothing is known of parts of a run";
                    in_batch += length;
                    least += load.least;
                }
                EXPECT_EQ(batch.least, least);
                EXPECT_LE(in_batch * most, 65535);
                voxels += in_batch;
            }
            EXPECT_EQ(voxels, solid.count());
        }
    }
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
            const std::vector<std::uint32_t> sums = Depths(solid, runs).sums(runs);
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

TEST(CellPlan, NeverClaimsMoreThanTheProximityOfAFreePosition) {
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
        const Depths depths(solid, runs);
        const TurnedDepths as_it_is(depths, {}, a);
        for (const int edge : {kBlock, 2 * kBlock}) {
            const CellPlan plan = plan_cells(runs, a, minima, phi.most(), edge, 1000, as_it_is);
            for (int question = 0; question < 200; ++question) {
                const VoxelIndex q{between(random, 0, n.x - a.x), between(random, 0, n.y - a.y),
                                   between(random, 0, n.z - a.z)};
                if (intersects(occupied, solid, q)) continue;
                std::int64_t rho = 0;
                for_each_voxel(a, [&](int x, int y, int z) {
                    if (solid.get(x, y, z)) rho += phi.at(q.x + x, q.y + y, q.z + z);
                });
                const std::uint16_t* block = minima.at({q.x / kBlock, q.y / kBlock, q.z / kBlock});
                std::int64_t bound = plan.least;
                for (const SolidCell& cell : plan.cells) {
                    bound += std::int64_t{cell.weight} * std::max(0, block[cell.offset] - cell.drop);
                }
                EXPECT_LE(bound, rho);
                telling += bound > plan.least;
            }
        }
    }
    EXPECT_GT(telling, 100);
}

TEST(ProximityLimit, IsTheGreatestProximityThatCouldWin) {
    RandomStream random(6);
    for (int i = 0; i < 2000; ++i) {
        const CostModel model = random_model(random);
        const int layers = between(random, 1, 9), reference = between(random, 1, 200);
        Placed best;
        best.proximity = between(random, 0, 5000);
        best.position.z = between(random, 0, 150);
        best.cost = cost_of(model, best.position.z, between(random, 1, 9), reference, best.proximity);
        best.index = between(random, 0, 3);
        const int index = between(random, 0, 3), z = between(random, 0, 150);
        const std::int64_t limit = proximity_limit(model, z, layers, reference, best, index);
        const auto wins = [&](std::int64_t rho) {
            const Cost cost = cost_of(model, z, layers, reference, rho);
            return cost < best.cost || (cost == best.cost && index <= best.index);
        };
        const std::int64_t above_all = 1'000'000'000'000;
        EXPECT_TRUE(limit < 0 || wins(std::min(limit, above_all)));
        EXPECT_TRUE(limit == kNoLimit || !wins(limit + 1));
    }
    EXPECT_EQ(proximity_limit({}, 3, 2, 10, std::nullopt, 0), kNoLimit);
}

TEST(DilatedLayers, TakeNoMoreMemoryThanWasPlanned) {
    for (const Extent& extent : {Extent{1, 1, 1}, Extent{64, 5, 7}, Extent{130, 9, 4}}) {
        TraySetup setup;
        setup.size = {static_cast<double>(extent.x), static_cast<double>(extent.y), static_cast<double>(extent.z)};
        setup.voxel_size = 1;
        Tray tray(setup);
        BitGrid plate({1, extent.y, extent.z});
        plate.fill(true);
        tray.add({std::make_shared<const BitGrid>(std::move(plate)), {}});
        DilatedLayers layers(tray);
        for (int z = 0; z < extent.z; ++z) {
            layers.layer(tray, z);
        }
        EXPECT_EQ(layers.bytes(), DilatedLayers::most_bytes(extent));
    }
}

}  // namespace
}  // namespace spectralpack::test
