#include "search/cpu/scan/reaching_blocks.hpp"

#include <algorithm>

#include "core/checked.hpp"
#include "search/cpu/tables/tray_tables.hpp"

namespace spectralpack {
namespace {

constexpr int kBlock = TrayTables::kBlock;

/// bit i |= bit i + by of each row.
void unite_along_x(BitGrid& grid, int by) {
    const int words = grid.words_per_row(), whole_words = by / 64, bits = by % 64;
    for (int z = 0; z < grid.extent().z; ++z) {
        for (int y = 0; y < grid.extent().y; ++y) {
            BitGrid::Word* row = grid.row(y, z);
            for (int w = 0; w + whole_words < words; ++w) {
                const int from = w + whole_words;
                BitGrid::Word moved = row[from] >> bits;
                if (bits > 0 && from + 1 < words) moved |= row[from + 1] << (64 - bits);
                row[w] |= moved;
            }
        }
    }
}

/// Likewise of the rows along y or along z.
void unite_across(BitGrid& grid, int axis, int by) {
    const Extent& n = grid.extent();
    const int dy = axis == 1 ? by : 0, dz = axis == 2 ? by : 0;
    for (int z = 0; z + dz < n.z; ++z) {
        for (int y = 0; y + dy < n.y; ++y) {
            const BitGrid::Word* from = grid.row(y + dy, z + dz);
            BitGrid::Word* to = grid.row(y, z);
            for (int w = 0; w < grid.words_per_row(); ++w) {
                to[w] |= from[w];
            }
        }
    }
}

}  // namespace

BitGrid blocks_of(const std::vector<VoxelBox>& boxes, int margin, const Extent& extent) {
    BitGrid blocks({ceil_div(extent.x, kBlock), ceil_div(extent.y, kBlock), ceil_div(extent.z, kBlock)});
    const VoxelIndex around{margin, margin, margin};
    for (const VoxelBox& box : boxes) {
        const VoxelBox within = intersection({box.lo - around, box.hi + around}, whole(extent));
        if (within.empty()) continue;
        for (int z = within.lo.z / kBlock; z <= (within.hi.z - 1) / kBlock; ++z) {
            for (int y = within.lo.y / kBlock; y <= (within.hi.y - 1) / kBlock; ++y) {
                for (int x = within.lo.x / kBlock; x <= (within.hi.x - 1) / kBlock; ++x) {
                    blocks.set(x, y, z);
                }
            }
        }
    }
    return blocks;
}

BitGrid blocks_reaching(BitGrid blocks, const Extent& extent) {
    for (int axis = 0; axis < 3; ++axis) {
        // A shape at the last position of block Q reaches up to voxel 4 Q + 3 + extent - 1.
        const int window = (extent[axis] + kBlock - 2) / kBlock + 1;
        for (int united = 1; united < window;) {
            const int by = std::min(united, window - united);
            if (axis == 0) {
                unite_along_x(blocks, by);
            } else {
                unite_across(blocks, axis, by);
            }
            united += by;
        }
    }
    return blocks;
}

}  // namespace spectralpack
