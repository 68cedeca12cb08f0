#pragma once
/// A solid moves in a straight line past another that stands: do they come to share material on the way?
///
/// Touching and sliding along a contact is allowed; what counts is how deep, as in overlap.hpp. If the two share
/// nothing deeper than e at the start, then
///  - what is reported are crossings of triangles deeper than e, or an overlap that compare() finds at some time, and
///  - all that comes to share points deeper than 6 e is found, but for the limits below, however thin and however fast:
///    no time is sampled.
///
/// Why. Let a point of A be deep in B at some time that was not at the start. Forward of it, along the move, A ends in
/// a triangle S (facing forward), which has then been as deep in B: so S has gone through a triangle T of B (facing
/// back), and around that point all of S has. Seen along the move, the outlines of such S and T overlap in polygons
/// that cover the surroundings of the point.
///  1. Unless S and T are parallel they cross on the way, the deeper the larger their common polygon. Crossings are
///     found exactly (triangle_sweep.hpp).
///  2. If they are all but parallel they go through one another flatly and never cross deep. But then the solids behind
///     them share, 6 e after the meeting, a layer of that thickness: compare() at that time decides.
/// Two triangles that lie on each other at the start and part, or are turned away from each other, share nothing.
///
/// Limits. Where all polygons are narrower than 2 e (both meshes finer than a few micrometres) nothing is seen of them.
/// An end of the move within 6 e of a flat meeting is judged as far as it went. Of open meshes only crossings are seen.

#include "verify/overlap.hpp"

namespace spectralpack {

struct SweepResult {
    double depth = 0;      ///< deepest penetration found, at least so much; 0: none above the tolerance
    double travelled = 0;  ///< where on the way, mm
};

/// Moves `a` by `move` (in the poses' space) past `b`. Time: about that of finding the pairs of triangles whose boxes,
/// turned with their solids, meet on the way.
SweepResult sweep(const PosedSolid& a, const PosedSolid& b, const Vec3& move, double tolerance);

}  // namespace spectralpack
