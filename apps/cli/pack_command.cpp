#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "default_settings.hpp"
#include "exit_status.hpp"
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

void report_unusable(const std::vector<InputError>& unusable, ProgressDisplay& display) {
    for (const InputError& error : unusable) {
        display.on_error(error.what());
    }
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
std::vector<std::string> write_outputs(const Scene& scene, const JobSettings& settings, ProgressDisplay& display,
                                       int& status) {
    std::vector<std::string> written;
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
            for (const auto& file : write_output(scene, output, threads)) {
                written.push_back(file.string());
            }
        });
    }
    for (const std::string& report : settings.reports) {
        write([&] {
            write_report(scene, report, report_details(settings), threads);
            written.push_back(report);
        });
    }
    return written;
}

/// A dry run packs for this long to see how fast it goes.
constexpr double kProbeSeconds = 3;

int run_estimate(const Job& job, ProgressDisplay& display, const Interrupts& interrupts, bool& unusable) {
    const Estimate planned = estimate(job, {&display});
    display.finish();
    report_unusable(planned.unusable, display);
    unusable = unusable || !planned.unusable.empty();
    print_estimate(planned, job.options, probe_time(job, kProbeSeconds, interrupts.token()));
    return interrupts.token().reason() == StopReason::cancelled ? kInterrupted : kDone;
}

int run_job(const Job& job, const JobSettings& settings, const TakenOver& taken, ProgressDisplay& display,
            const Interrupts& interrupts, bool& unusable) {
    int status = kDone;
    const PackResult result = pack(job, {&display, interrupts.token()});
    report_unusable(result.unusable, display);
    unusable = unusable || !result.unusable.empty();
    if (result.failure) {
        display.on_error(result.failure->what());
        const ErrorKind kind = result.failure->kind();
        status = kind == ErrorKind::resource ? kOutOfResources
                 : kind == ErrorKind::input  ? kUnusableInput
                                             : kCheckFailed;
    }
    const Scene scene{result.packing, result.meshes};
    const auto written = write_outputs(scene, settings, display, status);
    display.finish();
    if (settings.json.value_or(false)) {
        fmt::print("{}\n", packing_json(scene));
    } else {
        print_summary(result, written, !settings.outputs.empty(), taken);
    }
    if (status != kDone) return status;
    if (result.stopped == StopReason::cancelled) return kInterrupted;
    return settings.require_all.value_or(false) && !result.packing.unplaced.empty() ? kLeftOver : kDone;
}

int run_pack(const PackArguments& arguments) {
    if (arguments.text("printer") == "list") {
        print_printers(default_settings(arguments).own_printers, arguments.has("json"));
        return kDone;
    }
    if (arguments.parts.empty()) throw UsageError("PART is required: name what to pack");
    const JobSettings defaults = default_settings(arguments);
    settle(arguments, defaults);  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.text("mesh-dir"), defaults);
    const JobSettings settings = settle(arguments, inputs.job.value_or(defaults));
    const Interrupts interrupts(settings.options.time_limit);
    ProgressDisplay display(settings.progress.value_or(ProgressStyle::automatic));
    report_passed_over(inputs, display);
    report_unusable(inputs.unusable, display);
    if (inputs.parts.empty()) return inputs.unusable.empty() ? kUsage : kUnusableInput;
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

    bool unusable = !inputs.unusable.empty();
    const int status = settings.dry_run.value_or(false) ? run_estimate(job, display, interrupts, unusable)
                                                        : run_job(job, settings, taken, display, interrupts, unusable);
    if ((status == kDone || status == kLeftOver) && unusable && !settings.skip_unusable.value_or(false)) {
        return kUnusableInput;
    }
    return status;
}

}  // namespace

Command add_pack_command(CLI::App& app) {
    auto* sub = app.add_subcommand("pack", "Pack parts into a container");
    sub->footer(
        "PART is a mesh (.stl .obj .3mf .ply .off), FILE:COUNT, FILE@SCALE, FILE:COUNT@SCALE, a folder of meshes, a set\n"
        "file (.csv with columns mesh, count and more), or a job file (.json), whose options those given here override.\n"
        "\n"
        "  spectralpack pack parts/ bracket.stl:12 --tray 160x120x100 --gap 1 -o build.3mf -o build.png\n"
        "  spectralpack pack set.csv --voxel 1 --time-limit 60 -o build.json && spectralpack check build.json\n"
        "\n"
        "Finer voxels pack denser and take longer: halving --voxel costs about ten times the time.\n"
        "--restarts and --beam look for the order on the grid, at most for half of --time-limit, and then pack in it.\n"
        "Exit status: 0 done, also with copies left over; 2 wrong usage; 3 an input was unusable (the rest is\n"
        "packed); 4 out of memory or disk; 5 copies left over under --require-all; 130 interrupted, best packing\n"
        "so far written.");
    auto arguments = std::make_shared<PackArguments>();
    add_pack_options(*sub, *arguments);
    return {sub, [arguments] { return run_pack(*arguments); }};
}

}  // namespace spectralpack::cli
