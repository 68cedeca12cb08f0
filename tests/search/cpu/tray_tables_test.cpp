/// What the cpu engine keeps of distances in a tray, against its definition voxel by voxel.

#include <gtest/gtest.h>

#include <algorithm>

#include "search/cpu/free/dilated_layers.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {
namespace {

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
        const bool disjoint = round % 3 > 0 && round % 2 > 0;
        const Extent n = random_extent(random, {5, 4, 3}, {70, 19, 23});
        DistanceGrid phi(n, Ceiling::closed);
        phi.raise(n.z, Workers(1));
        SumTables<T> tables(n, window, disjoint);
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
            int least = disjoint || SumTables<T>::kBytes ? SumTables<T>::kMostPooled : phi.most();
            for_each_voxel(window, [&](int x, int y, int z) {
                const VoxelIndex w = v + VoxelIndex{x, y, z};
                if (!n.contains(w) || (disjoint && phi.at(w.x, w.y, w.z) == 0)) return;
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

/// For sanitizers: rows that are whole vectors long, and a change at the end of the last one.
TEST(SumTables, ReadNothingBeyondTheLastDistance) {
    const Extent n{64, 3, 3};
    DistanceGrid phi(n, Ceiling::open);
    phi.raise(n.z, Workers(1));
    SumTables<std::uint16_t> tables(n, SumLayout::kVoxel, false);
    tables.follow(phi, n.z, Workers(1));
    BitGrid voxel({1, 1, 1});
    voxel.fill(true);
    tables.note(phi.add(voxel, {63, 2, 2}, Workers(1)));
    tables.follow(phi, n.z, Workers(1));
    const VoxelIndex from{63, 2, 0}, to{63, 2, 3};
    const std::uint16_t* base = tables.base(0, 0, 0);
    EXPECT_EQ(base[tables.offset(2, to)] - base[tables.offset(2, from)], 1 + 1 + 0);
}

/// Every run's sum below layer `top`.
template <class T>
void expect_same_sums(const SumTables<T>& tables, const DistanceGrid& phi, int top, const Extent& window,
                      bool disjoint) {
    const Extent& n = phi.extent();
    SumTables<T> afresh(n, window, disjoint);
    afresh.follow(phi, top, Workers(1));
    const T *base = tables.base(0, 0, 0), *expected = afresh.base(0, 0, 0);
    bool same = true;
    for (int axis = 0; axis < 3; ++axis) {
        const Extent beyond{n.x + (axis == 0), n.y + (axis == 1), top + (axis == 2)};
        for_each_voxel(beyond, [&](int x, int y, int z) {
            const VoxelIndex here{x, y, z};
            VoxelIndex first = here;
            first[axis] = 0;
            const auto a = tables.offset(axis, here), b = tables.offset(axis, first);
            same = same && static_cast<T>(base[a] - base[b]) == static_cast<T>(expected[a] - expected[b]);
        });
    }
    EXPECT_TRUE(same) << "sums over windows of " << window.x << " x " << window.y << " x " << window.z;
}

/// Tables that followed a tray's changes one by one against the tray's distances and tables made afresh. `quads`: they
/// followed as well.
void expect_right(const TrayTables& tables, const Tray& tray, bool quads) {
    const Extent& n = tray.extent();
    const DistanceGrid& phi = tables.phi();
    const Grid<std::int32_t> expected = manhattan_distance(tray.omega_place(), tray.setup().ceiling);
    bool same = true;
    for_each_voxel(
        n, [&](int x, int y, int z) { same = same && (z >= phi.top() || phi.at(x, y, z) == expected.at(x, y, z)); });
    EXPECT_TRUE(same) << "distances";
    const int most = *std::ranges::max_element(expected.values());
    EXPECT_TRUE(phi.top() < n.z ? most <= phi.most() : most == phi.most()) << most << ' ' << phi.most();
    tables.visit_sums([&]<class T>(const Sums<T>& sums) {
        expect_same_sums(sums.exact, phi, tables.top(), SumLayout::kVoxel, false);
        expect_same_sums(sums.coarse, phi, tables.top(), SumLayout::kBlock, tables.disjoint());
    });
    if (quads) expect_same_sums(tables.quads(), phi, tables.top(), SumLayout::kQuad, tables.disjoint());
    BlockMinima minima(n, TrayTables::kBlock);
    minima.update(phi, {{0, 0, 0}, {n.x, n.y, phi.top()}}, Workers(1));
    EXPECT_TRUE(minima == tables.minima());
    TrayTables afresh(tables.large() ? 0 : std::numeric_limits<std::int64_t>::max());
    afresh.follow(tray, tables.bits().margin(), Workers(1));
    EXPECT_TRUE(afresh.bits() == tables.bits());
    EXPECT_TRUE(afresh.crowd() == tables.crowd());
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
            if (quads && each->in_bytes()) each->follow_quads(Workers(2));
            expect_right(*each, tray, quads && each->in_bytes());
        }
        EXPECT_EQ(tables.in_bytes(), narrow);
        EXPECT_FALSE(words.in_bytes());
    };
    follow(false);
    for (TrayTables* each : {&tables, &words}) {
        EXPECT_EQ(each->top(), 0);
        each->raise(20, Workers(2));
        EXPECT_EQ(each->top(), 20);
        expect_right(*each, tray, false);
    }
    const auto middle = stand(29);
    follow(true);
    tables.raise(1000, Workers(2));
    EXPECT_EQ(tables.top(), 60);
    expect_right(tables, tray, true);  // quads that followed are raised with the rest
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
    EXPECT_GT(tables.bytes(), bytes);  // sums of 16 bits come, bytes and quads go
    EXPECT_LT(tables.bytes(), bytes + 6 * voxels);
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
            const bool quads = tables.in_bytes() && one_in(random, 2);
            if (quads) tables.follow_quads(workers);
            SCOPED_TRACE("round " + std::to_string(round) + ", step " + std::to_string(step));
            expect_right(tables, tray, quads);
            if (::testing::Test::HasFailure()) return;
        }
    }
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
