#include "voxel/near_triangle.hpp"

#include <bit>

#include "voxel/bit_rows.hpp"
#include "voxel/box_distance.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kFew = 64;  // voxels: quicker looked at than the triangle

}  // namespace

void set_near(BitGrid& grid, const VoxelIndex& first, const GridTriangle& triangle, double reach,
              const Workers& workers) {
    const VoxelShape shape{0, reach};
    const Extent& n = grid.extent();
    const VoxelRange whole{first, {first.x + n.x - 1, first.y + n.y - 1, first.z + n.z - 1}};
    const VoxelRange range = voxels_in_box(triangle, shape, whole);
    if (range.empty()) return;
    if (range.count() <= kFew && all_set(grid, range, first)) return;  // as of most triangles of a fine mesh
    const NearCubes near(triangle, reach);
    TriangleRows(triangle, shape, range).for_each([&](int low, int high, int y, int z) {
        workers.check();
        BitGrid::Word* const row = grid.row(y - first.y, z - first.z);
        for_run_words(row, low - first.x, high - first.x, [&](BitGrid::Word& word, BitGrid::Word bits) {
            const int base = static_cast<int>(&word - row) * BitGrid::kWordBits + first.x;
            BitGrid::Word open = bits & ~get_shared(word), found = 0;
            for (; open != 0; open &= open - 1) {
                const Vec3 centre{base + std::countr_zero(open) + 0.5, y + 0.5, z + 0.5};
                if (near.contain(centre)) found |= open & -open;
            }
            if (found != 0) set_shared(word, found);
        });
    });
}

}  // namespace spectralpack
