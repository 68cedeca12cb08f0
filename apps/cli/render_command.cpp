#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "paths.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

constexpr const char *kSize = "1600x1200", *kTallSize = "1600x2000";  // drawn apart, a tray is tall

struct RenderArguments {
    std::string packing;
    std::string output;
    std::string size;
    std::string section;
    bool plain = false;
    RenderOptions options;
    std::optional<int> tray;  // from 1
    int threads = 0;
};

/// "z=80".
Section parse_section(const std::string& text) {
    const auto wrong = [&] {
        return UsageError("--section " + text + ": an axis and a place on it in mm are wanted, like z=80");
    };
    if (text.size() < 3 || text[1] != '=') throw wrong();
    const std::size_t axis = std::string("xyz").find(text[0]);
    if (axis == std::string::npos) throw wrong();
    std::size_t end = 0;
    Section section{static_cast<int>(axis), 0};
    try {
        section.at = std::stod(text.substr(2), &end);
    } catch (const std::exception&) {
        throw wrong();
    }
    if (end + 2 != text.size()) throw wrong();
    return section;
}

int run_render(RenderArguments arguments) {
    RenderOptions& options = arguments.options;
    if (arguments.size.empty()) arguments.size = options.explode ? kTallSize : kSize;
    parse_picture_size(arguments.size, options);
    if (!arguments.section.empty()) options.section = parse_section(arguments.section);
    options.marks = options.numbers = !arguments.plain;
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
    sub->add_option("--size", arguments->size, "pixels [1600x1200; with --explode 1600x2000]");
    sub->add_option("--azimuth", arguments->options.azimuth, "degrees that you look from the side [35]");
    sub->add_option("--elevation", arguments->options.elevation, "degrees that you look from above [28]");
    sub->add_option("--tray", arguments->tray, "only this tray, counted from 1 [all]");
    auto* explode = sub->add_option("--explode", arguments->options.explode,
                                    "draw the tray's layers apart; at FACTOR 1 none hides the next")
                        ->type_name("FACTOR");
    sub->add_option("--section", arguments->section,
                    "look inside: cut away what lies before this plane, like z=80 (mm from the tray's corner)")
        ->type_name("AXIS=MM");
    sub->add_flag("--plain", arguments->plain, "without numbers, scale bar and the names of sides");
    sub->add_option("--step", arguments->options.step,
                    "draw step K of taking it apart, from 1 on: its copies half way out")
        ->type_name("K")
        ->excludes(explode);
    sub->add_option("--threads", arguments->threads, "threads, 0 for all")->check(CLI::Range(0, kMostThreads));
    return {sub, [arguments] { return run_render(*arguments); }};
}

}  // namespace spectralpack::cli
