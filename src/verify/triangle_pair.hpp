#pragma once
/// Two triangles: how far apart, how deep in each other. In double precision, for triangles of any shape: distances
/// are those of two points on the triangles, and the nearest to within 1e-8 of the triangles' size; needles are
/// taken for their edges.
///
/// FCL has a kernel of its own (from PQP) that is not used: for triangles in axis-aligned positions it may return
/// the distance of a pair of points that is not the nearest (GammaUNC/PQP issue 4), and it takes triangles
/// with edges below about 2e-4 for degenerate ones. Both are pinned in tests/verify/nearness_test.cpp.

#include <array>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

using Corners = std::array<Vec3, 3>;

/// A triangle of at most this height is a needle: its normal is mostly rounding.
inline constexpr double kNeedle = 1e-7;  ///< mm

/// Least height: 2 area / longest edge; 0 for a degenerate triangle.
double least_height(const Corners& triangle);

/// Distance from a point to a triangle.
double point_triangle_distance(const Vec3& point, const Corners& triangle);

/// Distance between two triangles, 0 where they meet. Anything above `cutoff` may come back as infinity.
double triangle_distance(const Corners& a, const Corners& b, double cutoff);

/// Length of the shortest translation after which the triangles do not cross: 0 for triangles that are apart or
/// only touch (by a corner or an edge, or as two faces in one plane). By separating axes; may come out up to
/// 1e-5 of the triangles' size too large where edges are almost parallel.
double crossing_depth(const Corners& a, const Corners& b);

}  // namespace spectralpack
