#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "paths.hpp"
#include "progress_display.hpp"
#include "summary.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// The words of the command line; settle() makes options of them. Defaults that stand in PackOptions are not repeated: an
/// option that is not given leaves what the job file says, or the default.
struct PackArguments {
    std::vector<std::string> parts;
    std::string mesh_dir;
    std::optional<std::string> unit, tray, trays, rotations, interlock, height_penalty, height_at, order, engine,
        memory, verify_with, progress, report;
    std::optional<double> gap, wall_gap, voxel, time_limit, material_density;
    std::optional<std::uint64_t> seed;
    std::optional<int> threads;
    std::vector<std::string> outputs;
    bool refine = false, no_refine = false;
    bool dry_run = false, json = false, skip_unusable = false, require_all = false;
};

template <class T>
T choose(const std::map<std::string, T>& choices, const std::string& word, const char* option) {
    const auto found = choices.find(word);
    if (found != choices.end()) return found->second;
    std::string known;
    for (const auto& [name, value] : choices) {
        known += (known.empty() ? "" : ", ") + name;
    }
    throw UsageError(fmt::format("{} takes one of {}; not '{}'", option, known, word));
}

const std::map<std::string, EngineKind> kEngines{{"auto", EngineKind::automatic},
                                                 {"cpu", EngineKind::cpu},
                                                 {"cuda", EngineKind::cuda},
                                                 {"reference", EngineKind::reference}};

VerifyWith parse_verify(const std::string& text) {
    const auto colon = text.find(':');
    VerifyWith verify{choose(kEngines, text.substr(0, colon), "--verify-with"), 0};
    if (colon != std::string::npos) {
        const std::string sample = text.substr(colon + 1);
        std::size_t used = 0;
        try {
            verify.sample = std::stoi(sample, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used != sample.size() || verify.sample <= 0) {
            throw UsageError("--verify-with takes an engine and a number of placements, like reference:300");
        }
    }
    return verify;
}

template <class T>
void assign(T& to, const std::optional<T>& given) {
    if (given) to = *given;
}

double parse_height_penalty(const std::string& text) {
    std::size_t used = 0;
    double penalty = 0;
    try {
        penalty = std::stod(text, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used == 0 || used != text.size()) {
        throw UsageError("--height-penalty takes 'auto' or a number, not '" + text + "'");
    }
    return penalty;
}

/// `options` with what the command line says over it.
PackOptions override_options(PackOptions options, const PackArguments& a) {
    if (a.tray) options.tray = parse_size(*a.tray, "--tray");
    if (a.trays && *a.trays != "1") {
        throw UsageError("--trays: several containers are not built yet: only 1");
    }
    assign(options.gap, a.gap);
    assign(options.wall_gap, a.wall_gap);
    assign(options.voxel, a.voxel);
    assign(options.rotations, a.rotations);
    assign(options.seed, a.seed);
    assign(options.threads, a.threads);
    if (a.refine || a.no_refine) options.refine = !a.no_refine;
    if (a.interlock) {
        options.interlock = choose<Interlock>(
            {{"off", Interlock::off}, {"post", Interlock::post}, {"place", Interlock::place}}, *a.interlock,
            "--interlock");
    }
    if (a.height_penalty) {
        options.height_penalty.reset();
        if (*a.height_penalty != "auto") options.height_penalty = parse_height_penalty(*a.height_penalty);
    }
    if (a.height_at) {
        options.height_at = choose<HeightReference>(
            {{"bottom", HeightReference::bottom}, {"top", HeightReference::top}}, *a.height_at, "--height-at");
    }
    if (a.order) {
        options.order = choose<Order>({{"size", Order::size}, {"input", Order::input}, {"random", Order::random}},
                                      *a.order, "--order");
    }
    if (a.engine) options.engine = choose(kEngines, *a.engine, "--engine");
    if (a.memory) options.memory = parse_bytes(*a.memory, "--memory");
    if (a.verify_with) options.verify_with = parse_verify(*a.verify_with);
    if (a.time_limit) options.time_limit = a.time_limit;
    return options;
}

/// Everything that is to be done, from the command line and the job file.
struct Settings {
    Job job;
    std::vector<std::string> outputs;
    std::optional<std::string> report;
    std::optional<double> material_density;
    ProgressStyle progress = ProgressStyle::automatic;
    bool dry_run = false, json = false, skip_unusable = false, require_all = false;
};

void check_files(const Settings& settings) {
    for (const std::string& output : settings.outputs) {
        if (!is_output_file(output)) {
            throw UsageError(fmt::format("-o {}: cannot tell the kind of file by its ending; use one of {}", output,
                                         output_endings()));
        }
        require_folder(output, "-o");
    }
    if (settings.report) {
        if (!is_report_file(*settings.report)) {
            throw UsageError(fmt::format("--report {}: a report's name ends in .html or .csv", *settings.report));
        }
        require_folder(*settings.report, "--report");
    }
    const auto& density = settings.material_density;
    if (density && (!(*density > 0) || !std::isfinite(*density))) {
        throw UsageError("--material-density must be a positive number");
    }
}

/// Checks what can be checked before any work: words, endings, folders.
Settings settle(const PackArguments& a, const JobSettings& file) {
    Settings settings;
    settings.job.options = override_options(file.options, a);
    settings.job.unit = a.unit ? parse_unit(*a.unit) : file.unit.value_or(1);
    settings.outputs = a.outputs.empty() ? file.outputs : a.outputs;
    settings.report = a.report ? a.report : file.report;
    settings.material_density = a.material_density ? a.material_density : file.material_density;
    settings.progress = choose<ProgressStyle>({{"auto", ProgressStyle::automatic},
                                               {"bar", ProgressStyle::bar},
                                               {"json", ProgressStyle::json},
                                               {"none", ProgressStyle::none}},
                                              a.progress.value_or(file.progress.value_or("auto")), "--progress");
    settings.dry_run = a.dry_run || file.dry_run.value_or(false);
    settings.json = a.json || file.json.value_or(false);
    settings.skip_unusable = a.skip_unusable || file.skip_unusable.value_or(false);
    settings.require_all = a.require_all || file.require_all.value_or(false);
    check_files(settings);
    return settings;
}

void report_unusable(const std::vector<InputError>& unusable, ProgressDisplay& display) {
    for (const InputError& error : unusable) {
        display.on_error(error.what());
    }
}

/// Writes every output; one that fails does not keep the others from being written.
std::vector<std::string> write_outputs(const Scene& scene, const Settings& settings, ProgressDisplay& display,
                                       int& status) {
    std::vector<std::string> written;
    std::int64_t done = 0;
    const auto total = static_cast<std::int64_t>(settings.outputs.size() + (settings.report ? 1 : 0));
    const int threads = settings.job.options.threads;
    const auto write = [&](const std::string& file, const auto& action) {
        try {
            action();
            written.push_back(file);
        } catch (const Error& error) {
            display.on_error(error.what());
            status = kOutOfResources;
        }
        ++done;
        display.on_progress({Phase::write, done, total, 0, static_cast<double>(done) / static_cast<double>(total)});
    };
    for (const std::string& output : settings.outputs) {
        write(output, [&] { write_output(scene, output, threads); });
    }
    if (settings.report) {
        write(*settings.report,
              [&] { write_report(scene, *settings.report, settings.material_density, threads); });
    }
    return written;
}

int run_estimate(const Settings& settings, ProgressDisplay& display, bool& unusable) {
    const Estimate planned = estimate(settings.job, display);
    display.finish();
    report_unusable(planned.unusable, display);
    unusable = unusable || !planned.unusable.empty();
    print_estimate(planned, settings.job.options);
    return kDone;
}

int run_job(const Settings& settings, ProgressDisplay& display, const Interrupts& interrupts, bool& unusable) {
    int status = kDone;
    const PackResult result = pack(settings.job, display, interrupts.token());
    report_unusable(result.unusable, display);
    unusable = unusable || !result.unusable.empty();
    if (result.failure) {
        display.on_error(result.failure->what());
        status = result.failure->kind() == ErrorKind::resource ? kOutOfResources : kCheckFailed;
    }
    const Scene scene{result.packing, result.meshes};
    const auto written = write_outputs(scene, settings, display, status);
    display.finish();
    if (settings.json) {
        fmt::print("{}\n", packing_json(scene));
    } else {
        print_summary(result, written);
    }
    if (status != kDone) return status;
    if (result.stopped == StopReason::cancelled) return kInterrupted;
    return settings.require_all && !result.packing.unplaced.empty() ? kLeftOver : kDone;
}

int run_pack(const PackArguments& arguments) {
    settle(arguments, {});  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.mesh_dir);
    Settings settings = settle(arguments, inputs.job.value_or(JobSettings{}));
    const Interrupts interrupts(settings.job.options.time_limit);
    ProgressDisplay display(settings.progress);
    report_unusable(inputs.unusable, display);
    if (inputs.parts.empty()) return inputs.unusable.empty() ? kUsage : kUnusableInput;
    settings.job.parts = inputs.parts;

    bool unusable = !inputs.unusable.empty();
    const int status = settings.dry_run ? run_estimate(settings, display, unusable)
                                        : run_job(settings, display, interrupts, unusable);
    if ((status == kDone || status == kLeftOver) && unusable && !settings.skip_unusable) return kUnusableInput;
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
        "Exit status: 0 done, also with copies left over; 2 wrong usage; 3 an input was unusable (the rest is\n"
        "packed); 4 out of memory or disk; 5 copies left over under --require-all; 130 interrupted, best packing\n"
        "so far written.");
    auto arguments = std::make_shared<PackArguments>();
    PackArguments& a = *arguments;
    sub->add_option("PART", a.parts, "what to pack")->required();
    sub->add_option("-o,--output", a.outputs, "file to write, repeatable: .json .3mf .stl .csv .png")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    sub->add_option("--report", a.report,
                    "report for people to write: .html (a page with pictures that prints well) or .csv");
    sub->add_option("--material-density", a.material_density, "g/cm3 of the material; the report then has masses");
    const std::string container = "Container";
    sub->add_option("--tray", a.tray, "container in mm [480x245x200]")->group(container);
    sub->add_option("--trays", a.trays, "containers to fill [1]")->group(container);
    sub->add_option("--gap", a.gap, "least distance between two copies, mm [0.2]")->group(container);
    sub->add_option("--wall-gap", a.wall_gap, "least distance to the walls, mm [0]")->group(container);
    const std::string input = "Input";
    sub->add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]")->group(input);
    sub->add_option("--mesh-dir", a.mesh_dir, "folder that the paths in set files start from")->group(input);
    sub->add_flag("--skip-unusable", a.skip_unusable, "exit 0 although an input was unusable")->group(input);
    const std::string search = "Search";
    sub->add_option("--voxel", a.voxel, "voxel size in mm [2]")->group(search);
    sub->add_option("--rotations", a.rotations,
                    "orientations tried: none, or a step in degrees: 90 (24 of them), 45, 30 ... [90]")
        ->group(search);
    sub->add_option("--height-penalty", a.height_penalty, "how much height costs: auto, or p of p z^3 [auto]")
        ->group(search);
    sub->add_option("--height-at", a.height_at,
                    "where height counts: bottom, or top (then before proximity) [bottom]")
        ->group(search);
    sub->add_option("--order", a.order, "which copies first: size, input, random [size]")->group(search);
    sub->add_option("--seed", a.seed, "seed of --order random and of samples [0]")->group(search);
    sub->add_flag("--refine", a.refine, "slide copies together off the grid, gap kept on the true meshes")->group(search);
    sub->add_flag("--no-refine", a.no_refine, "stay on the grid [the default for now]")->group(search);
    sub->add_option("--interlock", a.interlock, "keep copies from locking: post (repair the packing), place (only where a way out is), off [post]")
        ->group(search);
    const std::string run = "Run";
    sub->add_option("--engine", a.engine, "auto, cpu, reference (the definition, slow) [auto]")->group(run);
    sub->add_option("--threads", a.threads, "threads, 0 for all [0]; the result does not depend on it")
        ->group(run);
    sub->add_option("--memory", a.memory, "memory to plan with, like 4G [what is free]")->group(run);
    sub->add_option("--time-limit", a.time_limit, "seconds; then the best packing so far is written")
        ->check(CLI::NonNegativeNumber)
        ->group(run);
    sub->add_flag("--dry-run", a.dry_run, "say what it would take; write nothing")->group(run);
    sub->add_option("--verify-with", a.verify_with,
                    "let a second engine answer too, all or about SAMPLE placements: reference[:SAMPLE]")
        ->group(run);
    sub->add_flag("--require-all", a.require_all, "exit 5 when copies are left over")->group(run);
    sub->add_option("--progress", a.progress, "auto, bar, json, none [auto]")->group(run);
    sub->add_flag("--json", a.json, "print the packing as JSON instead of a summary")->group(run);
    return {sub, [arguments] { return run_pack(*arguments); }};
}

}  // namespace spectralpack::cli
