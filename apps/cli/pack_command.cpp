#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "default_settings.hpp"
#include "exit_status.hpp"
#include "help_page.hpp"
#include "interrupts.hpp"
#include "pack_arguments.hpp"
#include "passed_over.hpp"
#include "paths.hpp"
#include "printer_list.hpp"
#include "progress_display.hpp"
#include "summary.hpp"
#include "text.hpp"
#include "time_probe.hpp"

namespace spectralpack::cli {
namespace {

void check_files(const JobSettings& settings) {
    for (const std::string& output : settings.outputs) {
        require_output(output);
    }
    for (const std::string& report : settings.reports) {
        if (!is_report_file(report)) {
            throw UsageError(fmt::format("--report {}: a report's name ends in .html or .csv", report));
        }
        require_writable(report, "--report");
    }
}

/// Nothing that is read is written over: a part would be lost, or the last build, lying among the parts, packed as one.
void spare_inputs(const Job& job, const JobSettings& settings, const PackArguments& arguments) {
    std::vector<std::string> inputs = files_of(job.container);
    inputs.insert(inputs.end(), arguments.parts.begin(), arguments.parts.end());  // set and job files among them
    for (const std::filesystem::path& file : settings_files(arguments)) {
        inputs.push_back(file.string());
    }
    for (const Part& part : job.parts) {
        inputs.push_back(part.mesh.file());
    }
    for (const FixedSource& fixed : job.fixed) {
        inputs.push_back(fixed.mesh.file);
    }
    for (const std::string& output : settings.outputs) {
        require_no_input(output, "-o", inputs);
    }
    for (const std::string& report : settings.reports) {
        require_no_input(report, "--report", inputs);
    }
}

/// What the command line and the job file ask for, as far as it can be checked before any work: words, endings,
/// folders.
JobSettings settle(const PackArguments& arguments, const JobSettings& file) {
    JobSettings settings = override_settings(file, arguments);
    check_files(settings);
    return settings;
}

/// "28 Nov 2026", where the program runs.
std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    if (!localtime_r(&now, &local)) return "";
    static constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    return fmt::format("{} {} {}", local.tm_mday, kMonths[local.tm_mon], local.tm_year + 1900);
}

ReportDetails report_details(const JobSettings& settings) {
    ReportDetails details;
    details.job_name = settings.job_name.value_or(std::filesystem::path(settings.file).stem().string());
    details.date = today();
    details.material = settings.material.value_or("");
    details.material_density = settings.material_density;
    return details;
}

/// Writes every output; one that fails does not keep the others from being written.
void write_outputs(const Scene& scene, const JobSettings& settings, ProgressDisplay& display, RunFacts& facts,
                   int& status) {
    std::int64_t done = 0;
    const auto total = static_cast<std::int64_t>(settings.outputs.size() + settings.reports.size());
    const int threads = settings.options.threads;
    const auto write = [&](const auto& action) {
        try {
            action();
        } catch (const Error& error) {
            display.on_error(error.what());
            status = kOutOfResources;
        }
        ++done;
        display.on_progress({Phase::write, done, total, 0, static_cast<double>(done) / static_cast<double>(total)});
    };
    for (const std::string& output : settings.outputs) {
        write([&] {
            WrittenFile written{output, {}};
            const auto files = write_output(scene, output, threads);
            for (std::size_t i = 1; i < files.size(); ++i) {
                written.trays.push_back(files[i].string());
            }
            facts.written.push_back(std::move(written));
        });
    }
    for (const std::string& report : settings.reports) {
        write([&] {
            write_report(scene, report, report_details(settings), threads);
            facts.reports.push_back(report);
        });
    }
}

/// A dry run packs for this long to see how fast it goes.
constexpr double kProbeSeconds = 3;

int run_estimate(const Job& job, const JobSettings& settings, ProgressDisplay& display, const Interrupts& interrupts,
                 bool& unusable) {
    const Estimate planned = estimate(job, {&display});
    display.finish();
    display.on_unusable(planned.unusable);
    display.end();
    unusable = unusable || !planned.unusable.empty();
    const std::optional<ProbedTime> time = probe_time(job, kProbeSeconds, interrupts.token());
    if (settings.json.value_or(false)) {
        const bool known = time && time->packed > 0;
        fmt::print("{}\n", estimate_json(planned, known ? std::optional(time->seconds) : std::nullopt));
    } else {
        fmt::print("{}", estimate_text(planned, job.options, time));
    }
    return interrupts.token().reason() == StopReason::cancelled ? kInterrupted : kDone;
}

/// Where nothing is placed nothing is written, and that is no success.
int status_without_copies(const PackResult& result) {
    return result.stopped == StopReason::cancelled ? kInterrupted : kNothingPlaced;
}

int run_job(const Job& job, const JobSettings& settings, RunFacts facts, ProgressDisplay& display,
            Interrupts& interrupts, bool& unusable) {
    int status = kDone;
    const PackResult result = pack(job, {&display, interrupts.token()});
    display.on_unusable(result.unusable);
    unusable = unusable || !result.unusable.empty();
    if (result.failure) {
        display.on_error(result.failure->what());
        const ErrorKind kind = result.failure->kind();
        status = kind == ErrorKind::resource ? kOutOfResources
                 : kind == ErrorKind::input  ? kUnusableInput
                                             : kCheckFailed;
    }
    const Scene scene{result.packing, result.meshes};
    const bool empty = newly_placed(result.packing) == 0;
    if (empty) {
        if (status == kDone) status = status_without_copies(result);
    } else {
        interrupts.begin_writing();
        write_outputs(scene, settings, display, facts, status);
    }
    display.end();
    if (settings.json.value_or(false)) {
        fmt::print("{}\n", packing_json(scene));
    } else {
        fmt::print("{}", summary_text(result, facts));
    }
    if (status != kDone) return status;
    if (result.stopped == StopReason::cancelled) return kInterrupted;
    return settings.require_all.value_or(false) && !result.packing.unplaced.empty() ? kLeftOver : kDone;
}

/// Of what cannot be used, as far as it is known before meshes are read.
std::vector<InputError> problems_of(const std::vector<Part>& parts) {
    std::vector<InputError> problems;
    for (const Part& part : parts) {
        if (part.problem) problems.push_back(*part.problem);
    }
    return problems;
}

RunFacts facts_of(const Job& job, const JobSettings& settings, const TakenOver& taken) {
    RunFacts facts;
    facts.files_named = !settings.outputs.empty() || !settings.reports.empty();
    facts.taken = taken;
    facts.own_printers = settings.own_printers;
    if (job.onto && job.onto->packing.trays.size() == 1) facts.onto_height = job.onto->packing.trays.front().height;
    facts.details = settings.details.value_or(false);
    facts.require_all = settings.require_all.value_or(false);
    facts.skip_unusable = settings.skip_unusable.value_or(false);
    return facts;
}

int run_pack(const PackArguments& arguments) {
    if (arguments.text("printer") == "list") {
        print_printers(default_settings(arguments).own_printers, arguments.has("json"));
        return kDone;
    }
    if (arguments.parts.empty()) {
        fmt::print(stderr, "{}'spectralpack pack --help' shows the options.\n", pack_help_head());
        return kUsage;
    }
    const JobSettings defaults = default_settings(arguments);
    settle(arguments, defaults);  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.text("mesh-dir"), defaults);
    const JobSettings settings = settle(arguments, inputs.job.value_or(defaults));
    Interrupts interrupts(settings.options.time_limit);
    ProgressDisplay display(settings.progress.value_or(ProgressStyle::automatic));
    report_passed_over(inputs, display);
    const std::vector<InputError> problems = problems_of(inputs.parts);
    if (problems.size() == inputs.parts.size()) {
        display.on_unusable(problems);
        fmt::print(stderr, "Nothing is left to pack.\n");
        return problems.empty() ? kUsage : kUnusableInput;
    }
    Job job;
    job.parts = inputs.parts;
    job.unit = in_mm(settings.unit.value_or(LengthUnit::mm));
    job.options = settings.options;
    job.fixed = settings.fixed;
    job.own_printers = settings.own_printers;
    job.defaults = settings.defaults;
    job.enough_orders = interrupts.half_time();
    const TakenOver taken = settle_container(arguments, settings, job);
    for (const std::string& remark : taken.remarks) {
        display.on_warning(remark);
    }
    if (!job.defaults.empty()) display.on_warning("settings: " + origin_text(job.defaults));
    spare_inputs(job, settings, arguments);

    bool unusable = false;
    const int status = settings.dry_run.value_or(false)
                           ? run_estimate(job, settings, display, interrupts, unusable)
                           : run_job(job, settings, facts_of(job, settings, taken), display, interrupts, unusable);
    const bool packed = status == kDone || status == kLeftOver || status == kNothingPlaced;
    if (packed && unusable && !settings.skip_unusable.value_or(false)) {
        return kUnusableInput;
    }
    return status;
}

}  // namespace

Command add_pack_command(CLI::App& app) {
    auto* sub = app.add_subcommand("pack", "Pack parts into trays");
    sub->footer(
        pack_help_head() +
        "A job file brings options of its own; those given on the command line override them.\n"
        "Exit status: 0 done, also with copies left over; 2 wrong usage; 3 a file cannot be used (the rest is\n"
        "packed and written); 4 no memory or disk; 5 copies left over with --require-all; 6 nothing placed, and\n"
        "nothing written; 130 interrupted, the best so far is written.");
    sub->formatter(std::make_shared<PackHelp>());
    sub->set_help_all_flag("--help-all", "Print this help with all options");
    auto arguments = std::make_shared<PackArguments>();
    add_pack_options(*sub, *arguments);
    return {sub, [arguments] { return run_pack(*arguments); }};
}

}  // namespace spectralpack::cli
