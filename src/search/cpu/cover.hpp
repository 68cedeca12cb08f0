#pragma once
/// Solids as overlapping pieces, each of which one look-up into the bit tables decides. A cube of 16^3 voxels is one
/// look-up and rules out more than a run as long as the tray; what is too thin for cubes and plates is left to runs.

#include <cstdint>
#include <span>
#include <vector>

#include "search/cpu/bit_tables.hpp"
#include "voxel/bit_grid.hpp"

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

}  // namespace spectralpack
