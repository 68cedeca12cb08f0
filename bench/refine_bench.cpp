/// Continuous refinement of one copy in a realistic neighbourhood: a set of the benchmark data is
/// settled into its tray by slides alone (each copy falls from above, then slides to -x, -y and
/// down again), which leaves every copy in contact with others on three sides. Each is then backed
/// away by up to two voxels where that is free, as a placement on the grid would stand, and refined
/// towards where it came from.

#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "core/random.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/set_file.hpp"
#include "geometry/mesh_distance.hpp"
#include "geometry/slide.hpp"
#include "refine/refiner.hpp"

namespace {

using namespace spectralpack;

constexpr double kVoxel = 2, kGap = 0.2;
const Vec3 kTray{480, 245, 200};

std::filesystem::path data() {
    const char* named = std::getenv("SPECTRALPACK_DATA");
    return named ? named : std::filesystem::path(SPECTRALPACK_SOURCE_DIR) / ".." / "shared" / "data";
}

/// Of this thread, so that a busy machine does not count.
double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Scene {
    std::vector<PlacedSurface> settled;
    std::vector<Vec3> backed;  ///< where each is refined from
};

Mat3 any_rotation(RandomStream& random) {
    Mat3 turn;
    for (std::uint64_t i = random.below(6); i > 0; --i) {
        turn = Mat3{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}} * turn;
        if (i % 2) turn = Mat3{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}} * turn;
    }
    return turn;
}

Scene settle(const std::string& set) {
    RandomStream random(7);
    std::vector<std::shared_ptr<const Bvh>> surfaces;
    for (const SetRow& row : read_set(data() / "sets" / (set + ".csv"))) {
        Mesh mesh = read_meshes(data() / "meshes" / row.mesh).front().mesh;
        const Bvh upright(transformed(mesh, {row.scale * Mat3{}, {}}));
        for (int i = 0; i < row.count; ++i) {
            surfaces.push_back(std::make_shared<const Bvh>(upright.turned(any_rotation(random))));
        }
    }
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [](const auto& a, const auto& b) { return a->box().volume() > b->box().volume(); });
    Scene scene;
    const Vec3 tall{kTray.x, kTray.y, 2000};
    Refiner fall({tall, 0, 2000, 2}), step({tall, 0, 0.7 * kVoxel, 1});
    for (const auto& surface : surfaces) {
        PlacedSurface copy{surface, {}, kGap};
        const Vec3 size = surface->box().size();
        if (size.x > kTray.x || size.y > kTray.y) continue;
        const Vec3 at{random.unit() * (kTray.x - size.x), random.unit() * (kTray.y - size.y), tall.z - size.z};
        copy.offset = at - surface->box().min;
        copy.offset = fall.refine(copy, {0, 0, -1}).offset;
        copy.offset = fall.refine(copy, {-1, -1, -1}).offset;
        if (copy.box().max.z > kTray.z) continue;
        scene.backed.push_back(step.refine(copy, {1, 1, 1}).offset);
        scene.settled.push_back(copy);
        fall.add(copy);
        step.add(copy);
    }
    return scene;
}

const Scene& scene_of(const std::string& set) {
    static std::map<std::string, Scene> scenes;
    const auto [at, fresh] = scenes.try_emplace(set);
    if (fresh) at->second = settle(set);
    return at->second;
}

/// One iteration refines every copy of the set among all the others; ms_median and ms_99 are per
/// copy.
void refine_set(benchmark::State& state, const std::string& set) {
    const Scene& scene = scene_of(set);
    Refiner refiner({kTray, 0, 2 * kVoxel, 3});
    for (const PlacedSurface& copy : scene.settled) {
        refiner.add(copy);
    }
    std::vector<double> ms;
    double way = 0;
    for (auto _ : state) {
        ms.clear();
        way = 0;
        for (std::size_t i = 0; i < scene.settled.size(); ++i) {
            PlacedSurface copy = scene.settled[i];
            const auto id = static_cast<Refiner::CopyId>(i);
            Refiner others = refiner;
            others.remove(id);
            copy.offset = scene.backed[i];
            const double begin = processor_ms();
            const Refined refined = others.refine(copy, {-1, -1, -1});
            ms.push_back(processor_ms() - begin);
            way += refined.way;
        }
    }
    std::sort(ms.begin(), ms.end());
    state.counters["copies"] = static_cast<double>(ms.size());
    state.counters["ms_median"] = ms[ms.size() / 2];
    state.counters["ms_90"] = ms[ms.size() * 9 / 10];
    state.counters["ms_99"] = ms[ms.size() * 99 / 100];
    state.counters["ms_max"] = ms.back();
    state.counters["mm_moved"] = way / static_cast<double>(ms.size());
}

void build_tree(benchmark::State& state, const std::string& file) {
    const Mesh mesh = read_meshes(data() / "meshes" / file).front().mesh;
    for (auto _ : state) {
        benchmark::DoNotOptimize(Bvh(mesh));
    }
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void turn_tree(benchmark::State& state, const std::string& file) {
    const Bvh tree(read_meshes(data() / "meshes" / file).front().mesh);
    const Mat3 turn{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(tree.turned(turn));
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const char* set : {"quick", "mixtures", "pieces", "locks"}) {
        benchmark::RegisterBenchmark((std::string("refine/") + set).c_str(), refine_set, std::string(set))
            ->Unit(benchmark::kMillisecond);
    }
    const std::string file = "generated--torus-knot-3-2.stl";
    benchmark::RegisterBenchmark("tree/build", build_tree, file)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("tree/turn", turn_tree, file)->Unit(benchmark::kMicrosecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
