#include "tools/bench/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "core/atomic_file.hpp"
#include "tools/bench/plot.hpp"
#include "tools/bench/quoted.hpp"

namespace spectralpack::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDash = "–";
constexpr std::size_t kLeastPoints = 10;  // of a curve

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

std::string copies_text(const Outcome& o) {
    std::string text = o.placed > 0 ? fmt::format("{} / {}", o.placed, o.copies) : fmt::format("? / {}", o.copies);
    if (o.interlocked > 0) text += fmt::format(" ({} interlocked)", o.interlocked);
    return text + (o.cut_off ? ", cut off" : "");
}

std::string seconds_text(const Outcome& o) { return fmt::format("{:.1f} ({:.1f})", o.seconds, o.cpu_seconds); }

/// Shares of the run's time.
std::string phases_text(const Outcome& o) {
    const auto share = [&](double seconds) {
        return fmt::format("{:.0f}", o.seconds > 0 ? 100 * seconds / o.seconds : 0);
    };
    return fmt::format("{} / {} / {} / {} / {} / {}", share(o.load), share(o.voxelize), share(o.search),
                       share(o.refine), share(o.disassemble), share(o.reinsert));
}

void add_words(std::vector<std::string>& cells, const std::vector<std::string>& more) {
    cells.insert(cells.end(), more.begin(), more.end());
}

std::string line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) {
        text += " " + (cell.empty() ? kDash : cell) + " |";
    }
    return text + "\n";
}

/// What the fixed set came to.
std::string fixed_text(const Outcome& o) {
    return o.trays == 1 ? fmt::format("{:.1f} mm", o.height)
                        : fmt::format("{} trays, last {:.1f} mm", o.trays, o.height);
}

/// The volume of its box, and how long a copy took.
std::vector<std::string> box_texts(const Outcome& o) {
    return {fmt::format("{:.2f}·10⁵ mm³", o.box_volume / 1e5),
            o.placed > 0 ? fmt::format("{:.2f}", o.seconds / static_cast<double>(o.placed)) : ""};
}

/// Milliseconds a copy, in the middle of what was placed since the point before.
Curve curve_of(const std::string& name, const Outcome& outcome) {
    Curve curve{name, {}};
    for (std::size_t i = 1; i < outcome.trace.size(); ++i) {
        const auto& [copies, seconds] = outcome.trace[i];
        const auto& [before, earlier] = outcome.trace[i - 1];
        if (seconds <= earlier) continue;
        curve.points.emplace_back(static_cast<double>(copies + before) / 2,
                                  1000 * (seconds - earlier) / static_cast<double>(copies - before));
    }
    return curve;
}

std::string csv(const std::vector<RanRow>& rows) {
    std::string text =
        "set,setting,kind,copies,placed,interlocked,planned,cut_off,trays,density,density_own_box,box_volume,height,"
        "seconds,cpu_seconds,busy,load,voxelize,search,refine,disassemble,reinsert,peak_memory,program,commit,"
        "machine,date,command\n";
    for (const RanRow& ran : rows) {
        for (const auto* outcome : {&ran.tray, &ran.fixed}) {
            if (!*outcome) continue;
            const Outcome& o = **outcome;
            text += fmt::format(
                "{},{},{},{},{},{},{:d},{:d},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                quoted(ran.row.set), quoted(ran.row.setting), outcome == &ran.tray ? "tray" : "fixed", o.copies,
                o.placed, o.interlocked, o.planned, o.cut_off, o.trays, o.density, o.own_box, o.box_volume, o.height,
                o.seconds, o.cpu_seconds, o.busy, o.load, o.voxelize, o.search, o.refine, o.disassemble, o.reinsert,
                o.peak_memory, quoted(o.program), quoted(o.commit), quoted(o.machine), o.date, quoted(o.command));
        }
    }
    return text;
}

}  // namespace

std::string markdown(const Table& table, const std::vector<RanRow>& rows) {
    std::string text = "# " + table.title + "\n\n";
    if (!table.note.empty()) text += table.note + "\n\n";
    std::vector<std::string> head{"set",
                                  "setting",
                                  "tray: placed",
                                  "density",
                                  "of its own box",
                                  "seconds (processor)",
                                  "fixed set: placed",
                                  "height or trays",
                                  "density",
                                  "seconds (processor)",
                                  "the paper"};
    const std::string phases = "load / voxels / search / refine / plan / put back, %";
    if (table.phases) add_words(head, {"tray: " + phases, "fixed: " + phases});
    if (table.boxes) add_words(head, {"box", "seconds a copy"});
    text += line(head) + line(std::vector<std::string>(head.size(), "---"));
    std::map<std::string, std::pair<double, double>> stamps;  // and the least and most load
    std::string commands;
    for (const RanRow& ran : rows) {
        std::vector<std::string> cells{ran.row.set, ran.row.setting};
        if (const auto& o = ran.tray) {
            add_words(cells, {copies_text(*o), percent(o->density), percent(o->own_box), seconds_text(*o)});
        } else {
            add_words(cells, {"", "", "", ""});
        }
        if (const auto& o = ran.fixed) {
            add_words(cells, {copies_text(*o), fixed_text(*o), percent(o->trays == 1 ? o->own_box : o->density),
                              seconds_text(*o)});
        } else {
            add_words(cells, {"", "", "", ""});
        }
        cells.push_back(ran.row.paper);
        if (table.phases) {
            add_words(cells, {ran.tray ? phases_text(*ran.tray) : "", ran.fixed ? phases_text(*ran.fixed) : ""});
        }
        if (table.boxes) add_words(cells, ran.fixed ? box_texts(*ran.fixed) : std::vector<std::string>{"", ""});
        text += line(cells);
        for (const auto* outcome : {&ran.tray, &ran.fixed}) {
            if (!*outcome) continue;
            const Outcome& o = **outcome;
            commands += o.command + "\n";
            const std::string stamp = fmt::format("{}, commit {}, {}, on {}", o.program, o.commit, o.date, o.machine);
            auto& [least, most] = stamps.try_emplace(stamp, o.busy, o.busy).first->second;
            least = std::min(least, o.busy);
            most = std::max(most, o.busy);
        }
    }
    text +=
        "\nThe paper's figures are for its own sets. A fixed set of one tray has the density of its own box. Made with:\n\n";
    for (const auto& [stamp, load] : stamps) {
        text += fmt::format("- {}, load {:.1f} to {:.1f} as runs began\n", stamp, load.first, load.second);
    }
    return text + "\nRow by row, the tray before the fixed set:\n\n```\n" + commands + "```\n";
}

void write_table(const Table& table, const std::vector<RanRow>& rows, const fs::path& folder) {
    replace_file(folder / ("table-" + table.name + ".md"), markdown(table, rows));
    replace_file(folder / ("table-" + table.name + ".csv"), csv(rows));
    std::vector<Curve> curves;
    for (const RanRow& ran : rows) {
        for (const auto* outcome : {&ran.tray, &ran.fixed}) {
            if (!*outcome) continue;
            const std::string kind = outcome == &ran.tray ? "tray" : "fixed";
            Curve curve = curve_of(fmt::format("{}, {}, {}", ran.row.set, ran.row.setting, kind), **outcome);
            if (curve.points.size() >= kLeastPoints) curves.push_back(std::move(curve));
        }
    }
    const std::string plot = svg_plot(curves, "copies placed", "ms a copy");
    if (!plot.empty()) replace_file(folder / ("table-" + table.name + ".svg"), plot);
}

void write_all_tables(const fs::path& folder) {
    std::string text;
    for (const std::string& name : bench_tables()) {
        const std::string stem = "table-" + name;
        std::ifstream table(folder / (stem + ".md"));
        if (!table) continue;
        text += std::string(std::istreambuf_iterator<char>(table), {}) + "\n";
        if (fs::exists(folder / (stem + ".svg"))) {
            text += fmt::format("![Milliseconds a copy against copies placed]({}.svg)\n\n", stem);
        }
    }
    replace_file(folder / "benchmarks.md", text);
}

}  // namespace spectralpack::tools
