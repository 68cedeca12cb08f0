#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "pack_arguments.hpp"
#include "paths.hpp"
#include "progress_display.hpp"
#include "summary.hpp"
#include "text.hpp"
#include "time_probe.hpp"

namespace spectralpack::cli {
namespace {

void print_printers() {
    for (const Printer& printer : printers()) {
        const Vec3& s = printer.size;
        fmt::print("{:<16} {:<32} {:g}x{:g}x{:g} mm, gap {:g}, walls {:g}, floor {:g} mm\n{:<16} size{}: {}\n",
                   printer.name, printer.title, s.x, s.y, s.z, printer.gap, printer.wall, printer.floor, "",
                   printer.verified ? "" : " (UNVERIFIED)", printer.source);
    }
    fmt::print(
        "Gaps and clearances are customary starting values, not the makers' word (UNVERIFIED): yours depend on\n"
        "material and machine. --tray, --gap and --wall-gap override them.\n");
}

void check_files(const JobSettings& settings) {
    for (const std::string& output : settings.outputs) {
        require_output(output);
    }
    if (settings.report) {
        if (!is_report_file(*settings.report)) {
            throw UsageError(fmt::format("--report {}: a report's name ends in .html or .csv", *settings.report));
        }
        require_writable(*settings.report, "--report");
    }
}

/// Nothing that is read is written over: a part would be lost, or the last build, lying among the parts, packed as one.
void spare_inputs(const Job& job, const JobSettings& settings, const PackArguments& arguments) {
    std::vector<std::string> inputs = files_of(job.container);
    inputs.insert(inputs.end(), arguments.parts.begin(), arguments.parts.end());  // set and job files among them
    for (const Part& part : job.parts) {
        inputs.push_back(part.mesh.file());
    }
    for (const FixedSource& fixed : job.fixed) {
        inputs.push_back(fixed.mesh.file);
    }
    for (const std::string& output : settings.outputs) {
        require_no_input(output, "-o", inputs);
    }
    if (settings.report) require_no_input(*settings.report, "--report", inputs);
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

/// Writes every output; one that fails does not keep the others from being written.
std::vector<std::string> write_outputs(const Scene& scene, const JobSettings& settings, ProgressDisplay& display,
                                       int& status) {
    std::vector<std::string> written;
    std::int64_t done = 0;
    const auto total = static_cast<std::int64_t>(settings.outputs.size() + (settings.report ? 1 : 0));
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
    if (settings.report) {
        write([&] {
            write_report(scene, *settings.report, settings.material_density, threads);
            written.push_back(*settings.report);
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

int run_job(const Job& job, const JobSettings& settings, ProgressDisplay& display, const Interrupts& interrupts,
            bool& unusable) {
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
        print_summary(result, written, !settings.outputs.empty());
    }
    if (status != kDone) return status;
    if (result.stopped == StopReason::cancelled) return kInterrupted;
    return settings.require_all.value_or(false) && !result.packing.unplaced.empty() ? kLeftOver : kDone;
}

int run_pack(const PackArguments& arguments) {
    if (arguments.text("printer") == "list") {
        print_printers();
        return kDone;
    }
    if (arguments.parts.empty()) throw UsageError("PART is required: name what to pack");
    settle(arguments, {});  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.text("mesh-dir"));
    const JobSettings settings = settle(arguments, inputs.job.value_or(JobSettings{}));
    const Interrupts interrupts(settings.options.time_limit);
    ProgressDisplay display(settings.progress.value_or(ProgressStyle::automatic));
    report_unusable(inputs.unusable, display);
    if (inputs.parts.empty()) return inputs.unusable.empty() ? kUsage : kUnusableInput;
    Job job;
    job.parts = inputs.parts;
    job.unit = in_mm(settings.unit.value_or(LengthUnit::mm));
    job.options = settings.options;
    job.fixed = settings.fixed;
    job.enough_orders = interrupts.half_time();
    settle_container(arguments, settings, job);
    spare_inputs(job, settings, arguments);

    bool unusable = !inputs.unusable.empty();
    const int status = settings.dry_run.value_or(false) ? run_estimate(job, display, interrupts, unusable)
                                                        : run_job(job, settings, display, interrupts, unusable);
    if ((status == kDone || status == kLeftOver) && unusable && !settings.skip_unusable.value_or(false)) {
        return kUnusableInput;
    }
    return status;
}

}  // namespace

Command add_pack_command(CLI::App& app) {
    auto* sub = app.add_subcommand("pack", "Pack parts into a container");
    sub->footer(
        "PART is a mesh (.stl .obj .3mf .ply .off), FILE:COUNT, FILE:COUNT@SCALE, a folder of meshes, or a set\n"
        "file (.csv with columns mesh,count,scale), or a job file (.json), whose options those given here override.\n"
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
