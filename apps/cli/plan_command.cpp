#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "number_options.hpp"
#include "paths.hpp"
#include "progress_display.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct PlanArguments {
    std::string packing;
    std::vector<std::string> outputs;
    PlanOptions settings;
    std::optional<double> time_limit;
    bool json = false;
};

std::string steps_text(const Disassembly& plan) {
    const auto groups = std::ranges::count_if(plan.steps, [](const auto& step) { return step.placements.size() > 1; });
    return fmt::format("{} step{}{}{}", plan.steps.size(), plan.steps.size() == 1 ? "" : "s",
                       groups > 0 ? fmt::format(", {} of them with several copies at once", groups) : "",
                       through_walls_text(plan.through_walls.size()));
}

void print_plan(const Packing& packing, std::size_t tray, const Disassembly& plan) {
    const std::size_t copies = packing.trays[tray].placements.size();
    if (copies == 0) {
        fmt::print("Tray {}: nothing is placed.\n", tray + 1);
        return;
    }
    if (plan.complete) {
        TrayPacking planned = packing.trays[tray];
        planned.disassembly = plan;
        const std::size_t stay = staying(planned).size();
        fmt::print("Tray {}: {} in {}{}.\n", tray + 1, stay == 0 ? "comes apart" : "new copies come apart",
                   steps_text(plan), staying_text(stay));
        return;
    }
    if (plan.interlocked.empty()) {
        fmt::print("Tray {}: NOT CHECKED to the end: stopped after {}.\n", tray + 1, steps_text(plan));
        return;
    }
    fmt::print("Tray {}: DOES NOT COME APART; the other copies leave in {}.\n", tray + 1, steps_text(plan));
    for (const std::vector<int>& set : plan.interlocked) {
        const std::string text = fmt::format(
            "  {} {}: {}", set.size(),
            packing.container.physical ? "hold each other or cannot leave the container" : "hold each other",
            copy_names(packing, packing.trays[tray], set));
        fmt::print("{}\n", wrapped(text, kScreenWidth));
    }
}

int run_plan(const PlanArguments& arguments) {
    std::vector<NamedOutput> outputs;
    for (const std::string& output : arguments.outputs) {
        require_output(output);
        outputs.push_back({"-o", output});
    }
    require_apart(outputs);
    const Interrupts interrupts(arguments.time_limit);
    ProgressDisplay display(ProgressStyle::automatic);
    Scene scene = load_scene(arguments.packing);
    const std::set<std::string> files = mesh_files(scene.packing);
    const std::vector<std::string> meshes(files.begin(), files.end());
    for (const NamedOutput& output : outputs) {
        require_no_input(output.path, output.option, meshes);
        require_tray_files(output, static_cast<std::int64_t>(scene.packing.trays.size()), outputs, meshes);
    }
    const std::vector<Disassembly> plans = plan_packing(scene, arguments.settings, {&display, interrupts.token()});
    display.finish();
    bool complete = true, empty = true;
    for (std::size_t tray = 0; tray < plans.size(); ++tray) {
        scene.packing.trays[tray].disassembly = plans[tray];
        complete = complete && plans[tray].complete;
        empty = empty && scene.packing.trays[tray].placements.empty();
    }
    for (const std::string& output : arguments.outputs) {
        write_output(scene, output, arguments.settings.threads);
    }
    if (arguments.json) {
        fmt::print("{}\n", plans_json(scene, plans));
    } else {
        for (std::size_t tray = 0; tray < plans.size(); ++tray) {
            print_plan(scene.packing, tray, plans[tray]);
        }
        for (const std::string& output : arguments.outputs) {
            fmt::print("Written: {}\n", printable(output));
        }
    }
    if (interrupts.token().reason() == StopReason::cancelled) return kInterrupted;
    if (!complete) return kCheckFailed;
    return empty ? kNothingPlaced : kDone;
}

}  // namespace

Command add_plan_command(CLI::App& app) {
    auto* sub = app.add_subcommand("plan", "Find out how a packing comes apart, or what in it does not");
    sub->footer(
        "Works on any packing file whose meshes are there. Every step is tried on the exact meshes. Where no way\n"
        "out is found and the file has a plan of its own, that is followed.\n"
        "Exit: 0 it comes apart, 1 it does not or there was no time to find out, 3 a bad file,\n"
        "6 nothing is placed.");
    auto arguments = std::make_shared<PlanArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    sub->add_option("-o,--output", arguments->outputs,
                    "file to write, plan included: .json (others without), repeatable")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_number(*sub, "voxel", "MM", kAboveZero, arguments->settings.voxel,
               "finer voxels find narrower ways out, mm [those of the packing: voxel / detail]");
    add_number(*sub, "ray-spacing", "MM", kAboveZero, arguments->settings.ray_spacing,
               "mm between the rays that tell which copy is straight in whose way [the packing's, or 4 voxels]");
    sub->add_option_function<std::string>(
           "--unpack", [arguments](const std::string& rule) { arguments->settings.unpack = from_string<Unpack>(rule); },
           "order in which copies are taken out: top (from the top down, between the walls), any (also sideways) [the "
           "packing's]")
        ->check(CLI::IsMember({"top", "any"}));
    add_number(*sub, "time-limit", "SECONDS", kFromZero, arguments->time_limit, "seconds");
    add_threads(*sub, arguments->settings.threads);
    sub->add_flag("--json", arguments->json, "print the plan's findings as JSON");
    return {sub, [arguments] { return run_plan(*arguments); }};
}

}  // namespace spectralpack::cli
