#include "api/record.hpp"

#include <set>
#include <string>
#include <utility>

#include "api/check_options.hpp"
#include "api/engine_factory.hpp"
#include "api/fixed_copies.hpp"
#include "api/input_hash.hpp"
#include "api/machine.hpp"
#include "packing/tray/measure.hpp"
#include "spectralpack/names.hpp"

namespace spectralpack {
namespace {

/// A plan of copies that stand after `first` others.
Disassembly shifted(Disassembly plan, int first) {
    const auto shift = [&](std::vector<int>& placements) {
        for (int& placement : placements) {
            placement += first;
        }
    };
    for (RemovalStep& step : plan.steps) {
        shift(step.placements);
    }
    for (std::vector<int>& set : plan.interlocked) {
        shift(set);
    }
    return plan;
}

/// `tray` holds its fixed copies.
void add_placed(const PackRun& run, const FilledTray& filled, TrayPacking& tray, std::set<Copy>& settled) {
    if (filled.plan) tray.disassembly = shifted(*filled.plan, static_cast<int>(tray.placements.size()));
    for (const PlacedCopy& placed : filled.placed) {
        settled.insert(placed.copy);
        tray.placements.push_back({placed.copy.part, placed.copy.number, placed.orientation, false,
                                   transform_of(run.loaded, run.plan, placed)});
    }
}

/// A packing in shares has as many copies as were placed of each part.
void count_what_came_of_shares(const PackRun& run, std::vector<PackedPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i < run.loaded.fixed_parts || !run.loaded.meshes[i] || !run.plan.too_large[i].empty()) continue;
        parts[i].share = std::exchange(parts[i].count, 0);
    }
    for (const FilledTray& tray : run.trays.trays) {
        for (const PlacedCopy& placed : tray.placed) {
            ++parts[static_cast<std::size_t>(placed.copy.part)].count;
        }
    }
}

/// What is known of a copy that found no place although nothing stands in its tray; empty where something does.
std::string why_in_empty_tray(const PackRun& run) {
    const Container& container = run.container;
    const bool empty = run.trays.placed() == 0 && run.loaded.fixed.empty();
    if (!empty || (!container.mesh && container.keep_out.empty())) return "";
    return container.mesh ? "does not fit into the container's walls, not even while it is empty"
                          : "does not fit beside the keep-outs, not even into the empty tray";
}

/// Copies that are not placed, and why; `settled` are those that are.
std::vector<Unplaced> unplaced_of(const PackRun& run, std::set<Copy> settled) {
    std::vector<Unplaced> unplaced;
    for (std::size_t i = 0; i < run.loaded.parts.size(); ++i) {
        const bool unusable = !run.loaded.meshes[i];
        if (!unusable && run.plan.too_large[i].empty()) continue;
        for (int copy = 0; copy < run.loaded.parts[i].count; ++copy) {
            unplaced.push_back({static_cast<int>(i), copy,
                                unusable ? UnplacedReason::bad_file : UnplacedReason::too_large,
                                unusable ? run.loaded.problem[i] : run.plan.too_large[i]});
        }
    }
    const FilledTray& last = run.trays.trays.back();
    for (const Copy& copy : last.interlocked) {
        unplaced.push_back({copy.part, copy.number, UnplacedReason::cannot_leave, ""});
        settled.insert(copy);
    }
    const std::string in_empty = why_in_empty_tray(run);
    for (const Copy& copy : run.trays.left_over) {
        if (!settled.insert(copy).second) continue;
        const auto cap = last.why.find(copy.part);
        if (cap == last.why.end()) {
            unplaced.push_back({copy.part, copy.number, UnplacedReason::no_place, in_empty});
        } else {
            unplaced.push_back({copy.part, copy.number, UnplacedReason::cap, cap->second});
        }
    }
    for (const Copy& copy : run.plan.items) {
        if (run.options.fill || settled.contains(copy)) continue;
        unplaced.push_back({copy.part, copy.number, UnplacedReason::not_tried, ""});
    }
    return unplaced;
}

Metrics metrics_of(const PackRun& run, const Packing& packing, const Workers& workers) {
    Metrics metrics;
    for (const PackedPart& part : packing.parts) {
        metrics.copies += part.count;
    }
    metrics.placed = run.trays.placed() + static_cast<std::int64_t>(run.loaded.fixed.size());
    metrics.seconds = run.seconds;
    for (const FilledTray& tray : run.trays.trays) {
        metrics.seconds.disassemble += tray.report.disassemble_seconds;
        metrics.seconds.reinsert += tray.report.reinsert_seconds;
        if (tray.plan) metrics.interlock = metrics.interlock.value_or(InterlockCounts{}) + tray.report.counts;
    }
    for (const TrayPacking& tray : packing.trays) {
        metrics.density += tray.density / static_cast<double>(packing.trays.size());
    }
    metrics.min_gap = run.trays.least_gap();
    metrics.searches = run.trays.searches();
    metrics.verified = run.verified;
    metrics.orders = run.orders;
    metrics.improvement = run.improvement;
    metrics.peak_memory = peak_memory();
    metrics.engine = to_string(run.plan.engine);
    metrics.threads = workers.threads();
    return metrics;
}

}  // namespace

Packing packing_of(const PackRun& run, const Workers& workers) {
    Packing packing;
    packing.program = "spectralpack " SPECTRALPACK_VERSION;
    packing.input_hash = input_hash(run.loaded, run.container, run.options);
    packing.container = run.container;
    packing.container.size = tray_size(run.options);
    packing.container.open_height = is_open(run.options);
    if (run.base) {
        packing.container.size.x = run.base->x * voxel_size(run.options) + 2 * run.options.wall_gap;
        packing.container.size.y = run.base->y * voxel_size(run.options) + 2 * run.options.wall_gap;
    }
    packing.options = run.options;
    packing.options.tray = tray_size(run.options);
    packing.options.height_at = height_reference(run.options);
    packing.options.unpack = unpack_rule(run.options.unpack, run.container);
    packing.options.height_penalty = run.plan.height_penalty;
    packing.options.engine = run.plan.engine;
    packing.defaults = run.defaults;
    packing.parts = run.loaded.parts;

    if (run.options.fill) count_what_came_of_shares(run, packing.parts);

    std::set<Copy> settled;
    packing.trays = fixed_trays(run.loaded);
    packing.trays.resize(std::max(packing.trays.size(), run.trays.trays.size()));
    for (std::size_t t = 0; t < packing.trays.size(); ++t) {
        TrayPacking& tray = packing.trays[t];
        if (t < run.trays.trays.size()) {
            const FilledTray& filled = run.trays.trays[t];
            tray.height_at = filled.height_at == HeightAt::top ? HeightReference::top : HeightReference::bottom;
            add_placed(run, filled, tray, settled);
        }
        if (packing.container.open_height && !tray.placements.empty()) {
            packing.container.size.z = reached_height(tray, run.loaded.meshes);
        }
        measure_tray(tray, packing.container, packing.parts, run.loaded.meshes, voxel_size(run.options), workers);
    }
    packing.unplaced = unplaced_of(run, std::move(settled));
    packing.metrics = metrics_of(run, packing, workers);
    return packing;
}

Transform transform_of(const LoadedJob& loaded, const Plan& plan, const PlacedCopy& placed) {
    const double mm = loaded.parts[static_cast<std::size_t>(placed.copy.part)].to_mm();
    const std::vector<Mat3>& turns = *plan.orientations[static_cast<std::size_t>(placed.copy.part)];
    return {mm * turns[static_cast<std::size_t>(placed.orientation)], placed.offset};
}

std::string stuck_text(const LoadedJob& loaded, const TraysResult& trays) {
    const PackedPart& first = loaded.parts[static_cast<std::size_t>(trays.left_over.front().part)];
    return "tray " + std::to_string(trays.trays.size() + 1) + " would stay empty: of " +
           std::to_string(trays.left_over.size()) + (trays.left_over.size() == 1 ? " copy" : " copies") +
           " tried none finds a place in it, the first of them " + first.name;
}

}  // namespace spectralpack
