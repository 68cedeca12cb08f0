#include "voxel/widen.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "voxel/bit_rows.hpp"
#include "voxel/box_distance.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {
namespace {

constexpr double kMaxReach = 1 << 29;     ///< voxels: keeps indices within an int
constexpr std::int64_t kGrain = 1 << 11;  ///< triangles a task takes at least

class Widening {
  public:
    /// `reach` and `size` (of the mesh's box) in voxel sizes.
    Widening(const BitGrid& solid, const GridMesh& mesh, const Vec3& size, double reach)
        : mesh_(mesh), shape_{0, reach} {
        Extent extent;
        for (int axis = 0; axis < 3; ++axis) {
            range_.low[axis] = -static_cast<int>(std::ceil(reach));
            const int far = static_cast<int>(std::ceil(size[axis] + reach));
            range_.high[axis] = std::max(solid.extent()[axis], far) - 1;
            extent[axis] = range_.high[axis] - range_.low[axis] + 1;
        }
        result_ = {BitGrid(extent), range_.low};
        unite(result_.voxels, solid, VoxelIndex{} - range_.low);
    }

    /// Sets the voxels that are nearer than the reach to a triangle. Any number of threads may, at
    /// once: each voxel is decided by itself, so what comes out does not depend on who was first.
    void add(std::int64_t i) {
        const GridTriangle triangle = mesh_[i];
        const VoxelRange range = voxels_in_box(triangle, shape_, range_);
        if (range.empty()) return;
        TriangleRows(triangle, shape_, range).for_each([&](int first, int last, int y, int z) {
            add_run(triangle, first, last, y, z);
        });
    }

    WidenedVoxels take() { return std::move(result_); }

  private:
    void add_run(const GridTriangle& triangle, int first, int last, int y, int z) {
        BitGrid::Word* const row = result_.voxels.row(y - range_.low.y, z - range_.low.z);
        const int offset = range_.low.x;
        for_run_words(
            row, first - offset, last - offset, [&](BitGrid::Word& word, BitGrid::Word bits) {
                const int base = static_cast<int>(&word - row) * BitGrid::kWordBits + offset;
                BitGrid::Word open = bits & ~get_shared(word), found = 0;
                for (; open != 0; open &= open - 1) {
                    const int x = base + std::countr_zero(open);
                    const Vec3 centre{x + 0.5, y + 0.5, z + 0.5};
                    if (nearer_than(
                            {triangle[0] - centre, triangle[1] - centre, triangle[2] - centre},
                            shape_.reach)) {
                        found |= open & -open;
                    }
                }
                if (found != 0) set_shared(word, found);
            });
    }

    const GridMesh& mesh_;
    VoxelShape shape_;
    VoxelRange range_;  // of the result, counted from the solid grid's voxel (0,0,0)
    WidenedVoxels result_;
};

}  // namespace

WidenedVoxels widen(const BitGrid& solid, const Mesh& mesh, double voxel_size, double gap,
                    const Workers& workers) {
    const double reach = (gap - kGapTolerance) / voxel_size;
    if (!(reach > 0)) return {solid, {}};
    if (!(reach <= kMaxReach)) {
        throw ResourceError("a gap of " + std::to_string(gap) + " mm is too large for voxels of " +
                            std::to_string(voxel_size) + " mm");
    }
    const Box box = bounding_box(mesh);
    const GridMesh grid_mesh(mesh, box.min, voxel_size);
    Widening widening(solid, grid_mesh, 1 / voxel_size * box.size(), reach);
    workers.for_ranges(grid_mesh.size(), kGrain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            widening.add(i);
        }
    });
    return widening.take();
}

}  // namespace spectralpack
