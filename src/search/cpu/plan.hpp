#pragma once
/// What a shape's orientation asks of the tables, worked out once: which look-ups decide a
/// collision, which loads make up rho.

#include <cstdint>
#include <memory>
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
    /// For each of them, what phi sums up to at least where the solid is free; all 0 where that says nothing.
    std::vector<std::uint32_t> least;
    /// A+g in pieces. With s > 1 its voxels of dx / s are not all covered: what lies in voxels of dx that are filled
    /// altogether, the core, meets a fine voxel of an object exactly if the core meets the object's voxels of dx.
    struct Widened {
        std::vector<Piece> pieces;
        VoxelIndex offset;
        std::vector<Piece> core;
        VoxelIndex core_offset;
    };
    std::vector<Widened> widened;  ///< the distinct ones
    std::vector<int> of_class;     ///< into `widened`, for each gap class
    std::vector<Piece> walled;     ///< A in pieces; none where the tray has no walls of its own
    CellPlan cells;                ///< for the tables of one tray
    CellPlan fine_cells;           ///< none where sums cost little more
};

/// Depths in the solid, `solid` being its runs, of the voxels that the tray's other objects keep off; none where
/// `covers`, covers_solid() of the whole shape, is false.
std::optional<Depths> depths_of(const OrientedShape& shape, const Runs& solid, int detail, bool covers);

/// For searches in a tray of that frame. `keep`, if given, becomes depths_of() the shape.
OrientationRuns make_runs(const OrientedShape& shape, int detail, bool covers, const TrayTables::Frame& frame,
                          const Workers& workers, std::optional<Depths>* keep = nullptr);

/// What make_runs() would give, but for the order of pieces and cells and for which of several pieces cover a voxel,
/// for the orientation that follows by `turn` from the one with these runs, whose solid has the extents `solid` and
/// whose `depths`, if any, are asked for where the turn reverses an axis. O(runs); reversing, O(cells) more.
OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables::Frame& frame);

/// True when every A+g holds A itself. Then, at free positions, no object is in a voxel that the solid fills; and with
/// s = 1 phi >= 1 on every voxel of the solid.
bool covers_solid(const Shape& shape);

/// Voxels of dx by which the widened shapes reach beyond the solid on any side.
int overhang(const Shape& shape, int detail);

/// Words of a tile: 64 positions along x (the bits) by 8 along y (the words).
inline constexpr int kTileRows = 8;
/// Sums are kept at most here, "this or more".
inline constexpr std::uint32_t kSumLimit = 0xFFFE0000u;

/// Look-ups into bit tables that share the shift of a bit within its word.
struct LookupGroup {
    std::uint64_t shift = 0;          ///< 0..63
    std::int32_t begin = 0, end = 0;  ///< into the offsets
};

/// Pairs of loads from sum tables whose differences add up to less than 65536.
struct SumBatch {
    std::int32_t begin = 0, end = 0;  ///< into the loads
    std::uint16_t least = 0;          ///< theirs together
};
struct SumLoad {
    std::int32_t plus = 0, minus = 0;  ///< element offsets from the position
    std::uint16_t least = 0;           ///< the difference at a free position, or less
};

/// Look-ups in batches: a position survives a batch or not, and most die in the first few.
struct LookupPlan {
    std::vector<std::int32_t> offsets;
    std::vector<LookupGroup> groups;
    struct Batch {
        std::int32_t begin = 0, end = 0;  ///< groups, by shift; there is one
        std::int32_t lookups = 0;
    };
    std::vector<Batch> batches;
};

struct CollisionPlan {
    static constexpr std::size_t kForAllLayers = 1, kLeastSift = 4, kMostSift = 16;

    LookupPlan of_positions;  ///< into the bit tables: all that there are
    LookupPlan of_blocks;     ///< into the crowd tables: the first of them
    /// Into the bit tables: a few pieces of what a candidate fills from each of kTileLayers positions one above the
    /// other. What meets them at the lowest leaves none of the stack.
    LookupPlan of_stacks;
    /// Batches of of_positions that every position goes through that is not in the open; the others are for what is
    /// left.
    std::size_t sift = 0;
};

/// Covers every widened voxel against its class's objects and every solid voxel against the walls,
/// in pieces that may overlap. The first batches take large pieces from all over the shape. `loads`: of the sum that is
/// made of what the sift leaves; the more they are, the longer is the sift.
CollisionPlan plan_collision(const OrientationRuns& runs, const TrayTables& tables, std::size_t loads);

struct SumPlan {
    std::int64_t least = 0;  ///< what all loads come to at least at a free position
    std::vector<SumLoad> loads;
    std::vector<SumBatch> batches;
};

/// The runs' indices in the order in which sums take them: long ones first, since they tell most for a load; among
/// those bunches of neighbours, which share cache lines, from all over the solid.
std::vector<std::uint32_t> order_of_loads(const Runs& runs);

/// Every solid voxel exactly once, in order_of_loads(); runs are split so that no batch's sum can reach 65536 with
/// values <= most.
SumPlan plan_sum(const OrientationRuns& orientation, const std::vector<std::uint32_t>& order, const SumLayout& tables,
                 int range, int most);

/// All that an orientation asks of the tables of a tray. It holds until they start afresh or objects of a class come
/// in of which there were none.
struct OrientationPlan {
    CollisionPlan collision;
    SumPlan fine;    ///< of single positions and of quads
    SumPlan coarse;  ///< of blocks
};
OrientationPlan make_plan(const OrientationRuns& runs, const TrayTables& tables);

/// Of what they hold in lists, about.
std::int64_t bytes_of(const OrientationRuns& runs);
std::int64_t bytes_of(const OrientationPlan& plan);

}  // namespace spectralpack
