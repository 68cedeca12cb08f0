#pragma once
/// A shape's orientation as the engine asks about it, whatever the tray holds: runs and depths for rho, pieces for
/// collisions, cells. Made from voxels once for a part; its turned orientations follow.

#include <cstdint>
#include <optional>
#include <vector>

#include "search/cpu/cells.hpp"
#include "search/cpu/cover.hpp"
#include "search/cpu/depths.hpp"
#include "search/cpu/runs.hpp"
#include "search/cpu/tray_tables.hpp"
#include "search/shape.hpp"

namespace spectralpack {

/// An orientation's voxels as runs.
struct OrientationRuns {
    Runs solid;
    /// For each of them, what phi sums up to at least where the solid is free.
    std::vector<std::uint32_t> least;
    /// A+g in pieces. With s > 1 its voxels of dx / s are not all covered: what lies in voxels of dx that are filled
    /// altogether, the core, meets a fine voxel of an object exactly if the core meets the object's voxels of dx.
    /// Corners are displacements from a position, in voxels of dx / s and, of the core, of dx.
    struct Widened {
        Pieces pieces, core;
    };
    std::vector<Widened> widened;  ///< the distinct ones
    std::vector<int> of_class;     ///< into `widened`, for each gap class
    Pieces walled;                 ///< A in pieces; none where the tray has no walls of its own
    CellPlan cells;                ///< for the tables of one tray
    CellPlan fine_cells;           ///< none where sums cost little more
};

/// Depths in the solid, `solid` being its runs, of the voxels that the tray's other objects keep off: with s > 1 those
/// that it fills altogether.
Depths depths_of(const OrientedShape& shape, const Runs& solid, int detail);

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

/// Voxels of dx by which the widened shapes reach beyond the solid on any side.
int overhang(const Shape& shape, int detail);

/// Of what they hold in lists, about.
std::int64_t bytes_of(const OrientationRuns& runs);

}  // namespace spectralpack
