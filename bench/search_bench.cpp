/// The placement search from end to end: packs a named set greedily (Algorithm 2, copies of a part
/// that found no place are skipped) and tells the seconds spent searching, beside the plain
/// method's (one forward and two inverse transforms of the full tray per orientation and, with
/// --detail S, S^3 forward ones; single precision, FFTW_MEASURE), which is timed on a sample of the
/// same states, in a packing of its own lest it disturbs the other's caches, and extrapolated.
///
///   search_bench DATA SET [--voxel MM] [--detail S] [--gap MM] [--tray XxYxZ] [--penalty auto|P] [--threads N]
///                [--cache BYTES] [--most COPIES] [--plain SAMPLES] [--gpu SAMPLES] [--free SAMPLES] [--undo ROUNDS]
///                [--out LEAST-MOST] [--distinct] [--trace]
///
/// --gpu times the plain method on a GPU instead, all orientations of a copy at a time (gpu_plain.hpp); without the
/// distance field, which the CPU makes for it.
///
/// --free asks, once all is packed, where each copy could be if it were not where it is (free_queries.hpp).
///
/// --undo takes the last copies out, as many as --out says, and places them anew, again and again (undo_rounds.hpp).
///
/// DATA is a folder with sets/SET.csv and meshes/. With --distinct every copy counts as a part of its own. One line of
/// results on standard output; with --trace one line a copy: its number, part, voxels, milliseconds.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/stopwatch.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/set_file.hpp"
#include "free_queries.hpp"
#include "packing/tray/greedy.hpp"
#include "search/cpu/cpu_search.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/orientations.hpp"
#include "undo_rounds.hpp"
#ifdef SPECTRALPACK_BENCH_REFERENCE
#include "search/reference/reference_search.hpp"
#endif
#ifdef SPECTRALPACK_BENCH_GPU
#include "gpu_plain_search.hpp"
#endif

namespace {

using namespace spectralpack;

struct Arguments {
    std::filesystem::path data;
    std::string set;
    double voxel = 2, gap = 0.2;
    Vec3 tray{480, 245, 200};
    std::string penalty = "auto";
    int detail = 1, threads = 0, plain_samples = 0, gpu_samples = 0, free_samples = 0, undo_rounds = 0, most = 0;
    CopiesOut out;
    std::int64_t cache = CpuOptions{}.cache_memory;
    bool distinct = false, trace = false;
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
        if (option == "--distinct") {
            result.distinct = true;
            continue;
        }
        if (++i == count) throw UsageError(option + " needs a value");
        const char* value = words[i];
        if (option == "--voxel")
            result.voxel = std::atof(value);
        else if (option == "--detail")
            result.detail = std::atoi(value);
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
        else if (option == "--gpu")
            result.gpu_samples = std::atoi(value);
        else if (option == "--free")
            result.free_samples = std::atoi(value);
        else if (option == "--undo")
            result.undo_rounds = std::atoi(value);
        else if (option == "--out")
            std::sscanf(value, "%d-%d", &result.out.least, &result.out.most);
        else if (option == "--tray") {
            std::sscanf(value, "%lfx%lfx%lf", &result.tray.x, &result.tray.y, &result.tray.z);
        } else
            throw UsageError("unknown option " + option);
    }
    return result;
}

/// The plain method, to be timed beside an engine.
struct Plain {
    PlacementSearch* search = nullptr;                                                          ///< null: none
    std::function<void(const Tray&, const Shape&)> prepare = [](const Tray&, const Shape&) {};  ///< not timed
    int samples = 0;
};

/// Times an engine, and now and then another one on the same question.
class TimedSearch final : public PlacementSearch {
  public:
    TimedSearch(PlacementSearch& engine, const Plain& plain, int every, bool trace)
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
        if (plain_.search && calls_ % every_ == every_ / 2) {
            plain_.prepare(tray, shape);
            SearchResult answer;
            plain_seconds += timed([&] { answer = plain_.search->best_placement(tray, shape, model, stop); });
            plain_orientations += count;
            ++asked;
            const auto &a = result.best, &b = answer.best;
            same += a.has_value() == b.has_value() && (!a || (a->index == b->index && a->position == b->position));
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
    int asked = 0, same = 0;  ///< of the plain method; how often it answered likewise: it rounds

  private:
    template <class Work>
    static double timed(const Work& work) {
        const Stopwatch watch;
        work();
        return watch.seconds();
    }

    PlacementSearch& engine_;
    const Plain& plain_;
    int every_, calls_ = 0;
    bool trace_;
};

/// A set's copies in their order, and the tray they go into.
struct Question {
    std::vector<Mesh> meshes;
    std::vector<Copy> items;
    TraySetup setup;
    CostModel model;
};

Question read_question(const Arguments& arguments) {
    Question question;
    std::vector<PartSize> sizes;
    for (const SetRow& row : read_set(arguments.data / "sets" / (arguments.set + ".csv"))) {
        Mesh mesh = read_meshes(arguments.data / "meshes" / row.mesh).front().mesh;
        for (Vec3& vertex : mesh.vertices) {
            vertex = row.scale * vertex;
        }
        const double volume = bounding_box(mesh).volume();
        const int parts = arguments.distinct ? row.count : 1;
        for (int i = 0; i < parts; ++i) {
            sizes.push_back({static_cast<int>(question.meshes.size()), row.count / parts, volume});
            question.meshes.push_back(mesh);
        }
    }
    TraySetup& setup = question.setup;
    setup.size = arguments.tray;
    setup.voxel_size = arguments.voxel;
    setup.detail = arguments.detail;
    setup.gap_classes = {arguments.gap};
    question.model.height_penalty = arguments.penalty == "auto"
                                        ? automatic_height_penalty(sizes, setup.size.x * setup.size.y * setup.size.z)
                                        : std::atof(arguments.penalty.c_str());
    question.items = order_copies(sizes, Order::size, 0);
    if (arguments.most > 0 && static_cast<std::size_t>(arguments.most) < question.items.size()) {
        question.items.resize(static_cast<std::size_t>(arguments.most));
    }
    return question;
}

struct Packed {
    std::size_t placed = 0;
    std::int64_t searches = 0;
    double costs = 0, megabytes = 0;
    double seconds = 0, orientations = 0;              ///< of the engine
    double plain_seconds = 0, plain_orientations = 0;  ///< of the plain method, on its samples
    int asked = 0, same = 0;                           ///< these, and those with the engine's answer
    FreeQueries free;                                  ///< where copies could be in the tray that is packed
    UndoRounds undo;                                   ///< once it is packed
};

/// Packs greedily. The plain method is asked as well, now and then.
Packed pack(const Question& question, const Arguments& arguments, const Plain& plain, const Workers& workers) {
    const std::vector<Mat3> rotations = orientation_set("90");
    const TraySetup& setup = question.setup;
    Tray tray(setup);
    const auto make = [&](int part, const Workers& makers) {
        Shape shape =
            make_shape(static_cast<std::uint64_t>(part) + 1, question.meshes[static_cast<std::size_t>(part)], rotations,
                       setup.voxel_size, setup.detail, arguments.gap, setup.gap_classes, makers, setup.size);
        shape.copies = static_cast<int>(std::ranges::count(question.items, part, &Copy::part)) + arguments.undo_rounds;
        return std::make_shared<const Shape>(std::move(shape));
    };
    ShapeStore shapes(make, workers, 0, 1);  // none ahead: nothing else goes on while searches are timed
    shapes.start_tray(question.items);
    // FFTW tries its ways out on the first question: not part of the method's time.
    if (plain.search) {
        plain.prepare(tray, shapes.at(0));
        plain.search->best_placement(tray, shapes.at(0), question.model, {});
    }

    const auto engine = make_cpu_search({arguments.cache}, workers);
    const int every = std::max(1, static_cast<int>(question.items.size()) / std::max(1, plain.samples));
    TimedSearch search(*engine, plain, every, arguments.trace && !plain.search);
    GreedyResult result;
    const Settle settle = [&](const Copy&, const Shape& shape, const BestPlacement& best) {
        return settle_on_grid(shape, best, setup.voxel_size, setup.detail, 0);
    };
    const TrayContext context{{search, shapes, workers}, 0, question.model, {}, settle};
    pack_greedily(
        tray, context, question.items, [](std::size_t) {}, result);

    Packed packed{result.placed.size(),
                  result.searches,
                  0,
                  static_cast<double>(engine->memory()) / 1e6,
                  search.seconds,
                  search.orientations,
                  search.plain_seconds,
                  search.plain_orientations,
                  search.asked,
                  search.same,
                  {},
                  {}};
    for (const PlacedCopy& placed : result.placed) {
        packed.costs += placed.cost.primary;
    }
    if (arguments.free_samples > 0) {
        std::unique_ptr<PlacementSearch> transforms;
#ifdef SPECTRALPACK_BENCH_REFERENCE
        transforms = make_reference_search({}, workers);
#endif
        packed.free = ask_free_positions(tray, result.placed, *engine, transforms.get(), arguments.free_samples);
    }
    if (arguments.undo_rounds > 0) {
        std::map<int, std::shared_ptr<const Shape>> made;
        const auto shape_of = [&](const Copy& copy) -> const Shape& {
            std::shared_ptr<const Shape>& shape = made[copy.part];
            if (!shape) shape = make(copy.part, workers);
            return *shape;
        };
        packed.undo = repack_last(tray, result.placed, context, shape_of, arguments.undo_rounds, arguments.out);
    }
    return packed;
}

/// Packs once more with the plain method beside, and says how the two compare.
void compare(const Question& question, const Arguments& arguments, const Plain& plain, const Packed& packed,
             const Workers& workers) {
    const Packed beside = pack(question, arguments, plain, workers);
    const double each = beside.plain_seconds / beside.plain_orientations;
    std::printf(", %s %.2f ms an orientation, %.1f s in all, extrapolated: %.1f times; %d of %d answers the same",
                plain.search->name(), 1e3 * each, each * packed.orientations,
                each * packed.orientations / packed.seconds, beside.same, beside.asked);
}

void run(const Arguments& arguments) {
    const Workers workers(arguments.threads);
    const Question question = read_question(arguments);
    const Packed packed = pack(question, arguments, {}, workers);
    const Extent tray = Tray(question.setup).extent();
    std::printf(
        "%s tray %dx%dx%d voxels of %g detail %d p %g threads %d: placed %zu of %zu, %lld searches, %.0f orientations, "
        "search %.3f s (%.3f ms an orientation), %.0f MB, cost %.6g",
        arguments.set.c_str(), tray.x, tray.y, tray.z, arguments.voxel, arguments.detail, question.model.height_penalty,
        workers.threads(), packed.placed, question.items.size(), static_cast<long long>(packed.searches),
        packed.orientations, packed.seconds, 1e3 * packed.seconds / packed.orientations, packed.megabytes,
        packed.costs);
#ifdef SPECTRALPACK_BENCH_REFERENCE
    if (arguments.plain_samples > 0) {
        ReferenceOptions options;
        options.single_precision = true;
        options.measure = true;
        const auto plain = make_reference_search(options, workers);
        compare(question, arguments, {.search = plain.get(), .samples = arguments.plain_samples}, packed, workers);
    }
#endif
#ifdef SPECTRALPACK_BENCH_GPU
    if (arguments.gpu_samples > 0) {
        GpuPlainSearch gpu;
        const Plain plain{&gpu, [&](const Tray& at, const Shape& shape) { gpu.prepare(at, shape); },
                          arguments.gpu_samples};
        compare(question, arguments, plain, packed, workers);
    }
#else
    if (arguments.gpu_samples > 0) throw UsageError("--gpu: built without nvcc or FFTW");
#endif
    std::printf("\n");
    if (arguments.free_samples > 0) packed.free.print();
    if (arguments.undo_rounds > 0) packed.undo.print();
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
