#pragma once
/// Ray casting (section 4.4): the blocking graph's edges that parallel rays find.

#include <vector>

#include "core/parallel.hpp"
#include "disassembly/body.hpp"
#include "disassembly/graph/blocking_graph.hpp"

namespace spectralpack {

/// Casts rays along x, y and z, `spacing` mm apart, and adds an edge wherever one passes a point of a copy and later
/// one of another. Rays miss what is thinner than their spacing, but what they find is so: moving along the ray the
/// one would meet the other, by more than kRayTolerance. `parts` in the graph's order.
///
/// All rays of a direction lie on a square grid, so a triangle's hits are those grid points that its projection
/// covers: scan conversion finds them without a tree. Of each copy a ray needs to know the first and the last hit
/// only. O(triangles + hits + copies met by a ray, squared, summed over the rays).
void cast_rays(const std::vector<const Body*>& parts, double spacing, BlockingGraph& graph, const Workers& workers);

/// Hits nearer to each other than this, mm, are of copies that touch: none is behind the other.
inline constexpr double kRayTolerance = 2e-3;

}  // namespace spectralpack
