#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "number_options.hpp"
#include "progress_display.hpp"
#include "tell.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct CheckArguments {
    std::string packing;
    int threads = 0;
    bool json = false;
    bool require_plan = false;
};

std::string steps_text(std::int64_t steps) { return fmt::format("{} step{}", steps, steps == 1 ? "" : "s"); }

/// Whether the tray comes apart, as far as its plan tells.
std::string apart_text(const Packing& packing, std::size_t tray, const std::optional<PlanReport>& plan) {
    if (!plan) return "NOT CHECKED whether it comes apart (it has no plan)";
    if (!plan->ok()) {
        return fmt::format("DOES NOT COME APART by its plan ({} of {} fail)", plan->failed_steps.size(),
                           steps_text(plan->steps));
    }
    const std::optional<Disassembly>& stated = packing.trays[tray].disassembly;
    if (stated && !stated->interlocked.empty()) {
        std::string sets;
        for (const std::vector<int>& set : stated->interlocked) {
            sets += (sets.empty() ? "" : "; ") + copy_names(packing, packing.trays[tray], set);
        }
        return fmt::format("DOES NOT COME APART: by its plan these hold each other: {}", sets);
    }
    if (plan->complete) {
        return fmt::format("{} in {}{}{}", plan->staying.empty() ? "comes apart" : "new copies come apart",
                           steps_text(plan->steps), through_walls_text(static_cast<std::size_t>(plan->through_walls)),
                           staying_text(plan->staying.size()));
    }
    return fmt::format("NOT CHECKED whether it comes apart to the end: {} without a step: {}",
                       plan->without_step.size(), copy_names(packing, packing.trays[tray], plan->without_step));
}

void print_trays(const Packing& packing, const CheckReport& report) {
    for (std::size_t tray = 0; tray < report.density.size(); ++tray) {
        const std::size_t copies = packing.trays[tray].placements.size();
        const std::string apart = copies > 0 && tray < report.plans.size() && !report.stopped
                                      ? ", " + apart_text(packing, tray, report.plans[tray])
                                      : "";
        fmt::print("Tray {}: {} cop{}, {} filled{}.\n", tray + 1, copies, copies == 1 ? "y" : "ies",
                   percent_text(report.density[tray]), apart);
    }
}

/// Under --require-plan it is a fault that a tray has no plan, or one that leaves copies.
void require_plans(const Packing& packing, CheckReport& report) {
    for (std::size_t tray = 0; tray < report.plans.size(); ++tray) {
        const std::optional<PlanReport>& plan = report.plans[tray];
        if (packing.trays[tray].placements.empty()) continue;
        if (plan && (plan->complete || !plan->ok())) continue;  // a step that fails is a finding by itself
        const std::string where = packing.trays.size() > 1 ? fmt::format("tray {}: ", tray + 1) : "";
        const std::vector<int> left = plan ? plan->without_step : std::vector<int>();
        const std::string what = !plan          ? "there is no plan by which the copies come out"
                                 : left.empty() ? "the plan does not say that it is complete"
                                                : "the plan leaves " + copy_names(packing, packing.trays[tray], left);
        report.findings.push_back({FindingKind::plan, static_cast<int>(tray), left, 0,
                                   fmt::format("{}{}, and --require-plan asks for one that is complete", where, what)});
    }
}

/// Faults first, then the trays, then the verdict.
void print_report(const Scene& scene, const CheckReport& report, std::size_t copies) {
    for (const Finding& finding : report.findings) {
        fmt::print("FAULT: {}.\n", printable(finding.message));
    }
    print_trays(scene.packing, report);
    const std::string gap = report.min_gap ? fmt::format(" Least gap {:.2f} mm.", *report.min_gap) : "";
    const std::size_t faults = report.findings.size();
    if (report.stopped) {
        fmt::print("Interrupted: NOT CHECKED to the end.\n");
    } else if (faults > 0) {
        fmt::print("{} fault{} found.{}\n", faults, faults == 1 ? " was" : "s were", gap);
    } else if (copies == 0) {
        fmt::print("Nothing is placed.\n");
    } else {
        fmt::print("Nothing wrong was found.{}\n", gap);
    }
}

int run_check(const CheckArguments& arguments) {
    const Interrupts interrupts(std::nullopt);
    ProgressDisplay display(ProgressStyle::automatic);
    const Scene scene = load_scene(arguments.packing);
    CheckReport report = check(scene, arguments.threads, {&display, interrupts.token()});
    display.end();
    std::size_t copies = 0;
    for (const TrayPacking& tray : scene.packing.trays) {
        copies += tray.placements.size();
    }
    if (arguments.require_plan && !report.stopped) require_plans(scene.packing, report);
    if (arguments.json) {
        fmt::print("{}\n", check_report_json(scene, report));
    } else {
        print_report(scene, report, copies);
    }
    if (report.stopped) return kInterrupted;
    if (!report.ok()) return kCheckFailed;
    return copies == 0 ? kNothingPlaced : kDone;
}

}  // namespace

Command add_check_command(CLI::App& app) {
    auto* sub = app.add_subcommand("check", "Check a packing from its meshes alone");
    sub->footer(
        "Looks for copies that overlap, stand inside one another, are nearer than the gap or stick out, and for\n"
        "figures that are not so; and takes the tray apart step by step as its plan says. It shares no code with\n"
        "the packer. Exit: 0 nothing wrong, 1 a fault, 3 a bad file, 6 nothing is placed.");
    auto arguments = std::make_shared<CheckArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    add_threads(*sub, arguments->threads);
    sub->add_flag("--json", arguments->json, "print the findings as JSON");
    sub->add_flag("--require-plan", arguments->require_plan, "no plan by which every copy comes out is a fault");
    return {sub, [arguments] { return run_check(*arguments); }};
}

}  // namespace spectralpack::cli
