#pragma once
/// The sampled orientations (paper section 3.1, "Orientations Sampling"): an ordered set of rotations. The index
/// in it breaks ties between equal costs, so the order is part of the definition.

#include <string>
#include <vector>

#include "geometry/transform.hpp"

namespace spectralpack {

/// R = Rx(i step) Ry(j step) Rz(k step), k innermost, first of equal matrices kept; index 0 is the identity.
/// `step_degrees` must divide 360. Multiples of 30 and 45 degrees come from exact constants and square roots, so
/// they are the same on every machine. 90 gives the 24 rotations of the
/// cube. Throws UsageError for a step that is not in (0, 360], does not divide 360, or makes over 100 000.
std::vector<Mat3> euler_orientations(double step_degrees);

/// As --rotations says it: "none" (identity alone) or an angle in degrees. Throws UsageError.
std::vector<Mat3> orientation_set(const std::string& rotations);

}  // namespace spectralpack
