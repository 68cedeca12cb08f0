/// Speed of the door: reading STL and mending what is read, and writing and reading a
/// whole packing as 3MF, STL and JSON. bytes_per_second is of the file. Benchmark data as for the tests:
/// $SPECTRALPACK_DATA.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/random.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "support/data.hpp"
#include "support/shapes.hpp"

namespace {

using namespace spectralpack;
namespace fs = std::filesystem;

/// A folder for what is written here, removed at the end.
const fs::path& folder() {
    struct Folder {
        fs::path path = fs::temp_directory_path() / ("spectralpack-formats-bench-" + std::to_string(::getpid()));
        Folder() { fs::create_directories(path); }
        ~Folder() { fs::remove_all(path); }
    };
    static const Folder made;
    return made.path;
}

fs::path torus_stl(int around, int across) {
    const fs::path path = folder() / ("torus-" + std::to_string(around) + ".stl");
    if (fs::exists(path)) return path;
    Packing packing;
    packing.parts.resize(1);
    packing.trays.resize(1);
    packing.trays[0].placements.resize(1);
    write_stl(packing, {std::make_shared<const Mesh>(test::torus_mesh(40, 10, around, across))}, path);
    return path;
}

/// A fine torus of 2 * across * around triangles: one shell, nothing to mend.
void read_stl(benchmark::State& state) {
    const auto around = static_cast<int>(state.range(0));
    const fs::path path = torus_stl(around, around / 2);
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = read_meshes(path).front().mesh.triangles.size();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(fs::file_size(path)));
    state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(read_stl)->Arg(100)->Arg(300)->Arg(1000)->Arg(2000)->Unit(benchmark::kMillisecond);

/// Every mesh of pieces.csv, one after the other.
void read_pieces(benchmark::State& state) {
    const auto data = test::benchmark_data();
    if (!data) return state.SkipWithError("no benchmark data");
    std::int64_t bytes = 0;
    for (auto _ : state) {
        for (const SetRow& row : read_set(*data / "sets/pieces.csv")) {
            const fs::path file = *data / "meshes" / row.mesh;
            benchmark::DoNotOptimize(read_meshes(file));
            bytes += static_cast<std::int64_t>(fs::file_size(file));
        }
    }
    state.SetBytesProcessed(bytes);
}
BENCHMARK(read_pieces)->Unit(benchmark::kMillisecond);

/// The 1,446 copies of pieces.csv, turned and strewn over a tray.
struct Strewn {
    Packing packing;
    PartMeshes meshes;
};

const Strewn* strewn_pieces() {
    static const std::optional<Strewn> strewn = []() -> std::optional<Strewn> {
        const auto data = test::benchmark_data();
        if (!data) return std::nullopt;
        Strewn made;
        RandomStream random(1);
        made.packing.container.size = {480, 245, 200};
        TrayPacking& tray = made.packing.trays.emplace_back();
        for (const SetRow& row : read_set(*data / "sets/pieces.csv")) {
            PackedPart part;
            part.id = static_cast<int>(made.packing.parts.size());
            part.name = fs::path(row.mesh).stem().string();
            part.mesh = (*data / "meshes" / row.mesh).string();
            part.count = row.count;
            part.scale = row.scale;
            made.meshes.push_back(std::make_shared<const Mesh>(std::move(read_meshes(part.mesh).front().mesh)));
            for (int copy = 0; copy < row.count; ++copy) {
                Mat3 turn;
                std::rotate(turn.rows.begin(), turn.rows.begin() + static_cast<int>(random.below(3)), turn.rows.end());
                tray.placements.push_back(
                    {part.id,
                     copy,
                     0,
                     false,
                     {row.scale * turn, {480 * random.unit(), 245 * random.unit(), 200 * random.unit()}}});
            }
            made.packing.parts.push_back(std::move(part));
        }
        return made;
    }();
    return strewn ? &*strewn : nullptr;
}

template <class Write, class Read>
void whole_packing(benchmark::State& state, const char* ending, bool writing, Write write, Read read) {
    const Strewn* strewn = strewn_pieces();
    if (!strewn) return state.SkipWithError("no benchmark data");
    const fs::path path = folder() / (std::string("pieces") + ending);
    write(*strewn, path);
    for (auto _ : state) {
        if (writing) {
            write(*strewn, path);
        } else {
            read(path);
        }
    }
    const auto bytes = static_cast<std::int64_t>(fs::file_size(path));
    state.SetBytesProcessed(state.iterations() * bytes);
    state.counters["MB"] = static_cast<double>(bytes) / 1e6;
    state.counters["copies"] = static_cast<double>(strewn->packing.trays[0].placements.size());
}

void write_as_3mf(const Strewn& strewn, const fs::path& path) { write_3mf(strewn.packing, strewn.meshes, path); }
void write_as_stl(const Strewn& strewn, const fs::path& path) { write_stl(strewn.packing, strewn.meshes, path); }
void write_as_json(const Strewn& strewn, const fs::path& path) { write_packing(strewn.packing, path); }
void read_mesh_file(const fs::path& path) { benchmark::DoNotOptimize(read_meshes(path)); }
void read_json(const fs::path& path) { benchmark::DoNotOptimize(read_packing(path)); }

BENCHMARK_CAPTURE(whole_packing, write_3mf, ".3mf", true, write_as_3mf, read_mesh_file)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_packing, read_3mf, ".3mf", false, write_as_3mf, read_mesh_file)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_packing, write_stl, ".stl", true, write_as_stl, read_mesh_file)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_packing, read_stl, ".stl", false, write_as_stl, read_mesh_file)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_packing, write_json, ".json", true, write_as_json, read_json)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_packing, read_json, ".json", false, write_as_json, read_json)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
