#include <fmt/format.h>

#include <memory>

#include <spectralpack/tools/prepare.hpp>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "number_options.hpp"
#include "progress_display.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct PrepareArguments {
    std::string folder, output;
    std::string tray = "480x245x200";
    std::string unit = "mm";
    tools::PrepareOptions options;
};

int run_prepare(PrepareArguments arguments) {
    arguments.options.rules.tray = parse_size(arguments.tray, "--tray");
    arguments.options.unit = parse_unit(arguments.unit);
    const Interrupts interrupts(std::nullopt);
    ProgressDisplay display(ProgressStyle::automatic);
    const tools::PrepareSummary summary =
        tools::prepare(arguments.folder, arguments.output, arguments.options, {&display, interrupts.token()});
    display.finish();

    const auto kept = summary.meshes.find(tools::Prepared::kept);
    const std::int64_t meshes = kept == summary.meshes.end() ? 0 : kept->second;
    fmt::print("{} of {} files were looked at, {} mesh{} kept", summary.done, summary.files, meshes,
               meshes == 1 ? " is" : "es are");
    if (summary.earlier > 0) fmt::print(" ({} by earlier runs)", summary.earlier);
    fmt::print("\n");
    for (const auto& [outcome, count] : summary.meshes) {
        fmt::print("  {:<14} {}\n", to_string(outcome), count);
    }
    fmt::print("Written: {} and {}\n", summary.set_file.string(), summary.report_file.string());
    if (summary.stopped == StopReason::none) return kDone;
    fmt::print("Interrupted: the same command goes on from here.\n");
    return kInterrupted;
}

}  // namespace

Command add_prepare_command(CLI::App& app) {
    auto* sub = app.add_subcommand("prepare", "Make a benchmark of a folder of meshes");
    sub->footer(
        "Keeps the meshes that are closed and sound once what is safe to mend is mended, and have a volume;\n"
        "simplifies them, scales them down to the tray or up to 2 mm, and writes STL files,\n"
        "set.csv with all of them, and report.csv with what became of every mesh (the paper's appendix B.1).\n"
        "A run that was cut off goes on where it stopped.");
    auto arguments = std::make_shared<PrepareArguments>();
    PrepareArguments& a = *arguments;
    sub->add_option("FOLDER", a.folder, "folder of meshes, and the folders in it")->required();
    sub->add_option("-o,--output", a.output, "folder for the results")->required();
    sub->add_option("--tray", a.tray, "what is larger is scaled down to this, mm [480x245x200]");
    add_number(*sub, "triangles", "N", kFromZero, a.options.rules.triangles, "meshes of more are simplified [4000]");
    sub->add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]");
    add_threads(*sub, a.options.threads);
    return {sub, [arguments] { return run_prepare(*arguments); }};
}

}  // namespace spectralpack::cli
