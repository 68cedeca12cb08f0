#pragma once
/// Solids as overlapping pieces, each of which one look-up into the bit tables decides. A cube of 16^3 voxels is one
/// look-up and rules out more than a run as long as the tray; what is too thin for cubes and plates is left to runs.

#include <cstdint>
#include <span>
#include <vector>

#include "search/cpu/tables/bit_tables.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/widen.hpp"

namespace spectralpack {

/// Pieces, by form.
struct Pieces {
    /// Those of one form: corners [begin, end).
    struct OfForm {
        Form form;
        std::uint32_t begin = 0, end = 0;
    };
    std::vector<OfForm> forms;
    std::vector<VoxelIndex> corners;  ///< the least voxel of each

    std::span<const VoxelIndex> corners_of(const OfForm& of) const {
        return std::span(corners).subspan(of.begin, of.end - of.begin);
    }
};

/// Pieces of `forms` that lie in `solid` and together hold all of `wanted`, a subset of it on the same grid; few rather
/// than fewest. O(words) for each form that fits somewhere.
Pieces cover(const BitGrid& solid, BitGrid wanted, const Forms& forms);

/// A+g in pieces. With s > 1 its voxels of dx / s are not all covered: what lies in voxels of dx that are filled
/// altogether, the core, meets a fine voxel of an object exactly if the core meets the object's voxels of dx. Corners
/// are displacements from a position, in voxels of dx / s and, of the core, of dx.
struct CoveredVoxels {
    Pieces pieces, core;
};
CoveredVoxels cover(const WidenedVoxels& wide, int detail, const Workers& workers);

/// Pieces in and around a grid with the extents `grid` once that is turned.
Pieces turned(const Pieces& pieces, const AxisTurn& turn, const Extent& grid);

}  // namespace spectralpack
