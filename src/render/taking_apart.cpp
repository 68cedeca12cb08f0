#include "render/taking_apart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/slabs.hpp"

namespace spectralpack {
namespace {

double path_length(const std::vector<Vec3>& path) {
    double sum = 0;
    for (const Vec3& move : path) {
        sum += length(move);
    }
    return sum;
}

/// Where one is after `distance` along the path; beyond its end it goes straight on.
Vec3 walk(const std::vector<Vec3>& path, double distance) {
    Vec3 at;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double move = length(path[i]);
        if (!(move > 0)) continue;
        const bool last = i + 1 == path.size();
        const double share = last ? distance / move : std::min(distance / move, 1.0);
        at = at + share * path[i];
        distance -= share * move;
    }
    return at;
}

}  // namespace

ExplodedTray show_exploded(const std::vector<Box>& boxes, const Vec3& container, double azimuth, double elevation,
                           double factor) {
    // From steeper above than this, layers would have to be very far apart.
    constexpr double kSteepest = 60, kRadians = std::numbers::pi / 180;
    const double a = azimuth * kRadians, e = std::clamp(std::abs(elevation), 0.0, kSteepest) * kRadians;
    const double depth = std::abs(std::sin(a)) * container.x + std::abs(std::cos(a)) * container.y;
    ExplodedTray tray;
    tray.copies.resize(boxes.size());
    const std::vector<Slab> slabs = slabs_of(boxes);
    double raised = 0;
    for (std::size_t i = slabs.size(); i-- > 0;) {
        double top = slabs[i].high;
        for (const int placement : slabs[i].placements) {
            tray.copies[static_cast<std::size_t>(placement)].offset.z = raised;
            top = std::max(top, boxes[static_cast<std::size_t>(placement)].max.z);
        }
        tray.floors.push_back(slabs[i].low + raised);
        raised += factor * (depth * std::tan(e) + top - slabs[i].high);
    }
    return tray;
}

std::vector<ShownCopy> show_step(const TrayPacking& tray, int step) {
    std::vector<ShownCopy> shown(tray.placements.size());
    if (step == 0) return shown;
    // Who stands with whom: 0 in the tray, else the step that one left in, from 1 on.
    std::vector<int> subassembly(tray.placements.size(), 0);
    int before = 0;
    for (int k = 1; k <= step; ++k) {
        for (const int placement : tray.disassembly->steps[static_cast<std::size_t>(k - 1)].placements) {
            int& of_copy = subassembly[static_cast<std::size_t>(placement)];
            before = of_copy;
            of_copy = k;
        }
    }
    const std::vector<Vec3>& path = tray.disassembly->steps[static_cast<std::size_t>(step - 1)].path;
    const Vec3 half_way = walk(path, path_length(path) / 2);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i].leaving = subassembly[i] == step;
        shown[i].drawn = shown[i].leaving || subassembly[i] == before;
        if (shown[i].leaving) shown[i].offset = half_way;
    }
    return shown;
}

}  // namespace spectralpack
