#include "render/taking_apart.hpp"

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

/// How far the box's middle lies from the rear of `all`, seen along `direction` (of length 1).
double reached(const Box& box, const Box& all, const Vec3& direction) {
    double rear = 0;
    for (int axis = 0; axis < 3; ++axis) {
        rear += std::min(direction[axis] * all.min[axis], direction[axis] * all.max[axis]);
    }
    return 0.5 * dot(direction, box.min + box.max) - rear;
}

}  // namespace

std::vector<ShownCopy> show_exploded(const TrayPacking& tray, const std::vector<Box>& boxes, double factor) {
    std::vector<ShownCopy> shown(tray.placements.size());
    Box all;
    for (const Box& box : boxes) {
        all.add(box);
    }
    for (const RemovalStep& step : tray.disassembly->steps) {
        Box group;
        for (const int placement : step.placements) {
            group.add(boxes[static_cast<std::size_t>(placement)]);
        }
        const Vec3 way = walk(step.path, path_length(step.path));
        if (!(length(way) > 0)) continue;
        const Vec3 offset = walk(step.path, factor * reached(group, all, 1 / length(way) * way));
        for (const int placement : step.placements) {
            Vec3& of_copy = shown[static_cast<std::size_t>(placement)].offset;
            of_copy = of_copy + offset;
        }
    }
    return shown;
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
