#pragma once
/// Normals for shading: smooth across curved surfaces, sharp at creases.

#include <array>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

using CornerNormals = std::array<std::array<float, 3>, 3>;  ///< one unit vector a corner

/// For each corner of each triangle the mean normal of the triangles round that vertex that lie
/// within 32 degrees of this one, weighted by their angle there and by their area, so that a large
/// flat face beside a small bevel stays flat. A triangle of no area has zero vectors. Linear time:
/// at vertices of more than 128 triangles corners keep their own triangle's normal.
std::vector<CornerNormals> corner_normals(const Mesh& mesh);

}  // namespace spectralpack
