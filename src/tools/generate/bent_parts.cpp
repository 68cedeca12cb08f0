#include "tools/generate/bent_parts.hpp"

#include "tools/generate/loft.hpp"

namespace spectralpack::tools {
namespace {

constexpr int kAround = 12;  ///< points of a round section

Outline joined(Outline first, const Outline& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// Two half circles of `radius` whose centres are 2 * half apart along x.
Outline racetrack(double half, double radius, int steps) {
    return joined(arc({half, 0}, radius, -0.25, 0.25, steps), arc({-half, 0}, radius, 0.25, 0.75, steps));
}

}  // namespace

Mesh ring(Dice& dice, double size) {
    const double thick = dice.between(0.03, 0.08) * size;
    return sweep(flat_path(circle(size / 2 - thick, 48)), true, circle(thick, kAround));
}

Mesh link(Dice& dice, double size) {
    const double thick = dice.between(0.035, 0.07) * size, radius = dice.between(0.18, 0.35) * size;
    return sweep(flat_path(racetrack(size / 2 - thick - radius, radius, 16)), true, circle(thick, kAround));
}

Mesh curb_link(Dice& dice, double size) {
    const double thick = dice.between(0.04, 0.065) * size, radius = dice.between(0.2, 0.3) * size;
    std::vector<Vec3> path = flat_path(racetrack(size / 2 - thick - radius, radius, 16));
    const double twist = dice.between(0.08, 0.2) / size;  // turns per mm
    for (Vec3& p : path) {
        const Vec2 d = direction(twist * p.x);
        p = {p.x, d.x * p.y, d.y * p.y};
    }
    return sweep(path, true, circle(thick, kAround));
}

Mesh poly_ring(Dice& dice, double size) {
    const double thick = dice.between(0.035, 0.07) * size;
    const int corners = dice.number(3, 8);
    return sweep(flat_path(circle(size / 2 - thick, corners)), true, circle(thick, kAround));
}

Mesh c_hook(Dice& dice, double size) {
    const double thick = dice.between(0.04, 0.09) * size, gap = dice.between(0.1, 0.4);
    return sweep(flat_path(arc({}, size / 2 - thick, gap / 2, 1 - gap / 2, 40)), false, circle(thick, kAround));
}

Mesh j_hook(Dice& dice, double size) {
    const double thick = dice.between(0.02, 0.045) * size, radius = dice.between(0.12, 0.25) * size;
    const double length = size - radius - thick;
    return sweep(
        flat_path(joined({{radius, -length}, {radius, -length / 2}}, arc({}, radius, 0, dice.between(0.45, 0.65), 24))),
        false, circle(thick, kAround));
}

Mesh s_hook(Dice& dice, double size) {
    const double thick = dice.between(0.025, 0.05) * size, radius = (size / 2 - thick) / 2;
    const double open = dice.between(0.1, 0.3);
    const Outline upper = arc({0, radius}, radius, open, 0.75, 24);
    Outline lower = arc({0, -radius}, radius, 0.25, -0.5 + open, 24);
    lower.erase(lower.begin());  // both pass through the middle
    return sweep(flat_path(joined(upper, lower)), false, circle(thick, kAround));
}

Mesh clip(Dice& dice, double size) {
    const double wall = dice.between(0.05, 0.1) * size, width = dice.between(0.15, 0.6) * size;
    const double gap = dice.between(0.2, 0.35), radius = size / 2 - wall;
    const Outline section{
        {-wall / 2, -width / 2}, {wall / 2, -width / 2}, {wall / 2, width / 2}, {-wall / 2, width / 2}};
    Outline line = arc({}, radius, gap / 2, 1 - gap / 2, 36);
    const Vec2 first = direction(gap / 2 - 0.06), last = direction(1 - gap / 2 + 0.06);
    const double lip = 1.25 * radius;
    line.insert(line.begin(), {lip * first.x, lip * first.y});
    line.push_back({lip * last.x, lip * last.y});
    return sweep(flat_path(line), false, section);
}

Mesh handle(Dice& dice, double size) {
    const double thick = dice.between(0.025, 0.05) * size, radius = dice.between(0.1, 0.25) * size;
    const double half = size / 2 - thick, deep = radius + dice.between(0.05, 0.3) * size;
    const Outline line = joined(joined({{half, -deep}}, arc({half - radius, -radius}, radius, 0, 0.25, 8)),
                                joined(arc({radius - half, -radius}, radius, 0.25, 0.5, 8), {{-half, -deep}}));
    return sweep(flat_path(line), false, circle(thick, kAround));
}

Mesh spring(Dice& dice, double size) {
    const int turns = dice.number(3, 7), steps = 24;
    const double radius = dice.between(0.15, 0.35) * size, pitch = 0.9 * size / turns;
    const double thick = dice.between(0.15, 0.3) * pitch;
    std::vector<Vec3> path;
    for (int i = 0; i <= turns * steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 d = direction(t);
        path.push_back({radius * d.x, radius * d.y, pitch * t});
    }
    return sweep(path, false, circle(thick, 8));
}

Mesh knot(Dice& dice, double size) {
    const int winds = dice.chance(0.6) ? 3 : 5, steps = 96;
    const double swing = dice.between(0.3, 0.45), thick = dice.between(0.12, winds == 3 ? 0.22 : 0.17);
    const double scale = size / 2 / (1 + swing + thick);
    std::vector<Vec3> path;
    for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 round = direction(2 * t), wind = direction(winds * t);
        const double r = 1 + swing * wind.x;
        path.push_back(scale * Vec3{r * round.x, r * round.y, swing * wind.y});
    }
    return sweep(path, true, circle(scale * thick, 10));
}

Mesh elbow(Dice& dice, double size) {
    const double tube = dice.between(0.12, 0.2) * size, wall = dice.between(0.12, 0.25) * tube;
    const double radius = size - tube, straight = dice.between(0.06, 0.3) * size;
    const std::vector<Vec3> path =
        flat_path(joined(joined({{radius, -straight}}, arc({}, radius, 0, 0.25, 10)), {{-straight, radius}}));
    std::vector<Loop> loops;
    const auto add = [&](const Frame& frame, double r) {
        Loop loop;
        for (const Vec2& p : circle(r, 20)) {
            loop.push_back(frame.origin + p.x * frame.x + p.y * frame.y);
        }
        loops.push_back(std::move(loop));
    };
    const std::vector<Frame> frames = frames_along(path, false, {0, 0, 1});
    for (std::size_t i = 0; i < frames.size(); ++i) {
        add(frames[i], tube);
    }
    for (std::size_t i = frames.size(); i-- > 0;) {
        add(frames[i], tube - wall);
    }
    return loft(loops, LoftEnds::joined);
}

Mesh distorted_torus(Dice& dice, double size) {
    const double stretch = dice.between(0.65, 1), sway = dice.between(0, 0.15), dent = dice.between(0, 0.06);
    const double thick = dice.between(0.12, 0.19), flat = dice.between(0.8, 1.2);
    const double phase = dice.between(0, 1), other = dice.between(0, 1);
    const int waves = dice.number(2, 3), dents = dice.number(2, 4);
    std::vector<Vec3> path;
    for (int i = 0; i < 48; ++i) {
        const double t = i / 48.0;
        const Vec2 d = direction(t);
        const double r = size / 2 * (1 + dent * direction(dents * t + other).x);
        path.push_back({r * d.x, stretch * r * d.y, size / 2 * sway * direction(waves * t + phase).x});
    }
    return sweep(path, true, ellipse(size / 2 * thick * flat, size / 2 * thick / flat, 14));
}

}  // namespace spectralpack::tools
