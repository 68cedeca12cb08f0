#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include <spectralpack/spectralpack.hpp>
#include <spectralpack/tools/inspect.hpp>

#include "commands.hpp"
#include "exit_status.hpp"
#include "number_options.hpp"
#include "passed_over.hpp"
#include "paths.hpp"
#include "progress_display.hpp"
#include "tell.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct InspectArguments {
    std::vector<std::string> meshes;
    std::string unit = "mm";
    std::string picture;
    std::string size = "1600x1200";
    bool json = false;
    int threads = 0;
};

/// Holes that people are told of one by one; JSON has more.
constexpr std::size_t kMostHoles = 4;

std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string place_text(const Vec3& p) {
    return fmt::format("({}, {}, {})", length_text(p.x), length_text(p.y), length_text(p.z));
}

std::string place_text(const std::optional<Vec3>& place) { return place ? ", one at " + place_text(*place) : ""; }

void row(const char* what, const std::string& value) { fmt::print("  {:<16} {}\n", what, value); }

std::string watertight_text(const MeshFigures& figures) {
    if (figures.watertight()) return "yes";
    if (figures.edges.border == 0) return "no: neighbouring facets face opposite ways";
    return fmt::format("no: {} in {}", counted(figures.edges.border, "border edge", "border edges"),
                       counted(figures.border_loops, "loop", "loops"));
}

void print_holes(const MeshFigures& figures) {
    const std::size_t shown = std::min(figures.holes.size(), kMostHoles);
    for (std::size_t i = 0; i < shown; ++i) {
        const BorderLoop& hole = figures.holes[i];
        row("", fmt::format("hole of {}, {:.6g} mm round, at {}", counted(hole.edges, "edge", "edges"), hole.length,
                            place_text(hole.place)));
    }
    if (figures.border_loops > shown) {
        row("", fmt::format("and {} shorter", counted(figures.border_loops - shown, "loop", "loops")));
    }
}

std::string facing_text(const tools::InspectedObject& object) {
    switch (object.facing) {
        case tools::Facing::outward:
            return "outward";
        case tools::Facing::turned:
            return "outward, after turning facets on loading";
        case tools::Facing::inconsistent:
            break;
    }
    const EdgeCount& edges = object.figures.edges;
    return fmt::format("inconsistent at {}{}", counted(edges.misdirected, "edge", "edges"),
                       place_text(object.figures.misdirected_place));
}

std::string crossing_text(const SelfCrossings& crossings) {
    const std::string more = crossings.complete ? "" : "at least ";
    if (crossings.pairs == 0) return crossings.complete ? "no" : "none found, but not looked for to the end";
    return more +
           counted(static_cast<std::size_t>(crossings.pairs), "pair of facets crosses", "pairs of facets cross") +
           place_text(crossings.place);
}

void print_object(const tools::InspectedObject& object) {
    const MeshFigures& figures = object.figures;
    const Vec3 size = figures.box.size();
    row("size", fmt::format("{:.6g} x {:.6g} x {:.6g} mm", size.x, size.y, size.z));
    row("volume", fmt::format("{:.6g} mm3", figures.volume));
    row("area", fmt::format("{:.6g} mm2", figures.area));
    row("mesh",
        fmt::format("{}, {}, {}", counted(figures.triangles, "facet", "facets"),
                    counted(figures.vertices, "vertex", "vertices"), counted(figures.shells, "body", "bodies")));
    row("closed", watertight_text(figures));
    print_holes(figures);
    row("facets face", facing_text(object));
    row("shared edges", figures.edges.crowded == 0
                            ? "none of more than two facets"
                            : counted(figures.edges.crowded, "edge", "edges") + " of more than two facets" +
                                  place_text(figures.crowded_place));
    row("crosses itself", crossing_text(figures.crossings));
    row("duplicates", figures.duplicates == 0 ? "none" : counted(figures.duplicates, "facet", "facets"));
    if (object.unit_known) row("unit", fmt::format("{:g} mm, by the file", object.unit));
    if (object.unit_hint) row("unit", "perhaps wrong: it " + *object.unit_hint);
    for (const std::string& repair : object.repairs) {
        row("mended", printable(repair));
    }
    for (const std::string& warning : object.warnings) {
        row("remark", printable("it " + warning));
    }
}

void print_file(const tools::InspectedFile& file) {
    const std::string name = printable(file.file);
    if (file.unusable) {
        const std::string& place = file.unusable->place();
        fmt::print("{}\n", name);
        row("CANNOT BE USED",
            printable(place.empty() ? file.unusable->cause() : place + ": " + file.unusable->cause()));
        return;
    }
    for (const tools::InspectedObject& object : file.objects) {
        std::string heading = name;
        if (object.object) heading += fmt::format(": object {} '{}'", *object.object, object.name);
        if (object.instances > 1) heading += fmt::format(", {} times", object.instances);
        fmt::print("{}\n", printable(heading));
        print_object(object);
    }
}

int run_inspect(const InspectArguments& arguments) {
    tools::InspectOptions options;
    options.unit = parse_unit(arguments.unit);
    options.threads = arguments.threads;
    options.keep_meshes = !arguments.picture.empty();
    RenderOptions picture;
    parse_picture_size(arguments.size, picture);
    if (options.keep_meshes) require_picture(arguments.picture);
    ProgressDisplay display(ProgressStyle::automatic);
    const ExpandedInputs inputs = expand_inputs(arguments.meshes, "");
    report_passed_over(inputs, display);
    const std::vector<tools::InspectedFile> files = tools::inspect(inputs, options, {&display});
    display.finish();

    if (arguments.json) fmt::print("{}\n", tools::inspection_json(files));
    std::size_t unusable = 0;
    for (const tools::InspectedFile& file : files) {
        unusable += file.unusable ? 1 : 0;
        if (arguments.json) continue;
        if (&file != &files.front()) fmt::print("\n");
        print_file(file);
    }
    if (options.keep_meshes && unusable < files.size()) {
        write_picture(tools::inspection_scene(files), arguments.picture, picture, arguments.threads);
        if (!arguments.json) fmt::print("\nWritten: {}\n", printable(arguments.picture));
    }
    if (unusable == 0) return kDone;
    std::fflush(stdout);
    tell("spectralpack: {} of {} cannot be used\n", unusable, counted(files.size(), "file", "files"));
    return kUnusableInput;
}

}  // namespace

Command add_inspect_command(CLI::App& app) {
    auto* sub = app.add_subcommand("inspect", "Say what is in mesh files, and what is wrong with it");
    sub->footer(
        "Size, volume, area, holes, facets that face the wrong way or cross, and the unit of every mesh, as it\n"
        "would be packed: once what is safe to mend is mended, which is named. Folders and set files work as in pack.\n"
        "Exit: 0 done, 3 a file cannot be used.");
    auto arguments = std::make_shared<InspectArguments>();
    InspectArguments& a = *arguments;
    sub->add_option("MESH", a.meshes, "mesh files or folders")->required();
    sub->add_option("-o,--output", a.picture, "draw them into this file (.png)");
    sub->add_option("--size", a.size, "pixels of the picture [1600x1200]");
    sub->add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]");
    add_threads(*sub, a.threads);
    sub->add_flag("--json", a.json, "print the findings as JSON");
    return {sub, [arguments] { return run_inspect(*arguments); }};
}

}  // namespace spectralpack::cli
