#pragma once
/// Where the copies of a tray are drawn in pictures that take it apart.

#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

struct ShownCopy {
    bool drawn = true;
    Vec3 offset;           ///< from where it stands, mm
    bool leaving = false;  ///< it is what the picture is about
};

struct ExplodedTray {
    std::vector<ShownCopy> copies;
    std::vector<double> floors;  ///< at what height each layer is drawn, from the lowest up, mm
};

/// The tray's slabs (model/slabs.hpp) one above the other, so far apart at `factor` 1 that none hides the next from a
/// camera at these angles. `boxes`: by placement.
ExplodedTray show_exploded(const std::vector<Box>& boxes, const Vec3& container, double azimuth, double elevation,
                           double factor);

/// Step `step` (from 1 on) being made: its copies half way, and what is left of those that they stood together with.
/// Step 0: the tray as it stands. Precondition: the tray has a plan of at least so many steps.
std::vector<ShownCopy> show_step(const TrayPacking& tray, int step);

}  // namespace spectralpack
