#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <utility>

#include <spectralpack/lab/distance.hpp>
#include <spectralpack/spectralpack.hpp>

#include "children/children.hpp"
#include "children/surroundings.hpp"

namespace spectralpack::server {
namespace {

/// Nearest of the box's sides, as one looks at the tray from the front.
Json wall_of(const Box& copy, const Packing& packing) {
    constexpr std::array<const char*, 3> kLower{"left", "front", "bottom"}, kUpper{"right", "back", "top"};
    const Container& container = packing.container;
    Json nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const char* side, double distance) {
        if (distance >= least) return;
        least = distance;
        nearest = {{"side", side}, {"distance", distance}, {"gap", packing.options.wall_gap}};
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        look(kLower[i], copy.min[axis]);
        if (axis < 2 || !container.open_height) look(kUpper[i], container.size[axis] - copy.max[axis]);
    }
    return nearest;
}

/// The two copies that are nearest to one, the nearest first; null where there is none.
std::pair<Json, Json> nearest_copies(const Scene& scene, std::size_t tray, std::size_t asked) {
    const std::vector<Placement>& placements = scene.packing.trays[tray].placements;
    const auto part_of = [&](std::size_t i) { return static_cast<std::size_t>(placements[i].part); };
    const auto mesh_of = [&](std::size_t i) -> const Mesh& { return *scene.meshes.at(part_of(i)); };
    std::vector<Box> boxes = boxes_around(scene, tray);
    boxes[asked] = bounding_box(transformed(mesh_of(asked), placements[asked].transform));
    std::vector<std::pair<double, std::size_t>> others;  // no nearer than that
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (i != asked) others.emplace_back(distance_of(boxes[asked], boxes[i]), i);
    }
    std::ranges::sort(others);
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::pair<double, Json> nearest{kFar, nullptr}, next{kFar, nullptr};
    for (const auto& [at_least, i] : others) {
        if (at_least >= next.first) break;
        const double distance =
            lab::distance(mesh_of(asked), placements[asked].transform, mesh_of(i), placements[i].transform).value;
        if (distance >= next.first) continue;
        const std::vector<PackedPart>& parts = scene.packing.parts;
        next = {distance,
                {{"part", placements[i].part},
                 {"copy", placements[i].copy},
                 {"distance", distance},
                 {"gap", std::max(parts[part_of(asked)].gap, parts[part_of(i)].gap)}}};
        if (next.first < nearest.first) std::swap(next, nearest);
    }
    return {nearest.second, next.second};
}

}  // namespace

int print_clearance(const std::vector<std::string>& arguments) {
    const std::optional<Json> asked = read_json(arguments.at(0));
    if (!asked) throw UsageError("nothing was asked");
    Scene scene = load_scene("packing.json");
    const auto tray = asked->at("tray").get<std::size_t>() - 1;
    std::size_t at = 0;
    if (asked->contains("transform")) {
        Json changes = asked->value("changes", Json::array());
        Json own = *asked;
        own.erase("changes");
        changes.push_back(own);
        scene.packing = changed(scene, changes_from(changes));
        at = placement_of(scene.packing, tray, asked->at("part").get<int>(), asked->at("copy").get<int>());
    } else {
        if (tray >= scene.packing.trays.size()) throw UsageError("the build has no such tray");
        at = asked->at("placement").get<std::size_t>();
        if (at >= scene.packing.trays[tray].placements.size()) throw UsageError("the tray has no such copy");
    }
    const Placement& placement = scene.packing.trays[tray].placements[at];
    const Box box =
        bounding_box(transformed(*scene.meshes.at(static_cast<std::size_t>(placement.part)), placement.transform));
    const auto [nearest, next] = nearest_copies(scene, tray, at);
    const Json said{{"part", placement.part},
                    {"copy", placement.copy},
                    {"tray", tray + 1},
                    {"nearest", nearest},
                    {"next", next},
                    {"wall", scene.packing.container.mesh ? Json() : wall_of(box, scene.packing)},
                    {"clear", faults_of(scene, tray, {at}).empty()}};
    std::printf("%s\n", said.dump().c_str());
    return 0;
}

}  // namespace spectralpack::server
