#pragma once
/// Flat outlines that generated parts are made of. Sines and cosines come from additions and
/// multiplications alone, so that every machine makes the same bits.

#include <vector>

namespace spectralpack::tools {

struct Vec2 {
    double x = 0, y = 0;
};

/// Closed without repeating the first point; counter-clockwise unless said otherwise.
using Outline = std::vector<Vec2>;

/// The unit vector at an angle given in full turns. Quarter turns are exact.
Vec2 direction(double turns);

/// `count` >= 2 points from the angle `from` to `to` (full turns), both included; clockwise where
/// `to` is less.
Outline arc(const Vec2& centre, double radius, double from, double to, int count);

/// `count` points from angle `start` on.
Outline circle(double radius, int count, double start = 0);

/// Half axes a and b.
Outline ellipse(double a, double b, int count);

/// Round the origin; `steps` points at each corner.
Outline rounded_rectangle(double width, double depth, double radius, int steps);

/// Teeth as pairs of points between the radii `root` and `tip`: four points a tooth.
Outline gear_outline(double root, double tip, int teeth);

/// Radius * (1 + depth * cos(lobes * angle)).
Outline lobed(double radius, double depth, int lobes, int count);

}  // namespace spectralpack::tools
