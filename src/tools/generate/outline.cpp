#include "tools/generate/outline.hpp"

#include <cmath>

namespace spectralpack::tools {

Vec2 direction(double turns) {
    constexpr double kTau = 6.283185307179586;
    const double part = turns - std::floor(turns);
    const int quarter = static_cast<int>(std::floor(4 * part + 0.5));
    const double angle = (part - 0.25 * quarter) * kTau;  // at most an eighth of a turn either way
    const double square = angle * angle;
    double sine = 0, cosine = 0;
    for (int k = 8; k >= 0; --k) {  // Taylor series after Horner; the next terms are below 1e-16
        sine = 1 - square / ((2 * k + 2) * (2 * k + 3)) * sine;
        cosine = 1 - square / ((2 * k + 1) * (2 * k + 2)) * cosine;
    }
    sine *= angle;
    switch (quarter % 4) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

Outline arc(const Vec2& centre, double radius, double from, double to, int count) {
    Outline points;
    for (int i = 0; i < count; ++i) {
        const Vec2 d = direction(from + (to - from) * i / (count - 1));
        points.push_back({centre.x + radius * d.x, centre.y + radius * d.y});
    }
    return points;
}

Outline circle(double radius, int count, double start) {
    Outline points;
    for (int i = 0; i < count; ++i) {
        const Vec2 d = direction(start + static_cast<double>(i) / count);
        points.push_back({radius * d.x, radius * d.y});
    }
    return points;
}

Outline ellipse(double a, double b, int count) {
    Outline points = circle(1, count);
    for (Vec2& p : points) {
        p = {a * p.x, b * p.y};
    }
    return points;
}

Outline rounded_rectangle(double width, double depth, double radius, int steps) {
    const double x = width / 2 - radius, y = depth / 2 - radius;
    const Vec2 corners[4] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
    Outline points;
    for (int k = 0; k < 4; ++k) {
        const Outline corner = arc(corners[k], radius, 0.25 * k, 0.25 * (k + 1), steps);
        points.insert(points.end(), corner.begin(), corner.end());
    }
    return points;
}

Outline gear_outline(double root, double tip, int teeth) {
    Outline points;
    for (int i = 0; i < teeth; ++i) {
        const double shares[4] = {0, 0.18, 0.42, 0.6};
        for (int k = 0; k < 4; ++k) {
            const Vec2 d = direction((i + shares[k]) / teeth);
            const double r = k == 0 || k == 3 ? root : tip;
            points.push_back({r * d.x, r * d.y});
        }
    }
    return points;
}

Outline lobed(double radius, double depth, int lobes, int count) {
    Outline points;
    for (int i = 0; i < count; ++i) {
        const double turns = static_cast<double>(i) / count;
        const double r = radius * (1 + depth * direction(lobes * turns).x);
        const Vec2 d = direction(turns);
        points.push_back({r * d.x, r * d.y});
    }
    return points;
}

}  // namespace spectralpack::tools
