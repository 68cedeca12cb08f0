#include <fmt/format.h>

#include <algorithm>
#include <charconv>
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
#include "time_probe.hpp"

namespace spectralpack::cli {
namespace {

/// The words of the command line; settle() makes options of them. Defaults that stand in PackOptions are not repeated:
/// an option that is not given leaves what the job file says, or the default.
struct PackArguments {
    std::vector<std::string> parts;
    std::string mesh_dir;
    std::optional<std::string> unit, tray, trays, container, printer, onto, rotations, interlock, links, take_out,
        height_penalty, height_at, order, engine, memory, verify_with, progress, report;
    std::optional<std::string> minimise;
    std::optional<double> max_density, max_layer_fill;
    bool open_height = false, fill = false;
    std::optional<double> gap, wall_gap, voxel, ray_spacing, time_limit, material_density;
    std::optional<std::uint64_t> seed;
    std::optional<int> threads, try_per_tray, detail, restarts, beam;
    std::vector<std::string> keep_out;
    bool physical = false;
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

const Printer& known_printer(const std::string& name) {
    const Printer* printer = find_printer(name);
    if (!printer) {
        throw UsageError(fmt::format("--printer {}: not known; --printer list names those that are", name));
    }
    return *printer;
}

int parse_trays(const std::string& text) {
    if (text == "all") return 0;
    int trays = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), trays);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size() || trays < 1) {
        throw UsageError(fmt::format("--trays takes a number of containers or all, not '{}'", text));
    }
    return trays;
}

/// x0,y0,z0,x1,y1,z1, or a mesh file.
KeepOutSource parse_keep_out(const std::string& text) {
    Vec3 corner[2];
    const char* at = text.data();
    const char* end = at + text.size();
    bool box = true;
    for (int i = 0; i < 6 && box; ++i) {
        const auto parsed = std::from_chars(at, end, corner[i / 3][i % 3]);
        box = parsed.ec == std::errc{} && (i == 5 ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == ',');
        at = parsed.ptr + 1;
    }
    if (!box) return {{}, MeshSource{text, "--keep-out"}};
    for (int axis = 0; axis < 3; ++axis) {
        if (!(corner[0][axis] < corner[1][axis]) || !std::isfinite(corner[1][axis] - corner[0][axis])) {
            throw UsageError(
                fmt::format("--keep-out {}: the second corner must lie beyond the first on every axis", text));
        }
    }
    return {{corner[0], corner[1]}};
}

/// The container: what the command line says, else the job file, else that of the build to be topped up.
void settle_container(const PackArguments& a, const JobSettings& file, Job& job) {
    job.container = file.container;
    if (a.container) {
        job.container.mesh = MeshSource{*a.container, "--container"};
    } else if (a.tray || a.printer) {
        job.container.mesh.reset();
    }
    const auto onto = a.onto ? a.onto : file.onto;
    if (onto) {
        job.onto = load_scene(*onto);
        if (!a.container && !a.tray && !a.printer && !file.sized) {
            job.options.tray = job.onto->packing.container.size;
            ContainerSource same = container_source(job.onto->packing);
            same.keep_out.insert(same.keep_out.end(), job.container.keep_out.begin(), job.container.keep_out.end());
            same.physical = same.physical || job.container.physical;
            job.container = std::move(same);
        }
    }
    for (const std::string& keep_out : a.keep_out) {
        job.container.keep_out.push_back(parse_keep_out(keep_out));
    }
    job.container.physical = job.container.physical || a.physical;
}

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

/// Two sides are a base, for packings without a ceiling.
Vec3 parse_tray(const std::string& text) {
    const bool base = std::count_if(text.begin(), text.end(), [](char c) { return c == 'x' || c == 'X'; }) == 1;
    if (!base) return parse_size(text, "--tray");
    try {
        Vec3 size = parse_size(text + "x1", "--tray");
        size.z = 0;
        return size;
    } catch (const UsageError&) {
        throw UsageError(fmt::format("--tray takes lengths in mm like 480x245x200 or 480x245, not '{}'", text));
    }
}

/// `options` with what the command line says over it.
PackOptions override_options(PackOptions options, const PackArguments& a) {
    if (a.printer) apply(known_printer(*a.printer), options);
    if (a.tray) options.tray = parse_tray(*a.tray);
    if (a.trays) options.trays = parse_trays(*a.trays);
    assign(options.try_per_tray, a.try_per_tray);
    assign(options.gap, a.gap);
    assign(options.wall_gap, a.wall_gap);
    assign(options.voxel, a.voxel);
    assign(options.detail, a.detail);
    assign(options.rotations, a.rotations);
    assign(options.seed, a.seed);
    assign(options.threads, a.threads);
    if (a.refine || a.no_refine) options.refine = !a.no_refine;
    if (a.interlock) {
        options.interlock =
            choose<Interlock>({{"off", Interlock::off}, {"post", Interlock::post}, {"place", Interlock::place}},
                              *a.interlock, "--interlock");
    }
    if (a.links) {
        options.links = choose<Links>({{"allow", Links::allow}, {"avoid", Links::avoid}}, *a.links, "--links");
    }
    if (a.take_out) {
        options.take_out = choose<TakeOut>(
            {{"smallest", TakeOut::smallest}, {"lightest", TakeOut::lightest}, {"thinnest", TakeOut::thinnest}},
            *a.take_out, "--take-out");
    }
    if (a.ray_spacing) options.ray_spacing = a.ray_spacing;
    if (a.height_penalty) {
        options.height_penalty.reset();
        if (*a.height_penalty != "auto") options.height_penalty = parse_height_penalty(*a.height_penalty);
    }
    if (a.height_at) {
        options.height_at = choose<HeightReference>(
            {{"bottom", HeightReference::bottom}, {"top", HeightReference::top}}, *a.height_at, "--height-at");
    }
    options.open_height = options.open_height || a.open_height;
    if (a.minimise) {
        options.minimise =
            choose<Minimise>({{"none", Minimise::none}, {"box", Minimise::box}}, *a.minimise, "--minimise");
    }
    options.fill = options.fill || a.fill;
    if (a.max_density) options.max_density = a.max_density;
    if (a.max_layer_fill) options.max_layer_fill = a.max_layer_fill;
    if (a.order) {
        options.order = choose<Order>({{"size", Order::size},
                                       {"volume", Order::volume},
                                       {"mixed", Order::mixed},
                                       {"input", Order::input},
                                       {"random", Order::random}},
                                      *a.order, "--order");
    }
    assign(options.restarts, a.restarts);
    assign(options.beam, a.beam);
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
        require_output_file(output);
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

int run_estimate(const Settings& settings, ProgressDisplay& display, const Interrupts& interrupts, bool& unusable) {
    const Estimate planned = estimate(settings.job, display);
    display.finish();
    report_unusable(planned.unusable, display);
    unusable = unusable || !planned.unusable.empty();
    print_estimate(planned, settings.job.options, probe_time(settings.job, kProbeSeconds, interrupts.token()));
    return interrupts.token().reason() == StopReason::cancelled ? kInterrupted : kDone;
}

int run_job(const Settings& settings, ProgressDisplay& display, const Interrupts& interrupts, bool& unusable) {
    int status = kDone;
    const PackResult result = pack(settings.job, display, interrupts.token());
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
    if (arguments.printer == "list") {
        print_printers();
        return kDone;
    }
    if (arguments.parts.empty()) throw UsageError("PART is required: name what to pack");
    settle(arguments, {});  // so that wrong usage is told before files are looked at
    const ExpandedInputs inputs = expand_inputs(arguments.parts, arguments.mesh_dir);
    Settings settings = settle(arguments, inputs.job.value_or(JobSettings{}));
    const Interrupts interrupts(settings.job.options.time_limit);
    ProgressDisplay display(settings.progress);
    report_unusable(inputs.unusable, display);
    if (inputs.parts.empty()) return inputs.unusable.empty() ? kUsage : kUnusableInput;
    settings.job.parts = inputs.parts;
    settings.job.enough_orders = interrupts.half_time();
    settle_container(arguments, inputs.job.value_or(JobSettings{}), settings.job);
    settings.job.fixed = inputs.job ? inputs.job->fixed : std::vector<FixedSource>{};

    bool unusable = !inputs.unusable.empty();
    const int status = settings.dry_run ? run_estimate(settings, display, interrupts, unusable)
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
        "--restarts and --beam look for the order on the grid, at most for half of --time-limit, and then pack in it.\n"
        "Exit status: 0 done, also with copies left over; 2 wrong usage; 3 an input was unusable (the rest is\n"
        "packed); 4 out of memory or disk; 5 copies left over under --require-all; 130 interrupted, best packing\n"
        "so far written.");
    auto arguments = std::make_shared<PackArguments>();
    PackArguments& a = *arguments;
    sub->add_option("PART", a.parts, "what to pack");
    sub->add_option("-o,--output", a.outputs, "file to write, repeatable: .json .3mf .stl .csv .png")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    sub->add_option("--report", a.report,
                    "report for people to write: .html (a page with pictures that prints well) or .csv");
    sub->add_option("--material-density", a.material_density, "g/cm3 of the material; the report then has masses");
    const std::string container = "Container";
    sub->add_option("--tray", a.tray, "container in mm; with --open-height XxY will do [480x245x200]")
        ->group(container);
    sub->add_flag("--open-height", a.open_height, "no ceiling: least height on the tray's base")->group(container);
    sub->add_option("--minimise", a.minimise, "box: a base, up to the tray's, and height of least volume [none]")
        ->group(container);
    sub->add_flag("--fill", a.fill, "as many copies as fit; counts are shares of one another")->group(container);
    sub->add_option("--max-density", a.max_density, "cap on the density, a share like 0.3")->group(container);
    sub->add_option("--max-layer-fill", a.max_layer_fill, "cap on the share of each layer's area, like 0.4")
        ->group(container);
    sub->add_option("--printer", a.printer, "build volume and customary gaps of a printer; list prints them")
        ->group(container);
    sub->add_option("--container", a.container, "closed mesh to fill instead of a box")->group(container);
    sub->add_option("--keep-out", a.keep_out,
                    "room that stays empty, repeatable: a box x0,y0,z0,x1,y1,z1 in mm, or a mesh file")
        ->take_all()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(container);
    sub->add_flag("--physical", a.physical,
                  "walls and keep-outs are really there: what leaves, leaves over the top, which is open")
        ->group(container);
    sub->add_option("--onto", a.onto, "packing file to top up: its copies stay where they are")->group(container);
    sub->add_option("--trays", a.trays, "containers to fill, a number or all [1]")->group(container);
    sub->add_option(
           "--try-per-tray", a.try_per_tray,
           "of several trays, one is full once so many parts found no place in it; 0: once all were tried [1000]")
        ->group(container);
    sub->add_option("--gap", a.gap, "least distance between two copies, mm [0.2]")->group(container);
    sub->add_option("--wall-gap", a.wall_gap, "least distance to the walls, mm [0]")->group(container);
    const std::string input = "Input";
    sub->add_option("--unit", a.unit, "unit of files that do not say: mm, inch, m [mm]")->group(input);
    sub->add_option("--mesh-dir", a.mesh_dir, "folder that the paths in set files start from")->group(input);
    sub->add_flag("--skip-unusable", a.skip_unusable, "exit 0 although an input was unusable")->group(input);
    const std::string search = "Search";
    sub->add_option("--voxel", a.voxel, "voxel size in mm [2]")->group(search);
    sub->add_option("--detail", a.detail, "copies may come as near as voxels this many times finer allow, 1 to 8 [2]")
        ->group(search);
    sub->add_option(
           "--rotations", a.rotations,
           "orientations tried: none, a step in degrees (90: 24 of them), icosahedron[:N]; each with +box for\n"
           "the turns of the part's minimum bounding box [90]")
        ->group(search);
    sub->add_option("--height-penalty", a.height_penalty, "how much height costs: auto, or p of p z^3 [auto]")
        ->group(search);
    sub->add_option(
           "--height-at", a.height_at,
           "where height counts: bottom, or top (before proximity: lower, in half the time) [bottom; top without a ceiling]")
        ->group(search);
    sub->add_option(
           "--order", a.order,
           "which copies first: size (of the box, largest first), volume (of the solid), mixed (geometric mean\n"
           "of both), random, input. Where not all fit, volume and mixed give a denser tray by letting denser\n"
           "parts in first, not by packing better; to place all as low as can be, size is best [size]")
        ->group(search);
    sub->add_option(
           "--restarts", a.restarts,
           "pack in N orders, the one asked for and others near it, and keep the best: most solid volume in the\n"
           "tray, or least height where all fits [1]")
        ->group(search);
    sub->add_option("--beam", a.beam,
                    "beam search over orders with this many states, compared with the plain order; 5 takes some\n"
                    "fifteen times as long [1: none]")
        ->group(search);
    sub->add_option("--seed", a.seed, "seed of --order random, --restarts and of samples [0]")->group(search);
    sub->add_flag("--refine", a.refine, "slide copies together off the grid, gap kept on the true meshes [the default]")
        ->group(search);
    sub->add_flag("--no-refine", a.no_refine, "stay on the grid")->group(search);
    sub->add_option("--interlock", a.interlock,
                    "keep copies from locking: post (repair the packing), place (only where a way out is), off [post]")
        ->group(search);
    sub->add_option("--links", a.links,
                    "with --interlock post, places where two copies hold each other by themselves, like links of a "
                    "chain: avoid, allow (the paper's way: taken out again afterwards) [avoid]")
        ->group(search);
    sub->add_option(
           "--take-out", a.take_out,
           "of copies that hold each other, which go first, to be put back if they may stay after all or elsewhere: "
           "thinnest (least material for its box: cages and rings), lightest (least material), smallest (the "
           "paper's: smallest boxes up to a tenth) [thinnest]")
        ->group(search);
    sub->add_option("--ray-spacing", a.ray_spacing,
                    "mm between the rays that tell which copy is straight in whose way; what they miss, flood fills "
                    "find [4 voxel / detail]")
        ->group(search);
    const std::string run = "Run";
    sub->add_option("--engine", a.engine, "auto, cpu, reference (the definition, slow) [auto]")->group(run);
    sub->add_option("--threads", a.threads, "threads, 0 for all [0]; the result does not depend on it")->group(run);
    sub->add_option("--memory", a.memory, "memory to plan with, like 4G [what is free]")->group(run);
    sub->add_option("--time-limit", a.time_limit, "seconds; then the best packing so far is written")
        ->check(CLI::NonNegativeNumber)
        ->group(run);
    sub->add_flag("--dry-run", a.dry_run,
                  "say what memory and time it would take (packs a few seconds to see); write nothing")
        ->group(run);
    sub->add_option("--verify-with", a.verify_with,
                    "let a second engine answer too, all or about SAMPLE placements: reference[:SAMPLE]")
        ->group(run);
    sub->add_flag("--require-all", a.require_all, "exit 5 when copies are left over")->group(run);
    sub->add_option("--progress", a.progress, "auto, bar, json, none [auto]")->group(run);
    sub->add_flag("--json", a.json, "print the packing as JSON instead of a summary")->group(run);
    return {sub, [arguments] { return run_pack(*arguments); }};
}

}  // namespace spectralpack::cli
