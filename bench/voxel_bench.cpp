/// Speed of the voxel room: voxelisation of fine meshes and of the parts of a set in the 24
/// orientations of the cube, widening, distance field. Benchmark data as for the tests:
/// $SPECTRALPACK_DATA.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "core/random.hpp"
#include "support/data.hpp"
#include "support/shapes.hpp"
#include "voxel/distance_field.hpp"
#include "voxel/voxelize.hpp"
#include "voxel/widen.hpp"

namespace {

using namespace spectralpack;

Mesh read_binary_stl(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const std::string bytes = text.str();
    Mesh mesh;
    std::map<std::array<float, 3>, std::uint32_t> known;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        Triangle& triangle = mesh.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<float, 3> p;
            std::memcpy(p.data(), &bytes[at + 12 + 12 * i], 12);
            const auto vertex = known.emplace(p, static_cast<std::uint32_t>(mesh.vertices.size())).first;
            if (vertex->second == mesh.vertices.size()) mesh.vertices.push_back({p[0], p[1], p[2]});
            triangle[i] = vertex->second;
        }
    }
    return mesh;
}

/// The distinct meshes of mixtures.csv; none where the data is not there.
const std::vector<Mesh>& mixtures() {
    static const std::vector<Mesh> meshes = [] {
        std::vector<Mesh> result;
        const auto folder = test::benchmark_data();
        if (!folder) return result;
        std::ifstream rows(*folder / "sets/mixtures.csv");
        std::string row;
        std::getline(rows, row);
        while (std::getline(rows, row)) {
            result.push_back(read_binary_stl(*folder / "meshes" / row.substr(0, row.find(','))));
        }
        return result;
    }();
    return meshes;
}

/// The rotations of the cube.
std::vector<Mat3> axis_turns() {
    std::vector<Mat3> turns;
    std::array<int, 3> axes{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Mat3 m;
            for (std::size_t row = 0; row < 3; ++row) {
                m.rows[row] = {};
                m.rows[row][axes[row]] = signs >> row & 1 ? -1 : 1;
            }
            if (determinant(m) == 1) turns.push_back(m);
        }
    } while (std::ranges::next_permutation(axes).found);
    return turns;
}

void voxelize_million_triangles(benchmark::State& state) {
    const Workers workers(static_cast<int>(state.range(0)));
    const Mesh mesh = test::torus_mesh(120, 40, 1000, 500);
    for (auto _ : state) {
        benchmark::DoNotOptimize(voxelize(mesh, 2, workers));
    }
}

/// One medium part: about 4000 triangles, 50 mm.
void voxelize_part(benchmark::State& state) {
    const Workers workers(1);
    const Mesh mesh = test::torus_mesh(18, 7, 64, 31);
    for (auto _ : state) {
        benchmark::DoNotOptimize(voxelize(mesh, 2, workers));
    }
}

void voxelize_large_part_finely(benchmark::State& state) {
    const Workers workers(static_cast<int>(state.range(0)));
    const Mesh mesh = test::torus_mesh(180, 60, 64, 31);
    for (auto _ : state) {
        benchmark::DoNotOptimize(voxelize(mesh, 0.5, workers));
    }
}

void voxelize_mixtures_in_24_orientations(benchmark::State& state) {
    const Workers workers(static_cast<int>(state.range(0)));
    const std::vector<Mat3> turns = axis_turns();
    if (mixtures().empty()) state.SkipWithError("the benchmark data is not here");
    for (auto _ : state) {
        for (const Mesh& mesh : mixtures()) {
            benchmark::DoNotOptimize(voxelize_orientations(mesh, turns, 2, workers));
        }
    }
}

/// In file orientation; gap in tenths of a millimetre.
void widen_mixtures(benchmark::State& state) {
    const Workers workers(1);
    if (mixtures().empty()) state.SkipWithError("the benchmark data is not here");
    std::vector<BitGrid> solids;
    for (const Mesh& mesh : mixtures()) {
        solids.push_back(voxelize(mesh, 2, workers));
    }
    for (auto _ : state) {
        for (std::size_t i = 0; i < solids.size(); ++i) {
            const Box box = bounding_box(mixtures()[i]);
            benchmark::DoNotOptimize(widen(solids[i], mixtures()[i], box.min - inset(box.size(), 2), 2,
                                           0.1 * static_cast<double>(state.range(0)), workers));
        }
    }
}

/// phi of a tray of 480 x 245 x 200 mm at 2 mm, as full as a packing is.
void distance_field(benchmark::State& state) {
    RandomStream random(1);
    BitGrid tray({240, 123, 100});
    BitGrid box({20, 20, 20});
    box.fill(true);
    for (int i = 0; i < 100; ++i) {
        const int x = static_cast<int>(random.below(230)), y = static_cast<int>(random.below(113));
        unite(tray, box, {x, y, static_cast<int>(random.below(90))});
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(manhattan_distance(tray, Ceiling::closed));
    }
}

BENCHMARK(voxelize_million_triangles)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(voxelize_part)->Unit(benchmark::kMicrosecond);
BENCHMARK(voxelize_large_part_finely)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(voxelize_mixtures_in_24_orientations)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(widen_mixtures)->Arg(2)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(distance_field)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
