#pragma once
/// Indexed triangle meshes: plain values. Coordinates are the mesh file's own until a transform is applied.

#include <array>
#include <cstdint>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

using Triangle = std::array<std::uint32_t, 3>;  ///< vertex indices, counter-clockwise from outside

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

/// Box of the vertices that triangles use.
Box bounding_box(const Mesh& mesh);

/// The box's surface, two triangles a side.
Mesh box_surface(const Box& box);

/// Adds the triangles and vertices of `more` to `mesh`, after its own.
void append(Mesh& mesh, const Mesh& more);

/// The same surface, facing the other way.
Mesh inside_out(Mesh mesh);

/// Sum of signed tetrahedron volumes (Zhang and Chen 2001): exact for closed meshes, negative when inside-out.
double signed_volume(const Mesh& mesh);

double surface_area(const Mesh& mesh);

/// Every vertex moved by `transform`. A mirror (negative determinant) also turns the triangles round, so that
/// they stay counter-clockwise from outside.
Mesh transformed(const Mesh& mesh, const Transform& transform);

}  // namespace spectralpack
