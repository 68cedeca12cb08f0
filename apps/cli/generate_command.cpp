#include <fmt/format.h>

#include <memory>

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
    std::string set;
    std::string folder;
    tools::GenerateOptions options;
};

/// mm^3; what a set comes to is said as a share of the paper's tray.
constexpr double kTray = 480.0 * 245 * 200;

tools::GeneratedSet set_of(const std::string& name) {
    if (const auto set = from_string<tools::GeneratedSet>(name)) return *set;
    throw UsageError(fmt::format("there is no set '{}'; one of {}", printable(name),
                                 fmt::join(words_of<tools::GeneratedSet>(), ", ")));
}

int run_generate(GenerateArguments arguments) {
    arguments.options.set = set_of(arguments.set);
    ProgressDisplay display(ProgressStyle::automatic);
    const tools::GeneratedFiles files = tools::generate(arguments.options, arguments.folder, {&display});
    display.finish();
    fmt::print("Written: {}: {} cop{} of {} mesh{}, {:.0f} cm3, boxes {:.0f} cm3", files.set_file.string(),
               files.copies, files.copies == 1 ? "y" : "ies", files.meshes, files.meshes == 1 ? "" : "es",
               files.volume / 1000, files.box_volume / 1000);
    if (arguments.options.set == tools::GeneratedSet::letters) {
        fmt::print("\nUse one like: spectralpack pack parts/ --container {}\n",
                   (std::filesystem::path(arguments.folder) / "letter-S.stl").string());
    } else {
        fmt::print(" ({:.3f} and {:.3f} of a tray of 480x245x200 mm)\n", files.volume / kTray,
                   files.box_volume / kTray);
    }
    return kDone;
}

}  // namespace

Command add_generate_command(CLI::App& app) {
    auto* sub = app.add_subcommand("generate", "Make sets of parts to try packing with");
    sub->footer(
        "pieces     many small and medium parts, each several times\n"
        "mixtures   large, mostly hollow parts and small, mostly solid ones\n"
        "locks      rings, links, hooks, frames, cages: what catches in one another\n"
        "tori       distorted rings\n"
        "polyhedra  solids of a few large faces, convex and not\n"
        "letters    S, I, G, R, A, P, H as containers of 322x322x80 mm\n"
        "The same seed makes the same files on every machine.");
    auto arguments = std::make_shared<GenerateArguments>();
    GenerateArguments& a = *arguments;
    sub->add_option("SET", a.set, "pieces, mixtures, locks, tori, polyhedra or letters")->required();
    sub->add_option("-o,--output", a.folder, "folder for the STL files and SET.csv")->required();
    add_number(*sub, "seed", "N", kFromZero, a.options.seed, "which set of its kind [0]");
    add_number(*sub, "count", "N", kFromOne, a.options.copies, "copies in all [1446, 286, 468, 48, 80]");
    return {sub, [arguments] { return run_generate(*arguments); }};
}

}  // namespace spectralpack::cli
