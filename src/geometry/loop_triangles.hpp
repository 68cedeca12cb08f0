#pragma once
/// Flat areas bounded by loops, as triangles: what closes a mesh that was cut.

#include <cstdint>
#include <span>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct PlanePoint {
    double x = 0, y = 0;
};

using Loop = std::vector<std::uint32_t>;  ///< numbers of points, walked in a ring

/// Triangles of the area to the left of the loops: outer loops run counter-clockwise, holes clockwise, and the
/// triangles counter-clockwise. Every step of the loops is a side of one triangle, also where points lie in a row, so a
/// mesh is closed by them without new points. That holds for any loops. The triangles do not overlap where the loops
/// neither cross nor touch; those thinner than a millionth of the area's extent come only where nothing else is left.
/// Ear clipping, best ear first, holes joined to their outer loop by bridges. O(n^2) for n points.
std::vector<Triangle> fill_loops(std::span<const PlanePoint> points, const std::vector<Loop>& loops);

}  // namespace spectralpack
