#include "voxel/surface.hpp"

#include <cmath>

#include "voxel/bit_rows.hpp"

namespace spectralpack {
namespace {

/// True when every voxel of a range of at most three holds a corner of the triangle, which spares
/// most triangles of a fine mesh the test.
bool corners_fill(const GridTriangle& triangle, const VoxelRange& range, double shrink) {
    const int nx = range.high.x - range.low.x + 1, ny = range.high.y - range.low.y + 1;
    unsigned filled = 0;
    for (const Vec3& corner : triangle) {
        const double x = corner.x - range.low.x, y = corner.y - range.low.y, z = corner.z - range.low.z;
        const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
        const auto inside = [shrink](double fraction) { return fraction > shrink && fraction < 1 - shrink; };
        if (inside(x - i) && inside(y - j) && inside(z - k)) filled |= 1u << (i + nx * (j + ny * k));
    }
    return filled == (1u << range.count()) - 1;
}

}  // namespace

void set_surface(BitGrid& grid, const GridTriangle& triangle, double shrink) {
    const Extent& n = grid.extent();
    const VoxelShape shape{shrink, 0};
    const VoxelRange range = voxels_in_box(triangle, shape, {{0, 0, 0}, {n.x - 1, n.y - 1, n.z - 1}});
    if (range.empty()) return;
    const auto set_run = [&grid](int first, int last, int y, int z) {
        for_run_words(grid.row(y, z), first, last, set_shared);
    };
    if (range.count() <= 3 && corners_fill(triangle, range, shrink)) {
        for (int z = range.low.z; z <= range.high.z; ++z) {
            for (int y = range.low.y; y <= range.high.y; ++y) {
                set_run(range.low.x, range.high.x, y, z);
            }
        }
    } else if (range.count() > 27 || !all_set(grid, range, {})) {
        TriangleRows(triangle, shape, range).for_each(set_run);
    }
}

}  // namespace spectralpack
