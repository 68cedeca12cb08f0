#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "paths.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct RenderArguments {
    std::string packing;
    std::string output;
    std::string size = "1600x1200";
    RenderOptions options;
    std::optional<int> tray;  // from 1
    int threads = 0;
};

int run_render(RenderArguments arguments) {
    parse_picture_size(arguments.size, arguments.options);
    require_picture(arguments.output);
    if (arguments.tray) {
        if (*arguments.tray < 1) throw UsageError(fmt::format("--tray {}: trays count from 1", *arguments.tray));
        arguments.options.tray = *arguments.tray - 1;
    }
    const Scene scene = load_scene(arguments.packing);
    write_picture(scene, arguments.output, arguments.options, arguments.threads);
    fmt::print("Written: {}\n", printable(arguments.output));
    return kDone;
}

}  // namespace

Command add_render_command(CLI::App& app) {
    auto* sub = app.add_subcommand("render", "Draw a picture of a packing");
    auto arguments = std::make_shared<RenderArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    sub->add_option("-o,--output", arguments->output, "picture to write (.png)")->required();
    sub->add_option("--size", arguments->size, "pixels [1600x1200]");
    sub->add_option("--azimuth", arguments->options.azimuth, "degrees that you look from the side [35]");
    sub->add_option("--elevation", arguments->options.elevation, "degrees that you look from above [28]");
    sub->add_option("--tray", arguments->tray, "only this tray, counted from 1 [all]");
    auto* explode = sub->add_option("--explode", arguments->options.explode,
                                    "draw copies apart along their ways out: 0.5 makes the tray half as long again")
                        ->type_name("FACTOR");
    sub->add_option("--step", arguments->options.step,
                    "draw step K of taking it apart, from 1 on: its copies half way out")
        ->type_name("K")
        ->excludes(explode);
    sub->add_option("--threads", arguments->threads, "threads, 0 for all");
    return {sub, [arguments] { return run_render(*arguments); }};
}

}  // namespace spectralpack::cli
