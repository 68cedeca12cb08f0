#pragma once
/// Transforms of copies: are they what they may be, a rotation times the part's scale, and a translation?

#include <string>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// Entries of a rotation may be off by so much: 5e-4 mm on a part of half a metre.
inline constexpr double kRotationTolerance = 1e-6;

struct PoseVerdict {
    std::string fault;  ///< what is wrong, in words ("is mirrored"); empty if nothing is
    double deviation =
        0;  ///< greatest entry of |R^T R - 1|, R = linear / scale; infinite for numbers that are not finite
};

/// `scale`: millimetres per unit of the mesh as loaded, > 0.
PoseVerdict judge_pose(const Transform& transform, double scale);

}  // namespace spectralpack
