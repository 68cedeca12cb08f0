#pragma once
/// A disassembly plan (section 4): how a tray's copies come apart by translations alone.

#include <vector>

#include "geometry/vec3.hpp"

namespace spectralpack {

/// One copy, or several as one rigid group, leave the tray.
struct RemovalStep {
    std::vector<int> placements;  ///< indices into TrayPacking::placements, ascending
    /// Translations made one after the other, mm; the last one ends wholly outside the bounding box
    /// of what remains (or in an empty tray, which needs none).
    std::vector<Vec3> path;
};

struct Disassembly {
    /// Every copy that is not fixed has a step. Fixed ones never move and have none.
    bool complete = false;
    std::vector<RemovalStep> steps;  ///< in order: each sees only what earlier ones left
    /// What the plan does not take out: sets of placements that hold each other, where known.
    std::vector<std::vector<int>> interlocked;
};

}  // namespace spectralpack
