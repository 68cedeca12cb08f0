#pragma once
/// How far a triangle is from a voxel.

#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Whether some point of the triangle is nearer than `distance` > 0 to the closed unit cube around
/// the origin (corners at +-0.5). Exact but for rounding; cheap where the triangle is clearly near
/// or far.
bool nearer_than(const GridTriangle& triangle, double distance);

/// Square of the Euclidean distance between the closed unit cube around the origin and the
/// triangle, 0 where they meet.
double squared_box_distance(const GridTriangle& triangle);

}  // namespace spectralpack
