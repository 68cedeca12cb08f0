#include "formats/option_reader.hpp"

#include <fmt/format.h>

#include <limits>

#include "formats/number_text.hpp"

namespace spectralpack {
namespace {

VerifyWith verify_with_of(const Node& node) {
    const std::string text = node.text();
    const std::size_t colon = text.find(':');
    const auto engine = value_of(kEngineNames, std::string_view(text).substr(0, colon));
    VerifyWith verify;
    bool valid = engine.has_value();
    if (colon != std::string::npos) {
        const auto sample = parse_integer(std::string_view(text).substr(colon + 1));
        valid = valid && sample && *sample > 0 && *sample <= std::numeric_limits<int>::max();
        if (valid) verify.sample = static_cast<int>(*sample);
    }
    if (!valid) node.fail("must be an engine, or an engine and a sample size (\"reference:10\")");
    verify.engine = *engine;
    return verify;
}

}  // namespace

int trays_of(const Node& node) {
    if (!node.is_text()) return node.integer<int>(1);
    if (node.text() == "all") return 0;
    const auto number = parse_integer(node.text());
    if (!number || *number < 1 || *number > std::numeric_limits<int>::max()) {
        node.fail("must be a number or \"all\"");
    }
    return static_cast<int>(*number);
}

void read_options(const Node& node, PackOptions& o) {
    if (const auto v = node.find("tray")) o.tray = vector_of(*v);
    if (const auto v = node.find("trays")) o.trays = trays_of(*v);
    if (const auto v = node.find("try-per-tray")) o.try_per_tray = v->integer<int>(0);
    if (const auto v = node.find("printer")) o.printer = v->text();
    if (const auto v = node.find("voxel")) o.voxel = v->positive();
    if (const auto v = node.find("detail")) o.detail = v->integer<int>(1);
    if (const auto v = node.find("rotations")) {
        o.rotations = v->is_text() ? v->text() : fmt::format("{:g}", v->number());
    }
    if (const auto v = node.find("gap")) o.gap = v->number_from(0);
    if (const auto v = node.find("wall-gap")) o.wall_gap = v->number_from(0);
    if (const auto v = node.find("refine")) o.refine = v->boolean();
    if (const auto v = node.find("interlock")) o.interlock = v->one_of(kInterlockNames);
    if (const auto v = node.find("links")) o.links = v->one_of(kLinksNames);
    if (const auto v = node.find("take-out")) o.take_out = v->one_of(kTakeOutNames);
    if (const auto v = node.find("ray-spacing")) o.ray_spacing = v->positive();
    if (const auto v = node.find("height-penalty"); v && !(v->is_text() && v->text() == "auto")) {
        o.height_penalty = v->number_from(0);
    }
    if (const auto v = node.find("height-at")) o.height_at = v->one_of(kHeightNames);
    if (const auto v = node.find("open-height")) o.open_height = v->boolean();
    if (const auto v = node.find("minimise")) o.minimise = v->one_of(kMinimiseNames);
    if (const auto v = node.find("fill")) o.fill = v->boolean();
    if (const auto v = node.find("max-density")) o.max_density = v->share();
    if (const auto v = node.find("max-layer-fill")) o.max_layer_fill = v->share();
    if (const auto v = node.find("order")) o.order = v->one_of(kOrderNames);
    if (const auto v = node.find("restarts")) o.restarts = v->integer<int>(1);
    if (const auto v = node.find("beam")) o.beam = v->integer<int>(1);
    if (const auto v = node.find("engine")) o.engine = v->one_of(kEngineNames);
    if (const auto v = node.find("threads")) o.threads = v->integer<int>();
    if (const auto v = node.find("seed")) o.seed = v->integer<std::uint64_t>();
    if (const auto v = node.find("memory")) o.memory = v->integer<std::int64_t>(0);
    if (const auto v = node.find("verify-with")) o.verify_with = verify_with_of(*v);
    if (const auto v = node.find("time-limit")) o.time_limit = v->number_from(0);
}

}  // namespace spectralpack
