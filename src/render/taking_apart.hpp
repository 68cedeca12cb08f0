#pragma once
/// Where the copies of a tray are drawn while its disassembly plan takes it apart.

#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

struct ShownCopy {
    bool drawn = true;
    Vec3 offset;           ///< from where it stands, mm
    bool leaving = false;  ///< it is what the picture is about
};

/// Each copy goes along its way out, the farther the farther it stands in the direction of that: copies that leave
/// alike spread as if the tray were 1 + factor times as long that way, in their order. What has no step, and the last
/// one, which needs no way, stays. `boxes`: by placement. Precondition: the tray has a plan.
std::vector<ShownCopy> show_exploded(const TrayPacking& tray, const std::vector<Box>& boxes, double factor);

/// Step `step` (from 1 on) being made: its copies half way, and what is left of those that they stood together with.
/// Step 0: the tray as it stands. Precondition: the tray has a plan of at least so many steps.
std::vector<ShownCopy> show_step(const TrayPacking& tray, int step);

}  // namespace spectralpack
