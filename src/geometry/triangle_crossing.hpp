#pragma once
/// Whether triangles of one mesh cut through one another.

#include <optional>

#include "geometry/bvh.hpp"
#include "spectralpack/mesh_figures.hpp"

namespace spectralpack {

/// The middle of the segment that two triangles share, where they cross properly: each has corners
/// further than `tolerance` on both sides of the other's plane, and the interiors meet along more
/// than `tolerance`. Touching is not crossing, nor is lying on one another in one plane. Equal
/// corners count as the same vertex. After Moeller, "A fast triangle-triangle intersection test"
/// (1997).
std::optional<Vec3> crossing_point(const Corners& a, const Corners& b, double tolerance);

/// About O(n log n) for surfaces; work is bounded, so that a mesh of triangles that all lie in one
/// another's boxes takes seconds, not hours. Equal coordinates are taken for the same vertex.
SelfCrossings self_crossings(const Mesh& mesh, double tolerance);

}  // namespace spectralpack
