#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "number_options.hpp"
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
    Section section{static_cast<int>(axis), 0};
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data() + 2, end, section.at);
    if (parsed.ec != std::errc{} || parsed.ptr != end || !std::isfinite(section.at)) throw wrong();
    return section;
}

int run_render(RenderArguments arguments) {
    RenderOptions& options = arguments.options;
    if (arguments.size.empty()) arguments.size = options.explode ? kTallSize : kSize;
    parse_picture_size(arguments.size, options);
    if (!arguments.section.empty()) options.section = parse_section(arguments.section);
    options.marks = options.numbers = !arguments.plain;
    require_picture(arguments.output);
    if (arguments.tray) options.tray = *arguments.tray - 1;
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
    RenderOptions& options = arguments->options;
    add_number(*sub, "azimuth", "DEGREES", kAnyNumber, options.azimuth, "degrees that you look from the side [35]");
    add_number(*sub, "elevation", "DEGREES", {-90, 90}, options.elevation, "degrees that you look from above [28]");
    add_number(*sub, "tray", "N", kFromOne, arguments->tray, "only this tray, counted from 1 [all]");
    auto* explode = add_number(*sub, "explode", "FACTOR", kFromZero, options.explode,
                               "draw the tray's layers apart; at FACTOR 1 none hides the next");
    sub->add_option("--section", arguments->section,
                    "look inside: cut away what lies before this plane, like z=80 (mm from the tray's corner)")
        ->type_name("AXIS=MM");
    sub->add_flag("--plain", arguments->plain, "without numbers, scale bar and the names of sides");
    add_number(*sub, "step", "K", {0, kFromOne.most}, options.step,
               "draw step K of taking it apart, from 1 on: its copies half way out")
        ->excludes(explode);
    add_threads(*sub, arguments->threads);
    return {sub, [arguments] { return run_render(*arguments); }};
}

}  // namespace spectralpack::cli
