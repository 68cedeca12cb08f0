#pragma once
/// The edges that show the shape of a mesh: where its surface bends sharply.

#include <utility>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// Edges at which two facets meet at more than 30 degrees, or that do not have two facets.
std::vector<std::pair<Vec3, Vec3>> feature_edges(const Mesh& mesh);

}  // namespace spectralpack
