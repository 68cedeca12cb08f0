#include "packing/off_grid/box_room.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {
namespace {

constexpr double kTouching = 1e-9;  // mm: boxes that overlap by less touch
constexpr int kMostAsked = 1000;    // corners that `accepts` turns down before one is given up

/// Where a lower corner may not be: within `forbidden`, its faces left out.
struct Shadow {
    Box forbidden;

    bool hides(double at, int axis) const {
        return at > forbidden.min[axis] + kTouching && at < forbidden.max[axis] - kTouching;
    }
};

Box forbidden_to(const Vec3& size, double gap, const StandingBox& standing) {
    const double kept = standing.wall ? standing.gap : std::max(gap, standing.gap);
    const Vec3 all{kept, kept, kept};
    return {standing.box.min - all - size, standing.box.max + all};
}

/// Coordinates along an axis at which a box may be the lowest: the wall, and beyond each shadow.
std::vector<double> ends(const std::vector<Shadow>& shadows, int axis, double first, double last) {
    std::vector<double> at{first};
    for (const Shadow& shadow : shadows) {
        const double end = shadow.forbidden.max[axis];
        if (end > first && end <= last) at.push_back(end);
    }
    std::ranges::sort(at);
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

std::vector<Shadow> those_that_hide(const std::vector<Shadow>& shadows, double at, int axis) {
    std::vector<Shadow> hiding;
    std::ranges::copy_if(shadows, std::back_inserter(hiding),
                         [&](const Shadow& shadow) { return shadow.hides(at, axis); });
    return hiding;
}

}  // namespace

BoxRoom::BoxRoom(const Box& room, std::int64_t most_work) : room_(room), work_left_(most_work) {}

std::optional<Vec3> BoxRoom::lowest(const Vec3& size, double gap, const Accepts& accepts) {
    if (!fits(size, room_.size())) return std::nullopt;
    const Vec3 first = room_.min;
    const Vec3 last = room_.max - size + Vec3{kContainTolerance, kContainTolerance, kContainTolerance};
    std::vector<Shadow> shadows;
    for (const StandingBox& standing : standing_) {
        shadows.push_back({forbidden_to(size, gap, standing)});
    }
    const auto spend = [&](std::size_t tests) {
        return (work_left_ -= std::ssize(shadows) + static_cast<std::int64_t>(tests)) > 0;
    };
    int asked = 0;
    for (const double z : ends(shadows, 2, first.z, last.z)) {
        std::vector<Shadow> layer = those_that_hide(shadows, z, 2);
        // By where they begin along x, so that one pass over them finds the ends of what they cover together.
        std::ranges::sort(layer, {}, [](const Shadow& shadow) { return shadow.forbidden.min.x; });
        for (const double y : ends(layer, 1, first.y, last.y)) {
            if (!spend(layer.size())) return std::nullopt;
            double x = first.x;
            const auto try_here = [&] { return ++asked <= kMostAsked && accepts({x, y, z}); };
            for (const Shadow& shadow : layer) {
                if (!shadow.hides(y, 1) || shadow.forbidden.max.x - kTouching <= x) continue;
                if (shadow.forbidden.min.x + kTouching >= x && try_here()) return Vec3{x, y, z};
                x = shadow.forbidden.max.x;
                if (x > last.x) break;
            }
            if (x <= last.x && try_here()) return Vec3{x, y, z};
            if (asked > kMostAsked) return std::nullopt;
        }
    }
    return std::nullopt;
}

bool BoxRoom::is_free(const Box& box, double gap) const {
    return std::ranges::none_of(standing_, [&](const StandingBox& standing) {
        const Shadow shadow{forbidden_to(box.size(), gap, standing)};
        return shadow.hides(box.min.x, 0) && shadow.hides(box.min.y, 1) && shadow.hides(box.min.z, 2);
    });
}

std::vector<Vec3> BoxRoom::lattice(const Vec3& size, double gap, std::int64_t most) const {
    if (!fits(size, room_.size())) return {};
    std::int64_t count[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::floor((room_.size()[axis] + gap + kContainTolerance) / (size[axis] + gap));
        count[axis] = static_cast<std::int64_t>(std::clamp(along, 1.0, static_cast<double>(most)));
    }
    std::vector<Vec3> corners;
    for (std::int64_t z = 0; z < count[2]; ++z) {
        for (std::int64_t y = 0; y < count[1]; ++y) {
            for (std::int64_t x = 0; x < count[0]; ++x) {
                const Vec3 cells{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                Vec3 corner = room_.min;
                for (int axis = 0; axis < 3; ++axis) {
                    corner[axis] += cells[axis] * (size[axis] + gap);
                }
                if (is_free({corner, corner + size}, gap)) corners.push_back(corner);
                if (std::ssize(corners) >= most) return corners;
            }
        }
    }
    return corners;
}

}  // namespace spectralpack
