#include "pack_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "choose.hpp"
#include "text.hpp"

namespace spectralpack::cli {
namespace {

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

}  // namespace

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

}  // namespace spectralpack::cli
