#pragma once
/// Do two posed meshes share material? Touching is allowed; what counts is how deep.
///
/// Depth of a shared point: how far it lies from the surface of the one or of the other, whichever is more. Two
/// solids that a translation by t would separate share no point deeper than t. For closed meshes
///  - nothing shallower than the tolerance e is called an overlap, and
///  - everything deeper than 3 e is found, but for the limits below.
///
/// Why. Let p be in A and in B, more than 3 e from B's surface (else swap the names), and say B is the set of points
/// of non-zero winding number. Either A's surface comes deeper than sqrt(3) e into B, or all of the component of
/// {points 3 e deep in B} around p belongs to A.
///  1. Surfaces. On a triangle of A, all points that lie within e of a triangle of B are covered by that
///     triangle's footprint, and a footprint covers nothing farther than sqrt(3) e. On a convex piece of what is
///     not covered the winding number about B is constant, since B's surface is not met: one point decides.
///     A triangle with no triangle of B within 1.8 e has the same winding number all over, and the same as every
///     triangle that shares a corner with it, at that corner: so patches without contact need no point of their own,
///     except shells that have no contact at all, which get one.
///  2. Depths. Otherwise one point of the component decides. Each shell has a deep point, in advance.
/// This sees what pairs of triangles cannot show: boxes that overlap with their other faces in common planes
/// (all triangles touch or are apart), equal copies in one place, edges that cross in a face.
/// Triangles that cross deeper than e (crossing_depth) are an overlap at once: if no translation by e separates two
/// triangles, none separates the solids.
///
/// Limits. A solid whose parts hang together by necks thinner than 6 e (or that is one shell of several such) has one
/// deep point for all of them: a twin of one part laid exactly upon it can hide. Of open meshes only the crossing of
/// triangles and their surface inside a closed one is seen.

#include "spectralpack/geometry.hpp"
#include "verify/solid.hpp"

namespace spectralpack {

/// A rotation and a translation lead from the solid to the container.
struct PosedSolid {
    const Solid* solid = nullptr;
    Transform pose;
};

/// How deep the points lie that solids need for compare() with this tolerance.
inline double deep_enough(double tolerance) { return 3 * tolerance; }

struct Relation {
    enum class Kind { apart, overlap, a_within_b, b_within_a } kind = Kind::apart;
    double distance = 0;  ///< of the solids: 0 when not apart; the bound where it is not less
    double depth = 0;     ///< of the deepest shared point found
};

/// `bound`: distances above it are of no interest. Time: about that of finding the triangles near each other.
Relation compare(const PosedSolid& a, const PosedSolid& b, double tolerance, double bound);

}  // namespace spectralpack
