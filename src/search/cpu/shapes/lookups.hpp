#pragma once
/// Which look-ups into the tables of bits decide whether a candidate collides (eq. 2), in which order.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/cpu/shapes/orientation_runs.hpp"
#include "search/cpu/tables/tray_tables.hpp"

namespace spectralpack {

/// Words of a tile: 64 positions along x (the bits) by 8 along y (the words).
inline constexpr int kTileRows = 8;

/// Look-ups into bit tables that share the shift of a bit within its word.
struct LookupGroup {
    std::uint64_t shift = 0;          ///< 0..63
    std::int32_t begin = 0, end = 0;  ///< into the offsets
};

/// Look-ups in batches: a position survives a batch or not, and most die in the first few.
struct LookupList {
    std::vector<std::int32_t> offsets;
    std::vector<LookupGroup> groups;
    struct Batch {
        std::int32_t begin = 0, end = 0;  ///< groups, by shift; there is one
        std::int32_t lookups = 0;
    };
    std::vector<Batch> batches;
};

struct CollisionLookups {
    LookupList of_positions;  ///< into the bit tables: all that there are
    LookupList of_blocks;     ///< into the crowd tables: the first of them
    /// Into the bit tables: a few pieces of what a candidate fills from each of kTileLayers positions one above the
    /// other. What meets them at the lowest leaves none of the stack.
    LookupList of_stacks;
    /// Batches of of_positions that every position goes through that is not in the open; the others are for what is
    /// left.
    std::size_t pruning = 0;
};

/// Covers every widened voxel against its class's objects and every solid voxel against the walls,
/// in pieces that may overlap. The first batches take large pieces from all over the shape. `loads`: of the sum that is
/// made of what pruning leaves; the more they are, the longer it goes on.
CollisionLookups list_lookups(const OrientationRuns& runs, const TrayTables& tables, std::size_t loads);

/// Of what they hold in lists, about.
std::int64_t bytes_of(const CollisionLookups& lookups);

}  // namespace spectralpack
