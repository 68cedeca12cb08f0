#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupts.hpp"
#include "progress_display.hpp"
#include "summary.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

/// The words of the command line; settle() makes options of them.
struct PackArguments {
    std::vector<std::string> parts;
    std::string mesh_dir;
    std::string unit = "mm";
    std::string tray = "480x245x200";
    std::string trays = "1";
    std::string interlock = "off";
    std::string height_penalty = "auto";
    std::string height_at = "bottom";
    std::string order = "size";
    std::string engine = "auto";
    std::string memory;
    std::string verify_with;
    std::string progress = "auto";
    double time_limit = -1;
    std::vector<std::string> outputs;
    bool refine = false, no_refine = false;
    bool dry_run = false, json = false, skip_unusable = false, require_all = false;
    PackOptions options;
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

/// Checks what can be checked before any work: words, endings, folders.
PackOptions settle(const PackArguments& arguments) {
    PackOptions options = arguments.options;
    options.tray = parse_size(arguments.tray, "--tray");
    if (arguments.trays != "1") throw UsageError("--trays: several containers are not built yet: only 1");
    options.refine = arguments.refine && !arguments.no_refine;
    options.interlock = choose<Interlock>(
        {{"off", Interlock::off}, {"post", Interlock::post}, {"place", Interlock::place}},
        arguments.interlock, "--interlock");
    if (arguments.height_penalty != "auto") {
        std::size_t used = 0;
        try {
            options.height_penalty = std::stod(arguments.height_penalty, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used != arguments.height_penalty.size()) {
            throw UsageError("--height-penalty takes 'auto' or a number, not '" + arguments.height_penalty + "'");
        }
    }
    options.height_at = choose<HeightReference>(
        {{"bottom", HeightReference::bottom}, {"top", HeightReference::top}}, arguments.height_at,
        "--height-at");
    options.order = choose<Order>({{"size", Order::size}, {"input", Order::input}, {"random", Order::random}},
                                  arguments.order, "--order");
    options.engine = choose(kEngines, arguments.engine, "--engine");
    if (!arguments.memory.empty()) options.memory = parse_bytes(arguments.memory, "--memory");
    if (!arguments.verify_with.empty()) options.verify_with = parse_verify(arguments.verify_with);
    if (arguments.time_limit >= 0) options.time_limit = arguments.time_limit;
    for (const std::string& output : arguments.outputs) {
        if (!is_output_file(output)) {
            throw UsageError(fmt::format("-o {}: cannot tell the kind of file by its ending; use one of {}", output,
                                         output_endings()));
        }
        const auto folder = std::filesystem::path(output).parent_path();
        if (!folder.empty() && !std::filesystem::is_directory(folder)) {
            throw UsageError(fmt::format("-o {}: there is no folder {}", output, folder.string()));
        }
    }
    return options;
}

void report_unusable(const std::vector<InputError>& unusable) {
    for (const InputError& error : unusable) {
        fmt::print(stderr, "spectralpack: {}\n", error.what());
    }
}

/// Writes every output; one that fails does not keep the others from being written.
std::vector<std::string> write_outputs(const Scene& scene, const PackArguments& arguments, int& status) {
    std::vector<std::string> written;
    for (const std::string& output : arguments.outputs) {
        try {
            write_output(scene, output, arguments.options.threads);
            written.push_back(output);
        } catch (const Error& error) {
            fmt::print(stderr, "spectralpack: {}\n", error.what());
            status = kOutOfResources;
        }
    }
    return written;
}

int run_pack(const PackArguments& arguments) {
    Job job;
    job.options = settle(arguments);
    job.unit = choose<double>({{"mm", 1.0}, {"inch", 25.4}, {"m", 1000.0}}, arguments.unit, "--unit");
    const Interrupts interrupts(job.options.time_limit);
    ProgressDisplay display(choose<ProgressStyle>({{"auto", ProgressStyle::automatic},
                                                   {"bar", ProgressStyle::bar},
                                                   {"json", ProgressStyle::json},
                                                   {"none", ProgressStyle::none}},
                                                  arguments.progress, "--progress"));
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.mesh_dir);
    report_unusable(inputs.unusable);
    if (inputs.parts.empty()) return inputs.unusable.empty() ? kUsage : kUnusableInput;
    job.parts = inputs.parts;

    int status = kDone;
    bool unusable = !inputs.unusable.empty();
    if (arguments.dry_run) {
        const Estimate planned = estimate(job, display);
        display.finish();
        report_unusable(planned.unusable);
        unusable = unusable || !planned.unusable.empty();
        print_estimate(planned, job.options);
    } else {
        const PackResult result = pack(job, display, interrupts.token());
        display.finish();
        report_unusable(result.unusable);
        unusable = unusable || !result.unusable.empty();
        if (result.failure) {
            fmt::print(stderr, "spectralpack: {}\n", result.failure->what());
            status = result.failure->kind() == ErrorKind::resource ? kOutOfResources : kCheckFailed;
        }
        const Scene scene{result.packing, result.meshes};
        const auto written = write_outputs(scene, arguments, status);
        if (arguments.json) {
            fmt::print("{}\n", packing_json(scene));
        } else {
            print_summary(result, written);
        }
        if (status == kDone && result.stopped == StopReason::cancelled) status = kInterrupted;
        if (status == kDone && arguments.require_all && !result.packing.unplaced.empty()) status = kLeftOver;
    }
    if ((status == kDone || status == kLeftOver) && unusable && !arguments.skip_unusable) {
        status = kUnusableInput;
    }
    return status;
}

}  // namespace

Command add_pack_command(CLI::App& app) {
    auto* sub = app.add_subcommand("pack", "Pack parts into a container");
    sub->footer(
        "PART is a mesh (.stl .obj .3mf .ply .off), FILE:COUNT, FILE:COUNT@SCALE, a folder of meshes, or a set\n"
        "file (.csv with columns mesh,count,scale).\n"
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
    const std::string container = "Container";
    sub->add_option("--tray", a.tray, "container in mm [480x245x200]")->group(container);
    sub->add_option("--trays", a.trays, "containers to fill [1]")->group(container);
    sub->add_option("--gap", a.options.gap, "least distance between two copies, mm [0.2]")->group(container);
    sub->add_option("--wall-gap", a.options.wall_gap, "least distance to the walls, mm [0]")->group(container);
    const std::string input = "Input";
    sub->add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]")->group(input);
    sub->add_option("--mesh-dir", a.mesh_dir, "folder that the paths in set files start from")->group(input);
    sub->add_flag("--skip-unusable", a.skip_unusable, "exit 0 although an input was unusable")->group(input);
    const std::string search = "Search";
    sub->add_option("--voxel", a.options.voxel, "voxel size in mm [2]")->group(search);
    sub->add_option("--rotations", a.options.rotations,
                    "orientations tried: none, or a step in degrees: 90 (24 of them), 45, 30 ... [90]")
        ->group(search);
    sub->add_option("--height-penalty", a.height_penalty, "how much height costs: auto, or p of p z^3 [auto]")
        ->group(search);
    sub->add_option("--height-at", a.height_at,
                    "where height counts: bottom, or top (then before proximity) [bottom]")
        ->group(search);
    sub->add_option("--order", a.order, "which copies first: size, input, random [size]")->group(search);
    sub->add_option("--seed", a.options.seed, "seed of --order random and of samples [0]")->group(search);
    sub->add_flag("--refine", a.refine, "slide copies together off the grid (not built yet)")->group(search);
    sub->add_flag("--no-refine", a.no_refine, "stay on the grid (the default for now)")->group(search);
    sub->add_option("--interlock", a.interlock, "keep copies from locking: off (post, place: not built yet) [off]")
        ->group(search);
    const std::string run = "Run";
    sub->add_option("--engine", a.engine, "auto, cpu, reference (the definition, slow) [auto]")->group(run);
    sub->add_option("--threads", a.options.threads, "threads, 0 for all [0]; the result does not depend on it")
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
