#pragma once
/// How near two posed meshes come to each other, and where they touch.

#include <vector>

#include "spectralpack/geometry.hpp"
#include "verify/solid.hpp"

namespace spectralpack {

/// A triangle of each that come as near as the contact reach.
struct Contact {
    std::size_t a = 0, b = 0;
};

struct Nearness {
    double distance = 0;            ///< least distance of the surfaces; the bound where that is not less
    double crossing = 0;            ///< deepest crossing_depth found
    std::vector<Contact> contacts;  ///< all, unless the search ended early
};

/// FCL's traversal of two hierarchies, with our own distance of triangles (triangle_pair.hpp) at the leaves.
/// `b_to_a`: a rotation and a translation. Looks for contacts within `reach` and for distances below `bound`, and
/// ends at the first pair of triangles that cross deeper than `tolerance`.
Nearness find_nearness(const Solid& a, const Solid& b, const Transform& b_to_a, double reach, double bound,
                       double tolerance);

}  // namespace spectralpack
