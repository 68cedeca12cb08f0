#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exit_status.hpp"
#include "left_over.hpp"
#include "summary_lines.hpp"
#include "summary_texts.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// How much room a summary gives to what may be long; tried one after the other until it fits a screen.
struct Room {
    std::size_t reason_lines;  ///< for each reason why copies are left over
    std::size_t trays;         ///< rows of the table of trays
};

constexpr Room kRooms[] = {{2, 8}, {1, 8}, {1, 4}};

std::string comes_apart(const TrayPacking& tray) {
    if (!tray.disassembly) return "NOT CHECKED";
    const std::size_t steps = tray.disassembly->steps.size();
    const std::string count = fmt::format("{} step{}", steps, steps == 1 ? "" : "s");
    if (!tray.disassembly->complete) return "ONLY PARTLY CHECKED";
    const std::size_t stay = staying(tray).size();
    return "in " + count + (stay > 0 ? fmt::format(", {} from before stay", stay) : "");
}

void add_trays(const Packing& packing, std::size_t most, SummaryLines& lines) {
    double fullest = 0;
    for (const TrayPacking& tray : packing.trays) {
        fullest = std::max(fullest, tray.density);
    }
    lines.blank();
    lines.row("             copies   height   filled   comes apart");
    const std::size_t count = packing.trays.size(), first = count <= most ? count : most - 2;
    for (std::size_t i = 0; i < count; ++i) {
        if (i == first) lines.row("     …");
        if (i >= first && i + 1 < count) continue;
        const TrayPacking& tray = packing.trays[i];
        const bool nearly_empty = 5 * tray.density < fullest;
        lines.row(fmt::format("{:>6}{:>13}{:>9.1f}{:>9}   {}{}", i + 1, tray.placements.size(), tray.height,
                              percent_text(tray.density), comes_apart(tray), nearly_empty ? ", nearly empty" : ""));
    }
    lines.blank();
}

void add_details(const PackResult& result, SummaryLines& lines) {
    const Packing& packing = result.packing;
    const Metrics& metrics = packing.metrics;
    const PhaseSeconds& s = metrics.seconds;
    lines.labelled("Phases",
                   fmt::format("reading {:.2f} s, voxels {:.2f} s, placing {:.2f} s, sliding together {:.2f} s, taking "
                               "apart {:.2f} s, putting back {:.2f} s",
                               s.load, s.voxelize, s.search, s.refine, s.disassemble, s.reinsert));
    lines.labelled("Work",
                   fmt::format("{} copies tried by {} on {} thread{}; {} at peak", metrics.searches, metrics.engine,
                               metrics.threads, metrics.threads == 1 ? "" : "s", bytes_text(metrics.peak_memory)));
    const InterlockCounts counts = metrics.interlock.value_or(InterlockCounts{});
    if (counts.removed > 0) {
        lines.labelled("Taken out", fmt::format("{} copies that could not leave; {} were put back, {} others came in",
                                                counts.removed, counts.reinserted, counts.added));
    }
}

SummaryLines summary_lines(const PackResult& result, const RunFacts& facts, const Room& room) {
    const Packing& packing = result.packing;
    SummaryLines lines;
    lines.sentence(verdict_text(result));
    lines.blank();
    lines.labelled("Tray", tray_text(packing, facts));
    if (newly_placed(packing) == 0) {
        lines.labelled("Left over", left_over_texts(packing, result.stopped, room.reason_lines));
        if (facts.details) add_details(result, lines);
        return lines;
    }
    const bool several = packing.trays.size() > 1;
    if (several) {
        add_trays(packing, room.trays, lines);
    } else {
        lines.labelled("Height", height_text(packing, facts));
        lines.labelled("Filled", filled_text(packing));
    }
    if (packing.options.fill) lines.labelled("Of each", shares_text(packing));
    if (packing.metrics.improvement) lines.labelled("Improved", improved_text(*packing.metrics.improvement));
    lines.labelled("Gap", gap_text(packing, facts.taken));
    lines.labelled("Left over", left_over_texts(packing, result.stopped, room.reason_lines));
    lines.labelled("Checked", checked_texts(packing, facts));
    lines.labelled("Written", written_text(facts, several));
    lines.labelled("Took", took_text(packing.metrics, facts.seconds.value_or(packing.metrics.seconds.total)));
    if (facts.details) add_details(result, lines);
    return lines;
}

}  // namespace

std::string summary_text(const PackResult& result, const RunFacts& facts) {
    SummaryLines lines;
    for (const Room& room : kRooms) {
        lines = summary_lines(result, facts, room);
        if (lines.count() <= kScreenLines) break;
    }
    const std::size_t left_over = result.packing.unplaced.size();
    if (facts.require_all && left_over > 0 && newly_placed(result.packing) > 0) {
        const bool more_trays = !what_takes_more(result.packing).empty();
        lines.blank();
        const bool by_file = !result.unusable.empty() && !facts.skip_unusable;
        lines.sentence(fmt::format("{} left over, and --require-all asks for all: exit {}.{}",
                                   left_over == 1 ? "1 copy is" : fmt::format("{} copies are", left_over),
                                   by_file ? fmt::format("{}, as a file cannot be used", int{kUnusableInput})
                                           : fmt::format("{}", int{kLeftOver}),
                                   more_trays ? " More trays take them: --trays all." : ""));
    }
    return lines.text();
}

std::string estimate_text(const Estimate& estimate, const PackOptions& options, const std::optional<ProbedTime>& time) {
    const bool open = options.open_height || options.minimise == Minimise::box;
    SummaryLines lines;
    lines.sentence(fmt::format("{} cop{} of {} part{} would be packed; nothing was written (--dry-run).",
                               estimate.copies, estimate.copies == 1 ? "y" : "ies", estimate.parts,
                               estimate.parts == 1 ? "" : "s"));
    lines.blank();
    lines.labelled("Tray", open ? fmt::format("{} x {} mm, without a ceiling", length_text(options.tray.x),
                                              length_text(options.tray.y))
                                : size_text(estimate.container));
    lines.labelled("Parts", fmt::format("{} of the tray; the boxes round them {}", percent_text(estimate.volume_ratio),
                                        percent_text(estimate.box_ratio)));
    if (estimate.left_over > 0) {
        lines.labelled("Left over",
                       fmt::format("{} cop{}: {}", estimate.left_over, estimate.left_over == 1 ? "y" : "ies",
                                   estimate.unusable.empty()    ? "too large"
                                   : estimate.too_large.empty() ? "their files cannot be used"
                                                                : "too large, or in files that cannot be used"));
    }
    std::vector<std::string> too_large;
    for (const std::string& part : estimate.too_large) {
        too_large.push_back(printable(part));
    }
    lines.labelled("Too large", too_large);
    if (!time) {
        lines.labelled("Time", "unknown: it cannot start with this memory");
    } else if (time->packed == 0) {
        lines.labelled(
            "Time", fmt::format("much more than {}: too few copies were tried by then", duration_text(time->seconds)));
    } else {
        lines.labelled("Time", fmt::format("about {} ({} of the copies were tried to see)",
                                           duration_text(time->seconds), percent_text(time->packed)));
    }
    lines.labelled("Memory", fmt::format("about {}, of {} {}", bytes_text(estimate.memory),
                                         bytes_text(estimate.memory_limit), options.memory > 0 ? "allowed" : "free"));
    lines.labelled("Voxels", fmt::format("{} x {} x {} of {} mm{}; {} way{} to stand", estimate.grid.x, estimate.grid.y,
                                         estimate.grid.z, length_text(estimate.voxel), open ? " to begin with" : "",
                                         estimate.orientations, estimate.orientations == 1 ? "" : "s"));
    return lines.text();
}

}  // namespace spectralpack::cli
