#pragma once
/// Quadric simplification (Garland and Heckbert 1997), by meshoptimizer.

#include <cstddef>

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

/// `mesh` with edges collapsed into one of their ends until at most `triangles` are left, or until the
/// next collapse would move the surface by more than `error` of the mesh's longest side. The vertices
/// that stay keep their coordinates. Collapsing maps vertices to vertices, so a closed mesh stays closed;
/// it may come to touch or cross itself. About O(n log n).
Mesh simplified(const Mesh& mesh, std::size_t triangles, double error);

}  // namespace spectralpack::tools
