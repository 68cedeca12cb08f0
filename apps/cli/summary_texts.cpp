#include "summary_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// Up to less than this share of the tray's height, how full it is up to there is worth saying.
constexpr double kLow = 0.95;
/// Print bureaus ask for this much between parts, or more.
constexpr double kCustomaryGap = 1;
constexpr std::size_t kMostShares = 6;
/// A build is no higher than it was where it grew by less, mm.
constexpr double kNoHigher = 0.05;
/// Of more files than this, the first and the last are named.
constexpr std::size_t kMostFiles = 4;

std::string copies_text(std::int64_t copies, const char* kind = "") {
    return fmt::format("{}{} cop{}", copies, kind, copies == 1 ? "y" : "ies");
}

std::string placed_text(std::int64_t placed, std::int64_t all, const char* kind) {
    if (placed == all) {
        return all == 1 ? fmt::format("The{} copy is placed", kind)
                        : fmt::format("All {} are placed", copies_text(all, kind));
    }
    return fmt::format("{} of {} {} placed", placed, copies_text(all, kind), placed == 1 ? "is" : "are");
}

std::string limit_text(double seconds) { return fmt::format("{:g} s", seconds); }

double fullest_layer(const Packing& packing) {
    const double base = packing.container.size.x * packing.container.size.y;
    double fullest = 0;
    for (const TrayPacking& tray : packing.trays) {
        for (const double area : tray.layers.area) {
            fullest = std::max(fullest, area / base);
        }
    }
    return fullest;
}

/// "side by side: a.3mf", "all: a.json".
void add_kind(const char* kind, const std::string& files, std::string& text) {
    if (files.empty()) return;
    text += (text.empty() ? "" : "; ") + (text.empty() && *kind == '\0' ? files : fmt::format("{}: {}", kind, files));
}

/// That a job has fixed.
bool has_copies_for_good(const Packing& packing) {
    const auto for_good = [](const Placement& copy) { return copy.fixed && !copy.before; };
    return std::ranges::any_of(packing.trays,
                               [&](const TrayPacking& tray) { return std::ranges::any_of(tray.placements, for_good); });
}

void add_file(const std::string& file, std::string& files) { files += (files.empty() ? "" : ", ") + printable(file); }

std::string as_in(const TakenOver& taken) {
    return ", as in " + printable(std::filesystem::path(taken.file).filename().string());
}

/// The packing file of this run; empty where none was written.
std::string packing_file(const RunFacts& facts) {
    for (const WrittenFile& written : facts.written) {
        if (std::filesystem::path(written.file).extension() == ".json") return printable(written.file);
    }
    return "";
}

}  // namespace

std::int64_t newly_placed(const Packing& packing) {
    std::int64_t fresh = 0;
    for (const TrayPacking& tray : packing.trays) {
        fresh += std::ranges::count(tray.placements, false, &Placement::fixed);
    }
    return fresh;
}

std::string size_text(const Vec3& size) {
    return fmt::format("{} x {} x {} mm", length_text(size.x), length_text(size.y), length_text(size.z));
}

std::string verdict_text(const PackResult& result) {
    const Packing& packing = result.packing;
    const std::int64_t fresh = newly_placed(packing), before = packing.metrics.placed - fresh;
    const std::int64_t all = packing.metrics.copies - before;
    std::string start;
    if (result.stopped == StopReason::cancelled) start = "Interrupted. ";
    if (result.stopped == StopReason::time_limit) {
        start = fmt::format("Time limit of {} reached. ", limit_text(packing.options.time_limit.value_or(0)));
    }
    if (fresh == 0) return start + "Nothing is placed, and nothing was written.";
    if (!start.empty()) start += "Best so far: ";
    const char* kind = before > 0 ? " new" : "";
    std::string text = placed_text(fresh, all, kind);
    if (packing.options.fill && start.empty() && packing.unplaced.empty()) {
        text = fmt::format("The tray is full: {}", copies_text(fresh, kind));
    }
    if (!start.empty()) text[0] = text[0] == 'A' ? 'a' : text[0] == 'T' ? 't' : text[0];
    if (packing.trays.size() > 1) text += fmt::format(", in {} trays", packing.trays.size());
    if (const auto left = static_cast<std::int64_t>(packing.unplaced.size()); left > 0 && start.empty()) {
        text += fmt::format("; {} {} left over", left, left == 1 ? "is" : "are");
    }
    if (before > 0) text += fmt::format("; {} stood there before", before);
    return start + text + ".";
}

std::string tray_text(const Packing& packing, const RunFacts& facts) {
    const Container& container = packing.container;
    std::string text;
    if (container.mesh) text = printable(std::filesystem::path(container.mesh->file).filename().string()) + ", ";
    const bool vessel = container.is == ContainerIs::vessel && container.mesh && container.mesh->surface;
    if (vessel) {
        text += size_text(bounding_box(*container.mesh->surface).size()) + " inside";
    } else if (container.open_height) {
        text +=
            fmt::format("{} x {} mm, without a ceiling", length_text(container.size.x), length_text(container.size.y));
    } else {
        text += size_text(container.size);
    }
    const Printer* printer =
        packing.options.printer ? find_printer(*packing.options.printer, facts.own_printers) : nullptr;
    if (printer && printer->size == container.size) text += ", " + printable(printer->title);
    if (facts.taken.container) text += as_in(facts.taken);
    if (!container.keep_out.empty()) {
        text += fmt::format(", {} keep-out{}", container.keep_out.size(), container.keep_out.size() == 1 ? "" : "s");
    }
    return text;
}

std::string height_text(const Packing& packing, const RunFacts& facts) {
    const double height = packing.trays.front().height;
    std::string text = fmt::format("{:.1f} mm", height);
    if (!packing.container.open_height) text += fmt::format(" of {}", length_text(packing.container.size.z));
    const bool before = facts.onto_height && std::abs(height - *facts.onto_height) < kNoHigher;
    return before ? text + ", as before" : text;
}

std::string filled_text(const Packing& packing) {
    const TrayPacking& tray = packing.trays.front();
    const Container& container = packing.container;
    const PackOptions& options = packing.options;
    if (container.open_height) return percent_text(tray.density) + " up to that height";
    std::string text = fmt::format("{} of the {}", percent_text(tray.density), container.mesh ? "container" : "tray");
    if (options.max_density) text += fmt::format(" (at most {})", percent_text(*options.max_density));
    if (!container.mesh && tray.height > 0 && tray.height < kLow * container.size.z) {
        text += fmt::format("; {} up to that height", percent_text(tray.density * container.size.z / tray.height));
    }
    if (options.max_layer_fill) {
        text += fmt::format("; the fullest layer {} (at most {})", percent_text(fullest_layer(packing)),
                            percent_text(*options.max_layer_fill));
    }
    return text;
}

std::string shares_text(const Packing& packing) {
    std::vector<const PackedPart*> parts;
    for (const PackedPart& part : packing.parts) {
        if (part.share > 0) parts.push_back(&part);
    }
    const auto rounds = [](const PackedPart* part) { return static_cast<double>(part->count) / part->share; };
    const auto [least, most] = std::ranges::minmax(parts, {}, rounds);
    std::string names, came, asked;
    const std::size_t shown = std::min(parts.size(), kMostShares);
    for (std::size_t i = 0; i < shown; ++i) {
        const PackedPart& part = *parts[i];
        names += fmt::format("{}{}{}{}", i > 0 ? ", " : "", part.count, kBond, printable(part.name));
        const char* separator = i > 0 ? " : " : "";
        came += fmt::format("{}{:g}", separator, std::round(10 * part.count / std::max(1.0, rounds(least))) / 10);
        asked += fmt::format("{}{}", separator, part.share);
    }
    if (parts.size() > shown) names += fmt::format(" and {} more parts", parts.size() - shown);
    if (parts.size() < 2 || parts.size() > shown) return names;
    std::string text = fmt::format("{}: {} for the {} asked", names, came, asked);
    // Where a whole round is missing, the part that stopped it.
    if (rounds(most) - rounds(least) >= 1) {
        text += fmt::format(", as no further {} found a free place", printable(least->name));
    }
    return text;
}

std::string gap_text(const Packing& packing, const TakenOver& taken) {
    const PackOptions& options = packing.options;
    std::string note;
    if (options.gap < kCustomaryGap && !options.printer && !taken.gap) {
        note = fmt::format(" ({}print bureaus ask for 1 mm or more)",
                           options.gap == PackOptions{}.gap ? "the default; " : "");
    }
    const auto own =
        std::ranges::count_if(packing.parts, [&](const PackedPart& part) { return part.gap != options.gap; });
    const std::string of_parts = own > 0 ? fmt::format(", {} part{} with its own", own, own == 1 ? "" : "s") : "";
    return fmt::format("{} mm between copies{}{}{}, {} mm to the walls{}", gap_number(options.gap), note, of_parts,
                       taken.gap && !taken.wall_gap ? as_in(taken) : "", gap_number(options.wall_gap),
                       taken.wall_gap ? as_in(taken) : "");
}

std::vector<std::string> checked_texts(const Packing& packing, const RunFacts& facts) {
    const PlansOverview plans = plans_of(packing);
    const Metrics& metrics = packing.metrics;
    std::string text;
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    if (metrics.min_gap) add(fmt::format("no two copies nearer than {:.2f} mm", *metrics.min_gap));
    if (metrics.verified > 0) {
        add(fmt::format("{} gave the same {} placements", to_string(packing.options.verify_with->engine),
                        metrics.verified));
    }
    if (plans.planned && plans.complete) {
        const std::int64_t fresh = newly_placed(packing);
        if (plans.staying > 0 || has_copies_for_good(packing)) {
            add(fmt::format("{} {} apart{}{}", copies_text(fresh, " new"), fresh == 1 ? "comes" : "come",
                            through_walls_text(plans.through_walls), staying_text(plans.staying)));
        } else if (packing.trays.size() == 1) {
            add(fmt::format("comes apart in {} step{}{}", plans.steps, plans.steps == 1 ? "" : "s",
                            through_walls_text(plans.through_walls)));
        } else if (plans.through_walls > 0) {
            add(fmt::format("each tray comes apart, in {} steps together{}", plans.steps,
                            through_walls_text(plans.through_walls)));
        } else if (text.empty()) {
            add("comes apart");
        }
        return {text};
    }
    const std::string file = packing_file(facts);
    const std::string plan =
        file.empty() ? "'spectralpack plan' on its .json file" : fmt::format("'spectralpack plan {0} -o {0}'", file);
    const char* how_far = plans.steps > 0 ? "ONLY PARTLY CHECKED" : "NOT CHECKED";
    std::vector<std::string> texts;
    if (!text.empty()) texts.push_back(text);
    texts.push_back(fmt::format("{} whether it comes apart: do not print it before {} has said so", how_far, plan));
    return texts;
}

std::string written_text(const RunFacts& facts, bool several_trays) {
    if (facts.written.empty() && facts.reports.empty())
        return facts.files_named ? "nothing" : "nothing: name files with -o";
    std::string single, side_by_side, all, text;
    for (const WrittenFile& written : facts.written) {
        if (!several_trays) {
            add_file(written.file, single);
            continue;
        }
        const std::size_t count = written.trays.size();
        if (count > kMostFiles) {
            add_file(fmt::format("{} to {}", written.trays.front(), written.trays.back()), single);
        } else {
            for (const std::string& tray : written.trays) {
                add_file(tray, single);
            }
        }
        const std::string ending = std::filesystem::path(written.file).extension().string();
        add_file(written.file, ending == ".json" || ending == ".csv" ? all : side_by_side);
    }
    for (const std::string& report : facts.reports) {
        add_file(report, several_trays ? all : single);
    }
    add_kind("", single, text);
    add_kind("side by side", side_by_side, text);
    add_kind("all", all, text);
    return text;
}

namespace {

/// "5 trays, the last 4.3 % full".
std::string trays_text(double trays) {
    const double whole = std::floor(trays);
    return fmt::format("{:.0f} trays, the last {} full", whole + 1, percent_text(trays - whole));
}

}  // namespace

std::string progress_text(const Improved& improved) {
    const double gain = improved.now - improved.before;
    switch (improved.what) {
        case Improves::height:
            return fmt::format("{:.1f} mm high, {:.1f} mm lower than at first", improved.now, -gain);
        case Improves::density:
            return fmt::format("{} filled, {:.1f} points more than at first", percent_text(improved.now), 100 * gain);
        case Improves::copies:
            return fmt::format("{} copies, {} more than at first", improved.now, gain);
        case Improves::value:
            return fmt::format("worth {:g}, {:g} more than at first", improved.now, gain);
        case Improves::trays:
            return trays_text(improved.now) + ", at first " + trays_text(improved.before);
        case Improves::box:
            return fmt::format("box {} smaller than at first", percent_text(1 - improved.now / improved.before));
    }
    return "";
}

std::string improved_text(const Improved& improved) {
    const std::string orders = fmt::format("{} order{} tried", improved.steps, improved.steps == 1 ? "" : "s");
    const double gain = improved.now - improved.before;
    if (gain == 0) return "nothing better was found; " + orders;
    switch (improved.what) {
        case Improves::height:
            return fmt::format("{:.1f} mm lower than at first ({:.1f} mm); {}", -gain, improved.before, orders);
        case Improves::density:
            return fmt::format("{:.1f} points fuller than at first ({}); {}", 100 * gain, percent_text(improved.before),
                               orders);
        case Improves::copies:
            return fmt::format("{} copies more than at first ({}); {}", gain, improved.before, orders);
        case Improves::value:
            return fmt::format("worth {:g} more than at first ({:g}); {}", gain, improved.before, orders);
        case Improves::trays:
            return fmt::format("{}, at first {}; {}", trays_text(improved.now), trays_text(improved.before), orders);
        case Improves::box:
            return fmt::format("a box {} smaller than at first; {}", percent_text(1 - improved.now / improved.before),
                               orders);
    }
    return "";
}

std::string took_text(const Metrics& metrics, double seconds) {
    const std::string orders = metrics.orders > 1 ? fmt::format("; the best of {} orders", metrics.orders) : "";
    return duration_text(seconds) + orders;
}

}  // namespace spectralpack::cli
