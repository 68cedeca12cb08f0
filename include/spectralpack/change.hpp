#pragma once
/// Changing a finished packing by hand: copies are moved, taken out and put back. It says nothing of whether they touch
/// then, or come apart: check() and plan_packing() do.

#include <optional>
#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// Why an Unplaced copy that a change took out is not in its tray.
inline constexpr const char* kTakenOutByHand = "taken out by hand";

struct CopyChange {
    int tray = 0;  ///< index in Packing::trays
    int part = 0;
    int copy = 0;
    /// Where it stands from now on, as in a Placement; none: it is taken out.
    std::optional<Transform> transform = {};
};

/// The packing after these changes, made one after the other. Figures of the trays that change are measured anew; their
/// plans, which may no longer hold, are gone. A copy that was left over may be put in. Copies that were moved keep
/// their place in the order, others come last. `threads` <= 0: all the machine has. Throws UsageError for a tray or
/// copy that is not there, a copy that the job has fixed, and a transform that is not a rotation times the part's
/// scale.
Packing changed(const Scene& scene, const std::vector<CopyChange>& changes, int threads = 0);

}  // namespace spectralpack
