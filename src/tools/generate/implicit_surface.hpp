#pragma once
/// Surfaces of bodies that are given by a field, as meshes.

#include <functional>

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

using Field = std::function<double(const Vec3&)>;  ///< negative inside

/// Where the field is 0: closed, outward, without self-intersections, the same bits on every machine if the field's
/// values are. Marching tetrahedra, six to a cube of side `step`; vertices keep a twentieth of an edge away from the
/// grid's points, so there are no needles. The field is positive on the sides of `box`.
Mesh surface_of(const Field& field, const Box& box, double step);

}  // namespace spectralpack::tools
