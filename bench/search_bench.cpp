/// The placement search from end to end: packs a named set greedily (Algorithm 2, copies of a part
/// that found no place are skipped) and tells the seconds spent searching, beside the plain
/// method's (one forward and two inverse transforms of the full tray per orientation, single
/// precision, FFTW_MEASURE), which is timed on a sample of the same states and extrapolated.
///
///   search_bench DATA SET [--voxel MM] [--gap MM] [--tray XxYxZ] [--penalty auto|P] [--threads N]
///                [--cache BYTES] [--most COPIES] [--plain SAMPLES] [--trace]
///
/// DATA is a folder with sets/SET.csv and meshes/. One line of results on standard output; with
/// --trace one line a copy: its number, part, voxels, milliseconds.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/set_file.hpp"
#include "model/orientation.hpp"
#include "packing/greedy.hpp"
#include "search/cpu/cpu_search.hpp"
#ifdef SPECTRALPACK_BENCH_REFERENCE
#include "search/reference/reference_search.hpp"
#endif

namespace {

using namespace spectralpack;

struct Arguments {
    std::filesystem::path data;
    std::string set;
    double voxel = 2, gap = 0.2;
    Vec3 tray{480, 245, 200};
    std::string penalty = "auto";
    int threads = 0, plain_samples = 0, most = 0;
    std::int64_t cache = CpuOptions{}.cache_memory;
    bool trace = false;
};

Arguments parse(int count, char** words) {
    Arguments result;
    if (count < 3) throw UsageError("usage: search_bench DATA SET [options]");
    result.data = words[1];
    result.set = words[2];
    for (int i = 3; i < count; ++i) {
        const std::string option = words[i];
        if (option == "--trace") {
            result.trace = true;
            continue;
        }
        if (++i == count) throw UsageError(option + " needs a value");
        const char* value = words[i];
        if (option == "--voxel")
            result.voxel = std::atof(value);
        else if (option == "--gap")
            result.gap = std::atof(value);
        else if (option == "--penalty")
            result.penalty = value;
        else if (option == "--threads")
            result.threads = std::atoi(value);
        else if (option == "--most")
            result.most = std::atoi(value);
        else if (option == "--cache")
            result.cache = std::atoll(value);
        else if (option == "--plain")
            result.plain_samples = std::atoi(value);
        else if (option == "--tray") {
            std::sscanf(value, "%lfx%lfx%lf", &result.tray.x, &result.tray.y, &result.tray.z);
        } else
            throw UsageError("unknown option " + option);
    }
    return result;
}

/// Times an engine, and now and then another one on the same question.
class TimedSearch final : public PlacementSearch {
  public:
    TimedSearch(PlacementSearch& engine, PlacementSearch* plain, int every, bool trace)
        : engine_(engine), plain_(plain), every_(every), trace_(trace) {}

    SearchResult best_placement(const Tray& tray, const Shape& shape, const CostModel& model,
                                const StopToken& stop) override {
        const auto count = static_cast<double>(shape.orientations.size());
        SearchResult result;
        const double spent = timed([&] { result = engine_.best_placement(tray, shape, model, stop); });
        seconds += spent;
        orientations += count;
        if (trace_) {
            std::printf("%d %llu %lld %.3f\n", calls_, static_cast<unsigned long long>(shape.id),
                        static_cast<long long>(shape.orientations[0].solid->count()), 1e3 * spent);
        }
        if (plain_ && calls_ % every_ == every_ / 2) {
            plain_seconds += timed([&] { plain_->best_placement(tray, shape, model, stop); });
            plain_orientations += count;
        }
        ++calls_;
        return result;
    }
    FreePositions free_positions(const Tray& tray, const Shape& shape, int index, const FreeQuery& query) override {
        return engine_.free_positions(tray, shape, index, query);
    }
    const char* name() const override { return engine_.name(); }
    std::int64_t memory() const override { return engine_.memory(); }

    double seconds = 0, orientations = 0, plain_seconds = 0, plain_orientations = 0;

  private:
    template <class Work>
    static double timed(const Work& work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    PlacementSearch& engine_;
    PlacementSearch* plain_;
    int every_, calls_ = 0;
    bool trace_;
};

void run(const Arguments& arguments) {
    const Workers workers(arguments.threads);
    const std::vector<Mat3> rotations = orientation_set("90");
    const std::vector<SetRow> rows = read_set(arguments.data / "sets" / (arguments.set + ".csv"));
    std::vector<Mesh> meshes;
    std::vector<PartSize> sizes;
    for (const SetRow& row : rows) {
        Mesh mesh = read_meshes(arguments.data / "meshes" / row.mesh).front().mesh;
        for (Vec3& vertex : mesh.vertices) {
            vertex = row.scale * vertex;
        }
        const double volume = bounding_box(mesh).volume();
        sizes.push_back({static_cast<int>(meshes.size()), row.count, volume});
        meshes.push_back(std::move(mesh));
    }

    TraySetup setup;
    setup.size = arguments.tray;
    setup.voxel_size = arguments.voxel;
    setup.gap_classes = {arguments.gap};
    Tray tray(setup);
    CostModel model;
    model.height_penalty = arguments.penalty == "auto"
                               ? automatic_height_penalty(sizes, setup.size.x * setup.size.y * setup.size.z)
                               : std::atof(arguments.penalty.c_str());
    std::vector<PackItem> items = order_items(sizes, Order::size, 0);
    if (arguments.most > 0 && static_cast<std::size_t>(arguments.most) < items.size()) {
        items.resize(static_cast<std::size_t>(arguments.most));
    }
    ShapeStore shapes(
        [&](int part, const Workers& makers) {
            return std::make_shared<const Shape>(
                make_shape(static_cast<std::uint64_t>(part) + 1, meshes[static_cast<std::size_t>(part)], rotations,
                           arguments.voxel, 1, arguments.gap, setup.gap_classes, makers));
        },
        workers, 0, 1);  // none ahead: nothing else goes on while searches are timed
    shapes.start_tray(items);

    const auto engine = make_cpu_search({arguments.cache}, workers);
    std::unique_ptr<PlacementSearch> plain;
#ifdef SPECTRALPACK_BENCH_REFERENCE
    if (arguments.plain_samples > 0) {
        ReferenceOptions options;
        options.single_precision = true;
        options.measure = true;
        plain = make_reference_search(options, workers);
        // FFTW tries its ways out on the first question: not part of the method's time.
        plain->best_placement(tray, shapes.at(0), model, {});
    }
#endif
    const int every = std::max(1, static_cast<int>(items.size()) / std::max(1, arguments.plain_samples));
    TimedSearch search(*engine, plain.get(), every, arguments.trace);
    GreedyResult result;
    const Settle settle = [&](const PackItem&, const Shape& shape, const BestPlacement& best) {
        return stand_on_grid(shape, best, arguments.voxel, 1, 0);
    };
    pack_greedily(
        tray, search, model, items, shapes, settle, [](std::size_t) {}, {}, result);

    double costs = 0;
    for (const PlacedItem& placed : result.placed) {
        costs += placed.cost.primary;
    }
    std::printf(
        "%s voxel %g p %g threads %d: placed %zu of %zu, %lld searches, %.0f orientations, "
        "search %.3f s (%.3f ms an orientation), %.0f MB, cost %.6g",
        arguments.set.c_str(), arguments.voxel, model.height_penalty, workers.threads(), result.placed.size(),
        items.size(), static_cast<long long>(result.searches), search.orientations, search.seconds,
        1e3 * search.seconds / search.orientations, static_cast<double>(engine->memory()) / 1e6, costs);
    if (search.plain_orientations > 0) {
        const double plain_all = search.plain_seconds / search.plain_orientations * search.orientations;
        std::printf(", plain %.2f ms an orientation, %.1f s in all, extrapolated: %.1f times",
                    1e3 * search.plain_seconds / search.plain_orientations, plain_all, plain_all / search.seconds);
    }
    std::printf("\n");
}

}  // namespace

int main(int count, char** words) {
    try {
        run(parse(count, words));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "search_bench: %s\n", error.what());
        return 2;
    }
}
