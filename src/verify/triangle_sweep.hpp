#pragma once
/// One triangle moves past another in a straight line: do they cross on the way, and how deep?

#include "verify/triangle_pair.hpp"

namespace spectralpack {

/// Pairs that cover no more than so many tolerances along some axis, both together, count as flat there.
inline constexpr double kFlatWidth = 8;
/// So many tolerances beyond a flat meeting the solids share points deep enough for compare() to find.
inline constexpr double kFlatReach = 6;

struct TrianglePassage {
    double depth = 0;    ///< deepest crossing_depth on the way where that is above the tolerance; else 0
    double at = 0;       ///< when, as a share of the move
    bool flat = false;   ///< the one goes through the other flatly: no crossing is deep, what is behind them may be
    double look_at = 0;  ///< when, as a share of the move, what is behind them shows
    bool starts_flat = false;  ///< they lie on each other when the move starts
};

/// Triangle `a` moves by `move`, `b` stands. Exact but for rounding: at time t the triangles cross deeper than e
/// exactly if on every axis of the separating axis theorem they overlap by more than e, and on each axis that is so for
/// an interval of t (cleared of both ends of the other triangle's); the intersection of these intervals decides. No
/// time is sampled, so nothing is stepped over, and a contact that slides (overlap of about 0 along the normal all the
/// time) has an empty interval.
TrianglePassage pass(const Corners& a, const Corners& b, const Vec3& move, double tolerance);

}  // namespace spectralpack
