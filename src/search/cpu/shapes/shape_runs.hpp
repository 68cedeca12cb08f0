#pragma once
/// The runs of all orientations of a shape: of those that follow from another by a turn, from its runs.

#include <vector>

#include "search/cpu/shapes/orientation_runs.hpp"

namespace spectralpack {

/// Voxels of dx by which the widened shapes reach beyond the solid on any side.
int overhang(const Shape& shape, int detail);

/// Makes the runs of the `wanted` orientations that have none yet, and of what they follow from, for searches in the
/// tray of these tables. `runs`: by orientation.
void make_missing_runs(const Shape& shape, int detail, std::vector<bool> wanted, const TrayTables& tables,
                       const Workers& workers, std::vector<OrientationRuns>& runs);

}  // namespace spectralpack
