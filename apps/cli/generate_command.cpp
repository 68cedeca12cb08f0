#include <fmt/format.h>

#include <memory>
#include <optional>

#include <spectralpack/error.hpp>
#include <spectralpack/tools/generate.hpp>

#include "commands.hpp"
#include "exit_status.hpp"
#include "number_options.hpp"
#include "progress_display.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct GenerateArguments {
    std::string set, file;
    std::string folder;
    std::string tray = "480x245x200", unit = "mm";
    tools::GenerateOptions options;
    tools::SegmentOptions segments;
};

/// mm^3; what a set comes to is said as a share of the paper's tray.
constexpr double kTray = 480.0 * 245 * 200;

tools::GeneratedSet set_of(const std::string& name) {
    if (const auto set = from_string<tools::GeneratedSet>(name)) return *set;
    throw UsageError(fmt::format("there is no set '{}'; one of {}", printable(name),
                                 fmt::join(words_of<tools::GeneratedSet>(), ", ")));
}

int run_generate(GenerateArguments arguments, bool says_cut) {
    arguments.options.set = set_of(arguments.set);
    if (!arguments.file.empty() && arguments.options.set != tools::GeneratedSet::segments) {
        throw UsageError(fmt::format("{} are made from nothing: only segments take a file", arguments.set));
    }
    if (arguments.file.empty() && says_cut) {
        throw UsageError("--tray, --pieces and --unit say how 'generate segments FILE' cuts the file's mesh");
    }
    if (!arguments.file.empty() && arguments.options.copies) {
        throw UsageError(
            "--count is of the sets that are made from nothing; --pieces says how many a file is cut into");
    }
    ProgressDisplay display(ProgressStyle::automatic);
    tools::GeneratedFiles files;
    if (arguments.file.empty()) {
        files = tools::generate(arguments.options, arguments.folder, {&display});
    } else {
        arguments.segments.tray = parse_size(arguments.tray, "--tray");
        arguments.segments.unit = parse_unit(arguments.unit);
        arguments.segments.seed = arguments.options.seed;
        files = tools::generate_segments(arguments.file, arguments.segments, arguments.folder, {&display});
    }
    display.finish();
    if (!arguments.file.empty()) {
        fmt::print("Written: {}: {} piece{}, {:.4g} cm3\n", files.set_file.string(), files.meshes,
                   files.meshes == 1 ? "" : "s", files.volume / 1000);
        return kDone;
    }
    fmt::print("Written: {}: {} cop{} of {} mesh{}, {:.0f} cm3, boxes {:.0f} cm3", files.set_file.string(),
               files.copies, files.copies == 1 ? "y" : "ies", files.meshes, files.meshes == 1 ? "" : "es",
               files.volume / 1000, files.box_volume / 1000);
    if (arguments.options.set == tools::GeneratedSet::letters) {
        fmt::print("\nUse one like: spectralpack pack parts/ --container {}\n",
                   (std::filesystem::path(arguments.folder) / "letter-S.stl").string());
    } else if (arguments.options.set == tools::GeneratedSet::segments) {
        fmt::print("\n");
    } else {
        fmt::print(" ({:.3f} and {:.3f} of a tray of 480x245x200 mm)\n", files.volume / kTray,
                   files.box_volume / kTray);
    }
    return kDone;
}

}  // namespace

Command add_generate_command(CLI::App& app) {
    auto* sub = app.add_subcommand("generate", "Make sets of parts to try packing with, or cut up a large one");
    sub->footer(
        "pieces     many small and medium parts, each several times\n"
        "mixtures   large, mostly hollow parts and small, mostly solid ones\n"
        "locks      rings, links, hooks, frames, cages: what catches in one another\n"
        "tori       distorted rings\n"
        "polyhedra  solids of a few large faces, convex and not\n"
        "letters    S, I, G, R, A, P, H as containers of 322x322x80 mm\n"
        "segments   a bunny-like body in 13 pieces, a molecule-like one in 12; bunny.csv and molecule.csv name those of\n"
        "           one body\n"
        "The same seed makes the same files on every machine.\n"
        "\n"
        "  spectralpack generate segments statue.stl --tray 150x150x120 -o pieces/\n"
        "\n"
        "cuts a closed mesh by planes into closed pieces that fit the tray, each where it lay in the whole; what fits\n"
        "stays whole. A mesh that is not closed is not cut (exit status 3).");
    auto arguments = std::make_shared<GenerateArguments>();
    GenerateArguments& a = *arguments;
    sub->add_option("SET", a.set, "pieces, mixtures, locks, tori, polyhedra, letters or segments")->required();
    sub->add_option("FILE", a.file, "segments: mesh to cut instead of making one");
    sub->add_option("-o,--output", a.folder, "folder for the STL files and SET.csv")->required();
    add_number(*sub, "seed", "N", kFromZero, a.options.seed, "which set of its kind [0]");
    add_number(*sub, "count", "N", kFromOne, a.options.copies, "copies in all [1446, 286, 468, 48, 80]");
    const auto* tray = sub->add_option("--tray", a.tray, "what every piece of FILE has to fit into, mm [480x245x200]");
    const auto* pieces = add_number(*sub, "pieces", "N", kFromOne, a.segments.pieces,
                                    "of FILE, at least; more where the tray demands it [1]");
    const auto* unit = sub->add_option("--unit", a.unit, "unit of a FILE that does not say: mm, inch, m [mm]");
    return {sub, [arguments, tray, pieces, unit] {
                return run_generate(*arguments, tray->count() + pieces->count() + unit->count() > 0);
            }};
}

}  // namespace spectralpack::cli
