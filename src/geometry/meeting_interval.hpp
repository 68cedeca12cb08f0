#pragma once
/// Two triangles of which one moves along an axis: how far they overlap as seen along it, and on which part of the way
/// they meet. In closed form; any triangles, also ones seen edge on or without area.

#include <array>

#include "geometry/bvh.hpp"
#include "geometry/slide.hpp"

namespace spectralpack {

/// A triangle in the axes of a move: `s` along it, growing in its direction, u and v across.
struct SeenTriangle {
    SeenTriangle() {}  // many are made that are never looked at: nothing is set
    SeenTriangle(const Corners& corners, const Vec3& offset, AxisDirection direction) {
        see(corners, offset, direction);
    }
    void see(const Corners& corners, const Vec3& offset, AxisDirection direction);

    /// Twice the shadow's area; positive where the triangle faces in the direction of the move.
    double facing() const;

    std::array<double, 3> u, v, s;
    double u0, u1, v0, v1, low, high;  ///< its box
    int sign;                          ///< of the move along its axis
};

/// True when the shadows overlap by more than `graze`: no translation across the move by so much parts them. Of flat
/// polygons, so the directions to try are the normals of their edges.
bool shadows_overlap(const SeenTriangle& a, const SeenTriangle& b, double graze);

/// The ways by which `a` can be moved so that it meets `b`: an interval, because the triangles are convex. First and
/// last.
struct MeetingInterval {
    double enter, leave;
};

/// Of triangles whose shadows overlap by more than kThinShadow. The wider shadow cuts the other triangle, of which at
/// most six corners are left; above the cut part the height between the two is linear, so that it is least and greatest
/// at corners. Where both shadows are thinner than kThinShadow they are segments that cross, and each triangle covers
/// an interval of heights above the crossing. Rounding: as if the triangles had been moved across by 1e-13 of their
/// coordinates; along the move that is more for steep ones, by their slope, which kThinShadow bounds.
MeetingInterval meeting_interval(const SeenTriangle& a, const SeenTriangle& b);

inline constexpr double kThinShadow = 1e-6;  ///< mm

}  // namespace spectralpack
