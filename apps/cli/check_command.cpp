#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "progress_display.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

struct CheckArguments {
    std::string packing;
    int threads = 0;
    bool json = false;
    bool require_plan = false;
};

void print_plans(const CheckReport& report) {
    if (report.stopped) return;
    std::size_t without_plan = 0;
    for (const std::optional<PlanReport>& plan : report.plans) {
        if (plan) {
            fmt::print("{}\n", plan->message);
        } else {
            ++without_plan;
        }
    }
    if (without_plan == 0) {
        fmt::print("interlocking: {}\n", report.plans_complete()
                                             ? "none, every copy comes out by its plan"
                                             : "NOT EXCLUDED, the plan does not take out all copies");
    } else if (without_plan == report.plans.size()) {
        fmt::print("interlocking: not checked (the packing has no disassembly plan)\n");
    } else {
        fmt::print("interlocking: not checked in {} of {} trays (they have no disassembly plan)\n", without_plan,
                   report.plans.size());
    }
}

int run_check(const CheckArguments& arguments) {
    const Interrupts interrupts(std::nullopt);
    ProgressDisplay display(ProgressStyle::automatic);
    const Scene scene = load_scene(arguments.packing);
    const CheckReport report = check(scene, arguments.threads, {&display, interrupts.token()});
    display.finish();
    const bool plan_missing = arguments.require_plan && !report.plans_complete();
    if (arguments.json) {
        fmt::print("{}\n", check_report_json(scene, report));
    } else {
        for (const Finding& finding : report.findings) {
            fmt::print("FAILED: {}\n", finding.message);
        }
        std::size_t copies = 0;
        for (const TrayPacking& tray : scene.packing.trays) {
            copies += tray.placements.size();
        }
        fmt::print("{}: {} {}; {} pair{} compared\n",
                   report.ok()      ? "ok"
                   : report.stopped ? "stopped"
                                    : "failed",
                   copies, copies == 1 ? "copy" : "copies", report.pairs_tested, report.pairs_tested == 1 ? "" : "s");
        for (std::size_t tray = 0; tray < report.density.size(); ++tray) {
            fmt::print("tray {}: density {}\n", tray + 1, percent_text(report.density[tray]));
        }
        if (report.min_gap) fmt::print("least gap: {} mm\n", length_text(*report.min_gap));
        print_plans(report);
    }
    if (report.stopped) return kInterrupted;
    if (plan_missing)
        fmt::print(stderr, "spectralpack: the packing has no complete disassembly plan that can be followed\n");
    return report.ok() && !plan_missing ? kDone : kCheckFailed;
}

}  // namespace

Command add_check_command(CLI::App& app) {
    auto* sub = app.add_subcommand("check", "Verify a packing from its meshes alone");
    sub->footer(
        "Decides containment, overlap, nesting, gaps, transforms and the stated density on the exact\n"
        "triangles, and replays the disassembly plan, sharing no code with the packer. Exit status 1 when something is wrong.");
    auto arguments = std::make_shared<CheckArguments>();
    sub->add_option("PACKING", arguments->packing, "packing file (.json)")->required();
    sub->add_option("--threads", arguments->threads, "threads, 0 for all");
    sub->add_flag("--json", arguments->json, "print the report as JSON");
    sub->add_flag("--require-plan", arguments->require_plan, "fail where no disassembly plan takes out every copy");
    return {sub, [arguments] { return run_check(*arguments); }};
}

}  // namespace spectralpack::cli
