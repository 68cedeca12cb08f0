#pragma once
/// Least distance of two triangles, any triangles: touching, coplanar, crossing, needles; one
/// without area is the segment or point that it is.

#include <algorithm>
#include <cmath>

#include "geometry/bvh.hpp"

namespace spectralpack {

struct ClosestPoints {
    double distance = 0;
    Vec3 a, b;  ///< a point of each triangle at that distance; equal where they meet

    /// From b to a.
    Vec3 apart() const { return a - b; }
};

/// The least of: each corner to the other triangle, each edge to each edge, and 0 where an edge
/// passes through the other triangle. Every candidate is the distance of two points of the
/// triangles, so the result is never too small by more than rounding (1e-15 of the coordinates); it
/// is too large by no more than 1e-12 of the coordinates unless edges at nearly 0 distance are
/// parallel to 1e-7 rad (then 1e-8). For accuracy move both triangles near to the origin first.
/// Preconditions: finite coordinates.
ClosestPoints closest_points(const Corners& a, const Corners& b);

inline double distance(const Corners& a, const Corners& b) { return closest_points(a, b).distance; }

/// Calls visit(from_b, separation) for the planes of the two, those with an area: a unit normal and how far a lies from
/// b along it, negative where they overlap there. Any direction gives a bound of their distance, so it does not matter
/// how exact a needle's normal is.
template <class Visit>
void for_each_plane(const Corners& a, const Corners& b, const Visit& visit) {
    for (const Corners* t : {&b, &a}) {
        const Vec3 normal = cross((*t)[1] - (*t)[0], (*t)[2] - (*t)[0]);
        const double square = dot(normal, normal);
        if (!(square > 0)) continue;
        const double a1 = dot(normal, a[1] - a[0]), a2 = dot(normal, a[2] - a[0]);
        const double b0 = dot(normal, b[0] - a[0]), b1 = dot(normal, b[1] - a[0]), b2 = dot(normal, b[2] - a[0]);
        const double above = std::min({0.0, a1, a2}) - std::max({b0, b1, b2});
        const double below = std::min({b0, b1, b2}) - std::max({0.0, a1, a2});
        const double scale = 1 / std::sqrt(square);
        above > below ? visit(scale * normal, scale * above) : visit(-scale * normal, scale * below);
    }
}

/// A lower bound of their distance, from their planes: a tenth of the work. Negative or 0 where they say nothing.
double plane_separation(const Corners& a, const Corners& b);

}  // namespace spectralpack
