#pragma once
/// How far a mesh may move along an axis before it comes closer than a gap to another
/// (section 3.2): a continuous test, pair by pair of triangles, so nothing is tunnelled through
/// however thin it is.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/bvh.hpp"

namespace spectralpack {

/// Along +axis or -axis of x, y, z.
struct AxisDirection {
    int axis = 0;
    int sign = 1;  ///< +1 or -1
};

// In millimetres.
inline constexpr double kSlideSlack = 1e-6;       ///< a contact leaves between gap and gap + slack
inline constexpr double kSlideTolerance = 5e-10;  ///< sliding along may undercut the gap by
inline constexpr double kTouchTolerance = 1e-5;   ///< at gap 0 surfaces may overlap sideways by
inline constexpr double kRecovery = 1e-3;         ///< at gap 0 a mesh may leave an overlap of up to

/// A part of the question below: what is under two nodes of the meshes' trees. By default all.
struct SlidePart {
    std::uint32_t moving = 0, still = 0;
    double earliest = -Box::kInfinity;  ///< no contact before that way
};

/// Lowers `free` to the largest distance in [0, at_most] (but for the slack) by which `moving`, which
/// stands `offset` away from `still`'s frame, may be moved along `direction`:
///  - gap > 0: for every pair of triangles, at every moment of the move, their distance is at least
///    min(gap, their distance at the start) - kSlideTolerance. So tangential moves at exactly the
///    gap and moves away are free, a mesh that starts too near may leave but not come nearer, and
///    one whose surface touches or crosses the other's does not move. A gap under kSlideSlack
///    counts as kSlideSlack.
///  - gap 0: no two triangles pass through one another, that is, by more than kTouchTolerance as
///    seen along the direction. Faces may touch, slide along each other and part. Which side of a
///    touching face the solid is on is known if both meshes face outwards (Bvh::faces_outwards());
///    else such faces are taken to block either way.
/// Stops at the first contact; a contact that ends the move leaves between gap and gap +
/// kSlideSlack. Repeated slides do not add up: the bounds are absolute.
///
/// The distance of two triangles of which one is translated is a convex function of the way, so
/// Newton's iteration from before the contact approaches it from before, never passes it, and can
/// stop at any step (slide.cpp). Time: grows with the triangles whose swept boxes come within the
/// gap. Of several that are asked about one move at the same time, from as many threads, each is
/// spared what lies beyond `free`; what it comes to in the end depends neither on their order nor
/// on their timing. Preconditions: gap >= 0 and at_most >= 0, finite.
void slide(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double gap, double at_most,
           std::atomic<double>& free, const SlidePart& part = {});

/// Parts that together come to the same, those first that may meet first: `count` of them or more, unless fewer pairs
/// of leaves may meet at all. O(count) node pairs.
std::vector<SlidePart> slide_parts(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction,
                                   double gap, double at_most, std::size_t count);

}  // namespace spectralpack
