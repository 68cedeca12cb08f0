#pragma once
/// Least distance of two meshes.

#include "geometry/triangle_distance.hpp"

namespace spectralpack {

/// Least distance between the *surfaces* of a moved by `offset_a` and b moved by `offset_b`, and
/// where it is. Solids are not looked into: of a solid inside another it is how far its surface is
/// from the other's, not 0, and meshes whose surfaces do not cross are told apart from nested ones
/// by the caller, who knows that they began apart. Pairs at `upper_bound` or further are not looked
/// at: {upper_bound, 0, 0} is the answer where there are no nearer ones (and for a mesh without
/// triangles). The least over all pairs of closest_points(), so as exact. Time grows with the
/// number of triangles near to the other mesh.
ClosestPoints least_distance(const Bvh& a, const Vec3& offset_a, const Bvh& b, const Vec3& offset_b,
                             double upper_bound = Box::kInfinity);

}  // namespace spectralpack
