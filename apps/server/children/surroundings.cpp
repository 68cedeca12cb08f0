#include "children/surroundings.hpp"

#include <algorithm>
#include <array>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::server {

std::vector<CopyChange> changes_from(const Json& changes) {
    std::vector<CopyChange> made;
    for (const Json& one : changes) {
        CopyChange change{one.at("tray").get<int>() - 1, one.at("part").get<int>(), one.at("copy").get<int>(), {}};
        if (!one.at("transform").is_null()) change.transform = transform_from(one.at("transform"));
        made.push_back(change);
    }
    return made;
}

Transform transform_from(const Json& matrix) {
    Transform transform;
    for (std::size_t row = 0; row < 3; ++row) {
        const Json& numbers = matrix.at(row);
        transform.linear.rows[row] = {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
                                      numbers.at(2).get<double>()};
        transform.translation[static_cast<int>(row)] = numbers.at(3).get<double>();
    }
    return transform;
}

std::size_t placement_of(const Packing& packing, std::size_t tray, int part, int copy) {
    if (tray >= packing.trays.size()) throw UsageError("the build has no such tray");
    const std::vector<Placement>& placements = packing.trays[tray].placements;
    const auto there = std::ranges::find_if(
        placements, [&](const Placement& placement) { return placement.part == part && placement.copy == copy; });
    if (there == placements.end()) throw UsageError("the tray has no such copy");
    return static_cast<std::size_t>(there - placements.begin());
}

std::vector<Box> boxes_around(const Scene& scene, std::size_t tray) {
    std::vector<Box> mesh_boxes(scene.meshes.size()), boxes;
    for (std::size_t i = 0; i < mesh_boxes.size(); ++i) {
        if (scene.meshes[i]) mesh_boxes[i] = bounding_box(*scene.meshes[i]);
    }
    for (const Placement& placement : scene.packing.trays.at(tray).placements) {
        const Box& mesh = mesh_boxes.at(static_cast<std::size_t>(placement.part));
        boxes.push_back(bounding_box(transformed(box_surface(mesh), placement.transform)));
    }
    return boxes;
}

double distance_of(const Box& a, const Box& b) {
    Vec3 apart;
    for (int axis = 0; axis < 3; ++axis) {
        apart[axis] = std::max({0.0, a.min[axis] - b.max[axis], b.min[axis] - a.max[axis]});
    }
    return length(apart);
}

std::vector<std::string> faults_of(const Scene& scene, std::size_t tray, const std::set<std::size_t>& placements) {
    const std::vector<Box> boxes = boxes_around(scene, tray);
    double widest = 0;
    for (const PackedPart& part : scene.packing.parts) {
        widest = std::max(widest, part.gap);
    }
    Scene near = scene;
    near.packing.unplaced.clear();
    TrayPacking only;
    std::set<int> judged;  // those of `placements`, as they are numbered among the near ones
    const std::vector<Placement>& all = scene.packing.trays[tray].placements;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool own = placements.contains(i);
        if (!own && std::ranges::none_of(
                        placements, [&](std::size_t moved) { return distance_of(boxes[moved], boxes[i]) <= widest; })) {
            continue;
        }
        if (own) judged.insert(static_cast<int>(only.placements.size()));
        only.placements.push_back(all[i]);
    }
    only.layers.thickness = scene.packing.trays[tray].layers.thickness;
    near.packing.trays = {std::move(only)};
    std::vector<std::string> faults;
    for (const Finding& finding : check(near).findings) {
        // Figures and counts are of the whole.
        constexpr std::array kOfCopies{FindingKind::outside, FindingKind::overlap, FindingKind::nested,
                                       FindingKind::gap, FindingKind::transform};
        if (std::ranges::find(kOfCopies, finding.kind) == kOfCopies.end()) continue;
        if (std::ranges::any_of(finding.placements, [&](int i) { return judged.contains(i); })) {
            faults.push_back(finding.message);
        }
    }
    return faults;
}

}  // namespace spectralpack::server
