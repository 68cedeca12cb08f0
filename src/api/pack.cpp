#include "spectralpack/pack.hpp"

#include <chrono>
#include <map>
#include <new>
#include <set>
#include <tuple>
#include <utility>

#include "api/engine_factory.hpp"
#include "api/load.hpp"
#include "api/machine.hpp"
#include "api/plan.hpp"
#include "packing/many_trays.hpp"
#include "packing/measure.hpp"
#include "search/verifying_search.hpp"

namespace spectralpack {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Parts that are the same mesh at the same size with the same gap share an id, and so the engines' caches.
std::vector<std::uint64_t> shape_ids(const LoadedJob& loaded) {
    std::map<std::tuple<const Mesh*, double, double>, std::uint64_t> ids;
    std::vector<std::uint64_t> by_part;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const auto key = std::tuple(loaded.meshes[i].get(), loaded.parts[i].to_mm(), loaded.parts[i].gap);
        by_part.push_back(ids.emplace(key, ids.size() + 1).first->second);
    }
    return by_part;
}

/// One run of pack(): the loaded job, its plan, and the packing as it grows.
class Run {
  public:
    Run(const Job& job, Listener& listener, const StopToken& stop)
        : job_(job), listener_(listener), stop_(stop), workers_(job.options.threads) {}

    PackResult run() {
        const auto start = Clock::now();
        check_options(job_.options);
        loaded_ = load_parts(job_, workers_, listener_);
        plan_ = make_plan(loaded_, job_.options, workers_);
        require_memory(plan_, loaded_, job_.options, workers_);
        for (std::size_t i = 0; i < loaded_.parts.size(); ++i) {
            if (!plan_.too_large[i].empty()) {
                listener_.on_warning(loaded_.parts[i].name + " " + plan_.too_large[i]);
            }
        }
        PackResult result;
        seconds_.load = seconds_since(start);

        TraysResult trays;
        try {
            search(trays);
        } catch (const std::bad_alloc&) {
            result.failure = ResourceError("out of memory while searching; what was placed is kept");
        } catch (const Error& error) {
            result.failure = error;
        }
        if (trays.trays.empty()) trays.trays.emplace_back();  // failed before the first; its packing has one, empty
        result.stopped = stop_.reason();
        result.packing = packing_of(trays);
        result.packing.metrics.seconds.total = seconds_since(start);
        result.meshes = std::move(loaded_.meshes);
        result.unusable = std::move(loaded_.unusable);
        return result;
    }

  private:
    FillSetup fill_setup() const {
        const PackOptions& options = job_.options;
        const double wall = 2 * options.wall_gap;
        FillSetup setup;
        setup.tray.size = options.tray - Vec3{wall, wall, wall};
        setup.tray.voxel_size = options.voxel;
        setup.tray.gap_classes = plan_.gap_classes;
        setup.container = options.tray;
        setup.wall_gap = options.wall_gap;
        setup.model = {plan_.height_penalty,
                       options.height_at == HeightReference::top ? HeightAt::top : HeightAt::bottom};
        setup.orientations = plan_.orientations;
        setup.refine = options.refine;
        setup.interlock = options.interlock;
        setup.left = [this, most = std::int64_t{0}](int left) mutable {
            most = std::max<std::int64_t>(most, left + 1);
            const double work = static_cast<double>(most - left) / static_cast<double>(most);
            listener_.on_progress({Phase::disassemble, most - left, most, 0, work});
        };
        return setup;
    }

    void search(TraysResult& trays) {
        const PackOptions& options = job_.options;
        const auto total = static_cast<std::int64_t>(plan_.items.size());
        std::unique_ptr<PlacementSearch> engine = make_engine(plan_.engine, plan_.cache, workers_);
        VerifyingSearch* verifying = nullptr;
        if (options.verify_with) {
            auto both = std::make_unique<VerifyingSearch>(
                std::move(engine), make_engine(resolve_engine(options.verify_with->engine), 0, workers_),
                VerifyingOptions{options.verify_with->sample, total, options.seed});
            verifying = both.get();
            engine = std::move(both);
        }
        TrayFiller filler(
            fill_setup(), *engine,
            [&](int part) {
                const auto i = static_cast<std::size_t>(part);
                return RefinedPart{scaled_mesh(i), loaded_.parts[i].gap};
            },
            workers_);
        const std::vector<std::uint64_t> ids = shape_ids(loaded_);
        const MakeShapeStore make_shapes = [&](const std::vector<PackItem>& items) {
            return ShapeStore(
                items,
                [&](int part) {
                    const auto i = static_cast<std::size_t>(part);
                    return std::make_shared<const Shape>(
                        make_shape(ids[i], scaled_mesh(i), plan_.orientations, options.voxel,
                                   loaded_.parts[i].gap, plan_.gap_classes, workers_));
                },
                workers_, [&](double seconds) { seconds_.voxelize += seconds; });
        };

        const auto start = Clock::now();
        listener_.on_progress({Phase::search, 0, total, 0, 0});
        const double container = options.tray.x * options.tray.y * options.tray.z;
        double volume = 0;
        std::size_t placed = 0;
        const TrayItemDone item_done = [&](const FilledTray& tray, std::size_t done) {
            for (; placed < tray.placed.size(); ++placed) {
                volume += loaded_.parts[static_cast<std::size_t>(tray.placed[placed].item.part)].volume;
            }
            listener_.on_progress({Phase::search, static_cast<std::int64_t>(done), total, volume / container,
                                   static_cast<double>(done) / static_cast<double>(total)});
        };
        const auto finish = [&] {
            seconds_.refine = filler.refine_seconds();
            seconds_.search = seconds_since(start) - seconds_.voxelize - seconds_.refine - filler.untangle_seconds();
            if (verifying) verified_ = verifying->verified();
        };
        try {
            fill_trays(plan_.items, 1, filler, make_shapes, item_done, stop_, trays);
        } catch (...) {
            finish();
            throw;
        }
        finish();
    }

    /// A part's mesh in millimetres, not turned.
    Mesh scaled_mesh(std::size_t part) const {
        return transformed(*loaded_.meshes[part], {loaded_.parts[part].to_mm() * Mat3{}, {}});
    }

    /// The transform from the mesh file's own coordinates to where the copy stands.
    Transform transform_of(const PlacedItem& placed) const {
        const double mm = loaded_.parts[static_cast<std::size_t>(placed.item.part)].to_mm();
        return {mm * plan_.orientations[static_cast<std::size_t>(placed.orientation)], placed.offset};
    }

    Packing packing_of(const TraysResult& trays) {
        Packing packing;
        packing.program = "spectralpack " SPECTRALPACK_VERSION;
        packing.input_hash = input_hash(loaded_, job_.options);
        packing.container.size = job_.options.tray;
        packing.options = job_.options;
        packing.options.height_penalty = plan_.height_penalty;
        packing.options.engine = plan_.engine;
        packing.parts = loaded_.parts;

        std::set<std::pair<int, int>> settled;  // part and copy
        for (const FilledTray& greedy : trays.trays) {
            TrayPacking tray;
            for (const PlacedItem& placed : greedy.placed) {
                settled.emplace(placed.item.part, placed.item.copy);
                tray.placements.push_back({placed.item.part, placed.item.copy, placed.orientation, false,
                                           transform_of(placed)});
            }
            tray.disassembly = greedy.plan;
            measure_tray(tray, packing.container, packing.parts, loaded_.meshes, job_.options.voxel, workers_);
            packing.metrics.density += tray.density / static_cast<double>(trays.trays.size());
            packing.trays.push_back(std::move(tray));
        }

        for (std::size_t i = 0; i < loaded_.parts.size(); ++i) {
            const bool unusable = !loaded_.meshes[i];
            if (!unusable && plan_.too_large[i].empty()) continue;
            for (int copy = 0; copy < loaded_.parts[i].count; ++copy) {
                packing.unplaced.push_back(
                    {static_cast<int>(i), copy,
                     unusable ? UnplacedReason::unusable : UnplacedReason::too_large,
                     unusable ? loaded_.problem[i] : plan_.too_large[i]});
            }
        }
        for (const PackItem& item : trays.left_over) {
            packing.unplaced.push_back({item.part, item.copy, UnplacedReason::tray_full, ""});
            settled.emplace(item.part, item.copy);
        }
        for (const FilledTray& filled : trays.trays) {
            for (const PackItem& item : filled.interlocked) {
                if (!settled.emplace(item.part, item.copy).second) continue;  // it stands in a later tray
                packing.unplaced.push_back({item.part, item.copy, UnplacedReason::interlocked, ""});
            }
            seconds_.disassemble += filled.report.disassemble_seconds;
            seconds_.reinsert += filled.report.reinsert_seconds;
        }
        for (const PackItem& item : plan_.items) {
            if (settled.contains({item.part, item.copy})) continue;
            packing.unplaced.push_back({item.part, item.copy, UnplacedReason::stopped, ""});
        }

        Metrics& metrics = packing.metrics;
        for (const Part& part : packing.parts) {
            metrics.copies += part.count;
        }
        metrics.placed = trays.placed();
        metrics.seconds = seconds_;
        metrics.searches = trays.searches();
        metrics.verified = verified_;
        metrics.peak_memory = peak_memory();
        metrics.engine = engine_name(plan_.engine);
        metrics.threads = workers_.threads();
        return packing;
    }

    const Job& job_;
    Listener& listener_;
    StopToken stop_;
    Workers workers_;
    LoadedJob loaded_;
    Plan plan_;
    PhaseSeconds seconds_;
    std::int64_t verified_ = 0;
};

}  // namespace

PackResult pack(const Job& job, Listener& listener, const StopToken& stop) {
    return Run(job, listener, stop).run();
}

Estimate estimate(const Job& job, Listener& listener) {
    check_options(job.options);
    const Workers workers(job.options.threads);
    const LoadedJob loaded = load_parts(job, workers, listener);
    const Plan plan = make_plan(loaded, job.options, workers);
    Estimate estimate;
    estimate.grid = plan.grid;
    estimate.orientations = static_cast<int>(plan.orientations.size());
    estimate.parts = static_cast<int>(loaded.parts.size());
    for (const Part& part : loaded.parts) {
        estimate.copies += part.count;
    }
    estimate.searches = static_cast<std::int64_t>(plan.items.size());
    estimate.memory = plan.memory;
    estimate.memory_limit = plan.memory_limit;
    estimate.box_ratio = plan.box_ratio;
    estimate.volume_ratio = plan.volume_ratio;
    estimate.height_penalty = plan.height_penalty;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        if (!plan.too_large[i].empty()) {
            estimate.too_large.push_back(loaded.parts[i].name + " " + plan.too_large[i]);
        }
    }
    estimate.unusable = loaded.unusable;
    return estimate;
}

}  // namespace spectralpack
