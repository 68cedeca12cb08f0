#pragma once
/// rho of single positions, from phi itself: for the few of which sums do not tell.

#include <array>
#include <cstdint>

#include "search/cost.hpp"
#include "search/cpu/shapes/runs.hpp"
#include "search/cpu/tables/tray_tables.hpp"

namespace spectralpack {

/// rho(q), whatever its size; voxels outside the grid count nothing. O(voxels).
std::int64_t proximity_at(const TrayTables& tables, const Runs& solid, const VoxelIndex& q);

/// Costs beside a position as BestPlacement::neighbours has them; `layers`: the solid's extent along z.
std::array<Cost, 6> neighbours_of(const VoxelIndex& position, const Runs& solid, int layers, const TrayTables& tables,
                                  const CostModel& model, int reference_layers);

}  // namespace spectralpack
