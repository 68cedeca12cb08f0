#pragma once
/// The laboratory: exact distances between meshes.

#include "spectralpack/geometry.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack::lab {

struct Distance {
    double value = 0;       ///< mm; 0 where the surfaces meet
    Vec3 point_a, point_b;  ///< the nearest points, one on each surface, after the transforms
};

/// Least distance between the surfaces of two posed meshes. Exact but for rounding: the least over all pairs of
/// triangles. Solids are not looked into: a mesh inside another has the distance of the surfaces. Both need triangles:
/// throws InputError for a mesh that has none. Grows with the triangles that are near to the other mesh.
Distance distance(const Mesh& a, const Transform& pose_a, const Mesh& b, const Transform& pose_b);

}  // namespace spectralpack::lab
