#pragma once
/// Solids as overlapping pieces, each of which one look-up into the bit tables decides. A cube of 16^3 voxels is one
/// look-up and rules out more than a run as long as the tray; what is too thin for cubes and plates is left to runs.

#include <vector>

#include "search/cpu/bit_tables.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

struct Piece {
    Form form;
    VoxelIndex corner;  ///< the least voxel of it
};

/// Pieces of `forms` that lie in `solid` and together hold all of `wanted`, a subset of it on the same grid; few rather
/// than fewest. O(words) for each form that fits somewhere.
std::vector<Piece> cover(const BitGrid& solid, BitGrid wanted, const Forms& forms);

}  // namespace spectralpack
