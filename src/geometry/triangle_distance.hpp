#pragma once
/// Least distance of two triangles, any triangles: touching, coplanar, crossing, needles; one
/// without area is the segment or point that it is.

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

/// A lower bound of the distance between b and a moved by any part of `sweep`, from the planes of
/// the two: a tenth of the work. Negative or 0 where the planes say nothing.
double plane_separation(const Corners& a, const Corners& b, const Vec3& sweep);

}  // namespace spectralpack
