#pragma once
/// Whether a mesh can be moved along an axis past another, up to small overlaps (section 4.4): a yes or no for every
/// pair of triangles in closed form, where slide() says how far and iterates.

#include "geometry/bvh.hpp"
#include "geometry/slide.hpp"

namespace spectralpack {

/// True when `moving`, which stands `offset` away from `still`'s frame, may be moved by `way` along `direction` without
/// passing through `still`. Of two triangles whose shadows along the move overlap by more than `graze`, none may enter
/// the other before the end of the way (kSlideSlack before it counts as its end). That they meet where the move starts
/// is as for slide() at gap 0: what overlaps by up to kRecovery may leave, and may not go further in; two faces that
/// look away from each other part, those that look at each other do not enter. Which side of a touching face the solid
/// is on is known if both meshes face outwards (Bvh::faces_outwards()); else such faces block either way.
///
/// Ends at the first pair in the way, wherever on it that is. Time: grows with the pairs of triangles whose shadows'
/// boxes overlap, less those that lie behind. Preconditions: graze >= kTouchTolerance, way >= 0, finite.
bool slides_past(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double graze,
                 double way);

}  // namespace spectralpack
