/// What the fast engine does for every placement and every search, piece by piece, in a tray that is half full of
/// spheres: dilated bits, phi, prefix sums, block minima; a solid's runs and depths; whole searches.

#include <benchmark/benchmark.h>

#include <memory>

#include "core/random.hpp"
#include "search/cpu/cpu_search.hpp"
#include "search/cpu/shapes/depths.hpp"
#include "search/cpu/shapes/orientation_lists.hpp"
#include "search/cpu/tables/tray_tables.hpp"

namespace {

using namespace spectralpack;

BitGrid sphere(int across) {
    BitGrid grid({across, across, across});
    const double radius = 0.5 * across;
    for (int z = 0; z < across; ++z) {
        for (int y = 0; y < across; ++y) {
            for (int x = 0; x < across; ++x) {
                const double dx = x + 0.5 - radius, dy = y + 0.5 - radius, dz = z + 0.5 - radius;
                if (dx * dx + dy * dy + dz * dz <= radius * radius) grid.set(x, y, z);
            }
        }
    }
    return grid;
}

/// A tray of 480 x 245 x 200 mm at 2 mm, its lower half full of spheres of 24 voxels in random places.
struct Scene {
    Tray tray;
    std::shared_ptr<const BitGrid> object = std::make_shared<const BitGrid>(sphere(24));

    static TraySetup setup() {
        TraySetup setup;
        setup.size = {480, 245, 200};
        return setup;
    }
    Scene() : tray(setup()) {
        RandomStream random(1);
        for (int i = 0; i < 60; ++i) {
            const VoxelIndex at{static_cast<int>(random.below(216)), static_cast<int>(random.below(98)),
                                static_cast<int>(random.below(40))};
            tray.add({object, at, 0, false});
        }
    }
};

Shape shape_of(const BitGrid& solid) {
    const Extent& e = solid.extent();
    Shape shape;
    shape.id = 1;
    const LazyGrid voxels(solid);
    shape.orientations.push_back({0, {2.0 * e.x, 2.0 * e.y, 2.0 * e.z}, {}, voxels, {{voxels, {}}}});
    return shape;
}

const VoxelIndex kPlace{100, 50, 60};
const VoxelBox kBox{kPlace, kPlace + VoxelIndex{24, 24, 24}};

void dilated_bits(benchmark::State& state) {
    Scene scene;
    BitTables tables({scene.tray.extent(), 0, 1, 1, 0});
    for (auto _ : state) {
        tables.refresh(0, {&scene.tray.occupied(0)}, kBox);
    }
}
BENCHMARK(dilated_bits)->Unit(benchmark::kMicrosecond);

void phi_and_sums(benchmark::State& state) {
    Scene scene;
    const Workers one(1);
    const Extent& n = scene.tray.extent();
    DistanceGrid before(n, Ceiling::closed);
    before.raise(n.z, one);
    before.add(scene.tray.omega_place(), {}, one);
    const Extent windows[] = {SumLayout::kVoxel, SumLayout::kVoxel, SumLayout::kQuad, SumLayout::kBlock};
    const auto which = static_cast<std::size_t>(state.range(0));  // 0: phi alone
    SumTables<std::uint16_t> sums(n, windows[which], which > 1);
    sums.follow(before, n.z, one);
    for (auto _ : state) {
        state.PauseTiming();
        DistanceGrid phi = before;
        state.ResumeTiming();
        const ChangedLayers changed = phi.add(*scene.object, kPlace, one);
        if (which == 0) continue;
        sums.note(changed);
        sums.follow(phi, n.z, one);
    }
}
BENCHMARK(phi_and_sums)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

void block_minima(benchmark::State& state) {
    Scene scene;
    const Workers one(1);
    DistanceGrid phi(scene.tray.extent(), Ceiling::closed);
    phi.raise(scene.tray.extent().z, one);
    phi.add(scene.tray.omega_place(), {}, one);
    BlockMinima minima(scene.tray.extent(), 4);
    for (auto _ : state) {
        minima.update(phi, {kPlace - VoxelIndex{20, 20, 20}, kPlace + VoxelIndex{44, 44, 40}}, one);
    }
}
BENCHMARK(block_minima)->Unit(benchmark::kMicrosecond);

void runs_and_depths(benchmark::State& state) {
    const BitGrid solid = sphere(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const Runs runs = fewest_runs(solid);
        benchmark::DoNotOptimize(Depths(solid, runs).sums(runs));
    }
}
BENCHMARK(runs_and_depths)->Arg(24)->Arg(60)->Unit(benchmark::kMicrosecond);

/// A search for a sphere of so many voxels across that nothing is remembered of.
void search(benchmark::State& state) {
    Scene scene;
    const Workers one(1);
    Shape shape = shape_of(sphere(static_cast<int>(state.range(0))));
    const auto engine = make_cpu_search({0}, one);
    for (auto _ : state) {
        ++shape.id;
        benchmark::DoNotOptimize(engine->best_placement(scene.tray, shape, {}, {}));
    }
}
BENCHMARK(search)->Arg(8)->Arg(24)->Arg(60)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
