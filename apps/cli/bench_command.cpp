#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include <spectralpack/error.hpp>
#include <spectralpack/tools/bench.hpp>

#include "bench_display.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "number_options.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct BenchArguments {
    std::vector<std::string> peers;
    std::string folder, scale = "full";
    std::optional<std::string> sets;
    std::optional<int> threads;
    tools::BenchOptions options;
};

std::string all_tables() {
    std::string list;
    for (const std::string& name : tools::bench_tables()) {
        list += (list.empty() ? "" : ", ") + name;
    }
    return list;
}

tools::BenchScale scale_of(const std::string& word) {
    if (word == "quick") return tools::BenchScale::quick;
    if (word == "full") return tools::BenchScale::full;
    throw UsageError(fmt::format("--scale takes quick or full, not '{}'", printable(word)));
}

tools::BenchPeer peer_of(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || text.find("{out}") == std::string::npos) {
        throw UsageError("--peer takes NAME=COMMAND, and the command names {out}, the mesh file it leaves");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

int run_bench(const BenchArguments& arguments) {
    tools::BenchOptions options = arguments.options;
    options.program = std::filesystem::read_symlink("/proc/self/exe");
    options.folder = arguments.folder;
    options.scale = scale_of(arguments.scale);
    if (arguments.sets) options.sets = *arguments.sets;
    if (arguments.threads) options.pack_options = {"--threads", std::to_string(*arguments.threads)};
    for (const std::string& peer : arguments.peers) {
        options.peers.push_back(peer_of(peer));
    }
    const Interrupts interrupts(std::nullopt);
    BenchDisplay display;
    const tools::BenchSummary summary = tools::bench(options, display, interrupts.token());
    if (summary.stopped != StopReason::none) return kInterrupted;
    return summary.failed > 0 ? kCheckFailed : kDone;
}

}  // namespace

Command add_bench_command(CLI::App& app) {
    auto* sub = app.add_subcommand("bench", "Run the paper's tables");
    sub->footer(
        "1          keeping copies from locking: off, place, post\n"
        "2          continuous refinement off and on\n"
        "3          the large set: many trays, one large tray; time per phase and per copy\n"
        "4          beside other programs, those named with --peer; the paper's figures for programs that are sold\n"
        "5          orientations in steps of 90, 45 and 30 degrees\n"
        "order      orders, the best of several, beam search (Fig. 19)\n"
        "height     the height penalty (Fig. 12)\n"
        "letters    mixtures in the letters of SIGGRAPH (Fig. 14)\n"
        "tori       48 distorted tori (Fig. 22)\n"
        "polyhedra  80 and 77 of them at fine voxels, in steps of 30 degrees (Fig. 17)\n"
        "segments   13 and 12 pieces of two bodies in the least box (Fig. 16)\n"
        "all        all of these, which takes most of a day on two cores\n"
        "\n"
        "  spectralpack bench --table order --scale quick -o bench/\n"
        "  spectralpack bench --table 1 --table 2 --sets DATA/sets --mesh-dir DATA/meshes -o bench/\n"
        "  spectralpack bench --table 4 --peer 'pack3d=cd /tmp && pack3d {counted} && cp pack3d-*.stl {out}' -o bench/\n"
        "\n"
        "Each row packs twice: into a tray that overflows (its density tells which copies got in as well), and a fixed\n"
        "set, its height or trays to be as few as can be. Each run is a process of its own and is kept in DIR/runs as\n"
        "it ends: the same call goes on where it was cut off, and what has the same command, program and inputs is not\n"
        "run again. Writes DIR/table-NAME.md and .csv (and .svg where runs take long enough to see how time grows), and\n"
        "DIR/benchmarks.md with all of them; packings and logs stay in DIR/runs. The sets are generated with seed 0, or come from a folder with pieces.csv, mixtures.csv,\n"
        "locks.csv, tori.csv (or tori48.csv), large.csv (or sixthousand.csv), polyhedra.csv, bunny.csv,\n"
        "molecule.csv.\n"
        "Exit status: 0 done; 1 some run failed; 130 interrupted.");
    auto arguments = std::make_shared<BenchArguments>();
    BenchArguments& a = *arguments;
    sub->add_option("--table", a.options.tables, "which, repeatable: all, or " + all_tables())
        ->required()
        ->expected(1)
        ->take_all();
    sub->add_option("-o,--output", a.folder, "folder for tables, sets and runs")->required();
    sub->add_option("--rows", a.options.rows,
                    "only rows with this text in 'set, setting', repeatable: '2 mm', 'pieces, post'")
        ->expected(1)
        ->take_all();
    sub->add_option("--scale", a.scale, "full: the paper's sizes; quick: toys, to see that it works [full]");
    sub->add_option("--sets", a.sets, "folder of set files to use instead of generated ones");
    sub->add_option("--mesh-dir", a.options.mesh_dir, "folder that the paths in those set files start from");
    add_number(*sub, "time-limit", "SECONDS", kAboveZero, a.options.time_limit,
               "seconds for each run; what it has by then counts, marked as cut off");
    add_threads(*sub, a.threads, "threads of each run, 0 for all [0]");
    sub->add_option(
           "--peer", a.peers,
           "program for table 4, repeatable: NAME=COMMAND for a shell. {set}: the set file; {files}: every copy's\n"
           "mesh; {counted}: count and mesh, part by part; {tray}: like 480x245x200; {out}: the STL file to leave\n"
           "with all placed copies in it, which is measured")
        ->expected(1)
        ->take_all();
    return {sub, [arguments] { return run_bench(*arguments); }};
}

}  // namespace spectralpack::cli
