#pragma once
/// Convex hulls, by Qhull. The one place that sees it.

#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

struct ConvexHull {
    std::vector<Vec3> vertices;  ///< some of the points, in their order
    std::vector<Vec3> normals;   ///< of the facets, unit vectors outwards; triangulated facets repeat theirs
    std::vector<Vec3> edges;     ///< one end to the other, each once, those within a triangulated facet too
};

/// Empty where the points span no volume (up to rounding).
ConvexHull convex_hull(const std::vector<Vec3>& points);

}  // namespace spectralpack
