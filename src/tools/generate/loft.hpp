#pragma once
/// Solids through a row of loops: what generated round, turned and bent parts are made of. Which
/// triangles there are depends on the counts of points alone, never on coordinates.

#include <vector>

#include "spectralpack/mesh.hpp"
#include "tools/generate/outline.hpp"

namespace spectralpack::tools {

/// Points of a closed line in space, the first not repeated.
using Loop = std::vector<Vec3>;

enum class LoftEnds {
    capped,  ///< the first and the last loop are filled with fans; each must be flat and star-shaped
             ///< round its mean
    joined,  ///< the last loop leads on to the first
};

/// The closed surface through `loops`, all of one length >= 3. It faces outwards if a loop runs
/// counter-clockwise as seen from the next one (joined: on the outside of the tube that they form).
Mesh loft(const std::vector<Loop>& loops, LoftEnds ends);

Loop at_height(const Outline& outline, double z);

/// `outline` swept from z0 up to z1.
Mesh prism(const Outline& outline, double z0, double z1);

/// The same with a hole; both outlines have as many points, and neither crosses the other.
Mesh ring_prism(const Outline& outline, const Outline& hole, double z0, double z1);

/// One turn of a closed profile of (distance from the z axis > 0, height).
Mesh turned_ring(const Outline& profile, int segments);

/// One turn of a profile that leads upwards outside the axis; flat faces end it.
Mesh turned_solid(const Outline& profile, int segments);

/// A section of a sweep: where the section's origin lies and which ways its x and y lead.
struct Frame {
    Vec3 origin, x, y;
};

/// Frames square to a path, y as near to `up` as can be; the path is nowhere parallel to `up`. Where
/// it bends, a frame halves the angle. `closed`: the last point leads on to the first.
std::vector<Frame> frames_along(const std::vector<Vec3>& path, bool closed, const Vec3& up);

/// `section` carried along the path.
Mesh sweep(const std::vector<Vec3>& path, bool closed, const Outline& section, const Vec3& up = {0, 0, 1});

/// Points of a flat outline or line as a path at z = 0.
std::vector<Vec3> flat_path(const Outline& line);

}  // namespace spectralpack::tools
