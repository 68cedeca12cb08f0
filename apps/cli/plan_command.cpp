#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "paths.hpp"
#include "progress_display.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

constexpr std::size_t kMostNamed = 12;

struct PlanArguments {
    std::string packing;
    std::vector<std::string> outputs;
    PlanOptions settings;
    std::optional<double> time_limit;
    bool json = false;
};

/// "3 ring, 4 ring and 7 more": with the copies' numbers.
std::string names(const Packing& packing, const TrayPacking& tray, const std::vector<int>& placements) {
    std::string text;
    const CopyNumbers numbers(packing.parts);
    for (std::size_t i = 0; i < placements.size() && i < kMostNamed; ++i) {
        const Placement& placement = tray.placements[static_cast<std::size_t>(placements[i])];
        text += fmt::format("{}{} {}", i > 0 ? ", " : "", numbers.of(placement),
                            printable(packing.parts[static_cast<std::size_t>(placement.part)].name));
    }
    if (placements.size() > kMostNamed) text += fmt::format(" and {} more", placements.size() - kMostNamed);
    return text;
}

void print_plan(const Packing& packing, std::size_t tray, const Disassembly& plan) {
    std::size_t moves = 0, groups = 0;
    for (const RemovalStep& step : plan.steps) {
        moves += step.path.size();
        groups += step.placements.size() > 1 ? 1 : 0;
    }
    const std::string of_groups = groups > 0 ? fmt::format(" ({} of groups)", groups) : "";
    if (plan.complete) {
        fmt::print("tray {}: comes apart in {} step{}{}, {} move{}{}\n", tray + 1, plan.steps.size(),
                   plan.steps.size() == 1 ? "" : "s", of_groups, moves, moves == 1 ? "" : "s",
                   through_walls_text(plan.through_walls.size()));
        return;
    }
    if (plan.interlocked.empty()) {
        fmt::print("tray {}: no plan yet; stopped after {} steps{}\n", tray + 1, plan.steps.size(), of_groups);
        return;
    }
    fmt::print("tray {}: INTERLOCKED; {} steps{} take out the rest\n", tray + 1, plan.steps.size(), of_groups);
    for (const std::vector<int>& set : plan.interlocked) {
        const std::string which = names(packing, packing.trays[tray], set);
        if (packing.container.physical) {
            fmt::print("  {} hold each other or cannot leave the container: {}\n", set.size(), which);
        } else {
            fmt::print("  {} hold each other: {}\n", set.size(), which);
        }
    }
}

int run_plan(const PlanArguments& arguments) {
    for (const std::string& output : arguments.outputs) {
        require_output(output);
    }
    const Interrupts interrupts(arguments.time_limit);
    ProgressDisplay display(ProgressStyle::automatic);
    Scene scene = load_scene(arguments.packing);
    std::vector<std::string> meshes = files_of(container_source(scene.packing));
    for (const PackedPart& part : scene.packing.parts) {
        meshes.push_back(part.mesh);
    }
    for (const std::string& output : arguments.outputs) {
        require_no_input(output, "-o", meshes);
    }
    const std::vector<Disassembly> plans = plan_packing(scene, arguments.settings, {&display, interrupts.token()});
    display.finish();
    bool complete = true;
    for (std::size_t tray = 0; tray < plans.size(); ++tray) {
        scene.packing.trays[tray].disassembly = plans[tray];
        complete = complete && plans[tray].complete;
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
            fmt::print("wrote {}\n", output);
        }
    }
    if (interrupts.token().reason() == StopReason::cancelled) return kInterrupted;
    return complete ? kDone : kCheckFailed;
}

}  // namespace

Command add_plan_command(CLI::App& app) {
    auto* sub = app.add_subcommand("plan", "Find out how a packing comes apart, or what in it is interlocked");
    sub->footer(
        "Works on any packing file whose meshes are there. Every step is confirmed on the exact triangles.\n"
        "Where no way is found that the file's own plan has, if it has one, that is taken.\n"
        "Exit status 1 when something is interlocked, or when there was no time to find out.");
    auto arguments = std::make_shared<PlanArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    sub->add_option("-o,--output", arguments->outputs,
                    "file to write, plan included: .json (others without), repeatable")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    sub->add_option("--voxel", arguments->settings.voxel,
                    "voxel size of the search for ways out, mm [that of the packing's collisions: voxel / detail]");
    sub->add_option("--ray-spacing", arguments->settings.ray_spacing,
                    "mm between the rays that tell which copy is straight in whose way; what they miss, flood fills "
                    "find [the packing's, or four voxels]")
        ->check(CLI::PositiveNumber);
    sub->add_option_function<std::string>(
           "--unpack", [arguments](const std::string& rule) { arguments->settings.unpack = from_string<Unpack>(rule); },
           "order in which copies are taken out: top (from the top down, between the walls), any (also sideways) [the "
           "packing's]")
        ->check(CLI::IsMember({"top", "any"}));
    sub->add_option("--time-limit", arguments->time_limit, "seconds")->check(CLI::NonNegativeNumber);
    sub->add_option("--threads", arguments->settings.threads, "threads, 0 for all");
    sub->add_flag("--json", arguments->json, "print the findings as JSON");
    return {sub, [arguments] { return run_plan(*arguments); }};
}

}  // namespace spectralpack::cli
