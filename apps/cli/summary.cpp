#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "text.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::size_t kMostListed = 8;

std::string size_text(const Vec3& size) {
    return fmt::format("{} x {} x {} mm", length_text(size.x), length_text(size.y), length_text(size.z));
}

void print_left_over(const Packing& packing) {
    if (packing.unplaced.empty()) return;
    // Copies of one part for one reason in one entry, in the order in which they were given up.
    struct Entry {
        int part;
        UnplacedReason reason;
        int copies;
    };
    std::vector<Entry> entries;
    std::map<std::pair<int, UnplacedReason>, std::size_t> index;
    for (const Unplaced& copy : packing.unplaced) {
        const auto [at, fresh] = index.emplace(std::pair(copy.part, copy.reason), entries.size());
        if (fresh) entries.push_back({copy.part, copy.reason, 0});
        ++entries[at->second].copies;
    }
    fmt::print("  left over  {} of {} copies\n", packing.unplaced.size(), packing.metrics.copies);
    for (std::size_t i = 0; i < entries.size() && i < kMostListed; ++i) {
        const Entry& entry = entries[i];
        fmt::print("    {} x {}: {}\n", entry.copies,
                   printable(packing.parts[static_cast<std::size_t>(entry.part)].name), in_words(entry.reason));
    }
    if (entries.size() > kMostListed) {
        fmt::print("    and {} more parts; the packing file lists them all\n", entries.size() - kMostListed);
    }
}

/// Where the counts are a whole round of shares or more from those asked for: which part found no further place.
void print_uneven_shares(const Packing& packing) {
    const auto rounds = [](const PackedPart& part) { return static_cast<double>(part.count) / part.share; };
    std::vector<const PackedPart*> shared;
    for (const PackedPart& part : packing.parts) {
        if (part.share > 0) shared.push_back(&part);
    }
    if (shared.size() < 2) return;
    const auto [least, most] = std::ranges::minmax(shared, {}, [&](const PackedPart* part) { return rounds(*part); });
    if (rounds(*most) - rounds(*least) < 1) return;
    std::string came, asked;
    for (std::size_t i = 0; i < shared.size() && i < kMostListed; ++i) {
        const char* const before = i > 0 ? " : " : "";
        const double round = std::max(1.0, rounds(*least));
        came += fmt::format("{}{:.3g}", before, shared[i]->count / round);
        asked += fmt::format("{}{}", before, shared[i]->share);
    }
    fmt::print("             {} for the {} asked, as no further {} found a free place\n", came, asked,
               printable(least->name));
}

/// What came of the shares.
void print_shares(const Packing& packing) {
    for (std::size_t i = 0; i < packing.parts.size() && i < kMostListed; ++i) {
        const PackedPart& part = packing.parts[i];
        fmt::print("  filled     {} x {} (share {})\n", part.count, printable(part.name), part.share);
    }
    if (packing.parts.size() > kMostListed)
        fmt::print("             and {} more parts\n", packing.parts.size() - kMostListed);
    print_uneven_shares(packing);
}

void print_caps(const Packing& packing) {
    const Vec3& size = packing.container.size;
    double fullest = 0;
    for (const TrayPacking& tray : packing.trays) {
        for (const double area : tray.layers.area) {
            fullest = std::max(fullest, area / (size.x * size.y));
        }
    }
    if (packing.options.max_density) {
        fmt::print("  cap        density up to {}\n", percent_text(*packing.options.max_density));
    }
    if (packing.options.max_layer_fill) {
        fmt::print("  cap        layers up to {} of their area; the fullest has {}\n",
                   percent_text(*packing.options.max_layer_fill), percent_text(fullest));
    }
}

/// One tray has its own figures; of several each has a line.
void print_trays(const Packing& packing) {
    if (packing.trays.size() == 1) {
        const TrayPacking& tray = packing.trays.front();
        fmt::print("  density    {} of the container, {} of the packing's own box\n", percent_text(tray.density),
                   percent_text(tray.density_bounding_box));
        fmt::print("  height     {} mm{}\n", length_text(tray.height),
                   packing.container.open_height ? ", without a ceiling" : "");
        return;
    }
    fmt::print("  density    {} of {} containers\n", percent_text(packing.metrics.density), packing.trays.size());
    for (std::size_t i = 0; i < packing.trays.size(); ++i) {
        const TrayPacking& tray = packing.trays[i];
        fmt::print("    tray {:<3} {:>5} copies, {:>6}, height {} mm\n", i + 1, tray.placements.size(),
                   percent_text(tray.density), length_text(tray.height));
    }
}

std::string container_text(const Container& container) {
    std::string text = size_text(container.size);
    if (container.mesh) text += fmt::format(" ({})", printable(container.mesh->file));
    if (!container.keep_out.empty()) {
        text += fmt::format(", {} keep-out{}", container.keep_out.size(), container.keep_out.size() == 1 ? "" : "s");
    }
    return text;
}

std::int64_t fixed_copies(const Packing& packing) {
    std::int64_t count = 0;
    for (const TrayPacking& tray : packing.trays) {
        for (const Placement& placement : tray.placements) {
            count += placement.fixed ? 1 : 0;
        }
    }
    return count;
}

void print_interlocking(const Packing& packing) {
    const PlansOverview plans = plans_of(packing);
    const InterlockCounts counts = packing.metrics.interlock.value_or(InterlockCounts{});
    if (!plans.planned) {
        fmt::print("  INTERLOCKING IS NOT CHECKED: some parts may not come apart after printing.\n");
    } else if (!plans.complete) {
        fmt::print(
            "  INTERLOCKING IS ONLY PARTLY CHECKED: there was time to plan {} of {} removals; the rest may not "
            "come apart.\n",
            plans.steps, packing.metrics.placed);
    } else {
        const PhaseSeconds& seconds = packing.metrics.seconds;
        fmt::print("  interlock  none: comes apart in {} steps{} (planning {}", plans.steps,
                   through_walls_text(plans.through_walls), duration_text(seconds.disassemble));
        if (counts.removed > 0) {
            fmt::print("; {} taken out, {} of them put back elsewhere{}, {}", counts.removed, counts.reinserted,
                       counts.added > 0 ? fmt::format(", {} others put in", counts.added) : "",
                       duration_text(seconds.reinsert));
        }
        fmt::print(")\n");
    }
}

}  // namespace

void print_summary(const PackResult& result, const std::vector<std::string>& written, bool files_named,
                   const TakenOver& taken) {
    const Packing& packing = result.packing;
    const Metrics& metrics = packing.metrics;
    const PhaseSeconds& seconds = metrics.seconds;
    if (result.stopped == StopReason::cancelled) fmt::print("Interrupted: this is the packing so far.\n");
    if (result.stopped == StopReason::time_limit) fmt::print("Time limit: this is the packing so far.\n");
    const auto as_in = [&](bool it_is) { return it_is ? fmt::format(", as in {}", printable(taken.file)) : ""; };
    fmt::print("Placed {} of {} copies in {}{}\n", metrics.placed, metrics.copies, container_text(packing.container),
               as_in(taken.container));
    if (const std::int64_t fixed = fixed_copies(packing)) fmt::print("  fixed      {} of them stood there\n", fixed);
    print_trays(packing);
    if (packing.options.fill) print_shares(packing);
    if (packing.options.max_density || packing.options.max_layer_fill) print_caps(packing);
    fmt::print("  gap        {} mm between copies{}, {} mm to the walls{}\n", length_text(packing.options.gap),
               as_in(taken.gap && !taken.wall_gap), length_text(packing.options.wall_gap), as_in(taken.wall_gap));
    if (metrics.min_gap) fmt::print("  least gap  {} mm, measured\n", length_text(*metrics.min_gap));
    const std::string refining =
        packing.options.refine ? fmt::format(", refining {}", duration_text(seconds.refine)) : "";
    fmt::print("  time       {} (loading {}, voxels {}, search {}{}; {} searches, {} on {} thread{})\n",
               duration_text(seconds.total), duration_text(seconds.load), duration_text(seconds.voxelize),
               duration_text(seconds.search), refining, metrics.searches, metrics.engine, metrics.threads,
               metrics.threads == 1 ? "" : "s");
    fmt::print("  memory     {} at peak\n", bytes_text(metrics.peak_memory));
    if (metrics.orders > 1) fmt::print("  order      the best of {} packings\n", metrics.orders);
    if (packing.options.verify_with) {
        fmt::print("  verified   {} placements answered alike by a second engine\n", metrics.verified);
    }
    print_left_over(packing);
    print_interlocking(packing);
    if (written.empty()) fmt::print("  Nothing was written{}.\n", files_named ? "" : ": name files with -o");
    for (const std::string& file : written) {
        fmt::print("  wrote      {}\n", file);
    }
}

void print_estimate(const Estimate& estimate, const PackOptions& options, const std::optional<ProbedTime>& time) {
    const bool open = options.open_height || options.minimise == Minimise::box;
    fmt::print("{} copies of {} parts {}\n", estimate.copies, estimate.parts,
               open ? fmt::format("onto {} x {} mm, without a ceiling", length_text(options.tray.x),
                                  length_text(options.tray.y))
                    : "into " + size_text(estimate.container));
    fmt::print("  grid       {} x {} x {} voxels of {} mm{}\n", estimate.grid.x, estimate.grid.y, estimate.grid.z,
               length_text(options.voxel), open ? " to begin with" : "");
    fmt::print("  searches   at most {}, each over {} orientation{}\n", estimate.searches, estimate.orientations,
               estimate.orientations == 1 ? "" : "s");
    fmt::print("  memory     about {}, of {} {}\n", bytes_text(estimate.memory), bytes_text(estimate.memory_limit),
               options.memory > 0 ? "allowed" : "free");
    if (!time) {
        fmt::print("  time       unknown: it cannot start with this memory\n");
    } else if (time->packed == 0) {
        fmt::print("  time       much more than {}: too few copies were tried by then\n", duration_text(time->seconds));
    } else {
        fmt::print("  time       about {} ({} of the copies were tried to see)\n", duration_text(time->seconds),
                   percent_text(time->packed));
    }
    fmt::print("  material   {} of the container; boxes {}\n", percent_text(estimate.volume_ratio),
               percent_text(estimate.box_ratio));
    fmt::print("  height     penalty p = {:g}\n", estimate.height_penalty);
    for (const std::string& part : estimate.too_large) {
        fmt::print("  too large  {}\n", printable(part));
    }
    fmt::print("Nothing was written (--dry-run).\n");
}

}  // namespace spectralpack::cli
