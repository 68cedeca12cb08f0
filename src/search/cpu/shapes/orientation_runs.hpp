#pragma once
/// A shape's orientation as the engine asks about it, whatever the tray holds: runs and depths for rho, pieces for
/// collisions, cells. Made from voxels once for a part; its turned orientations follow.

#include <cstdint>
#include <optional>
#include <vector>

#include "search/cpu/shapes/cells.hpp"
#include "search/cpu/shapes/cover.hpp"
#include "search/cpu/shapes/depths.hpp"
#include "search/cpu/shapes/runs.hpp"
#include "search/cpu/tables/tray_tables.hpp"
#include "search/shape.hpp"

namespace spectralpack {

/// An orientation's voxels as runs.
struct OrientationRuns {
    Runs solid;
    /// For each of them, what phi sums up to at least where the solid is free.
    std::vector<std::uint32_t> least;
    std::vector<CoveredVoxels> widened;  ///< the distinct A+g
    std::vector<int> of_class;           ///< into `widened`, for each gap class
    Pieces walled;                       ///< A in pieces; none where the tray has no walls of its own
    CellList cells;                      ///< for the tables of one tray
    CellList small_cells;                ///< none where sums cost little more
};

/// An orientation's runs, and depths_of() it.
struct MadeRuns {
    OrientationRuns runs;
    Depths depths;
};

/// For searches in the tray of these tables.
MadeRuns make_runs(const OrientedShape& shape, int detail, const TrayTables& tables, const Workers& workers);

/// What make_runs() would give, but for the order of pieces and cells and for which of several pieces cover a voxel,
/// for the orientation that follows by `turn` from the one with these runs, whose solid has the extents `solid` and
/// whose `depths` are asked for where the turn reverses an axis. O(runs); reversing, O(cells) more.
OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables& tables);

/// Of what they hold in lists, about.
std::int64_t bytes_of(const OrientationRuns& runs);

}  // namespace spectralpack
