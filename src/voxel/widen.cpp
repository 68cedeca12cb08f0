#include "voxel/widen.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "voxel/bit_rows.hpp"
#include "voxel/box_distance.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kGrain = 1 << 11;  ///< triangles a task takes at least

class Widening {
  public:
    /// `reach` in voxel sizes.
    Widening(const BitGrid& solid, const Mesh& mesh, double voxel_size, double reach)
        : mesh_(mesh), box_(bounding_box(mesh)), voxel_size_(voxel_size), shape_{0, reach} {
        const Vec3 size = box_.size();
        VoxelRange& range = range_;
        Extent extent;
        for (int axis = 0; axis < 3; ++axis) {
            range.low[axis] = -static_cast<int>(std::ceil(reach));
            const double far = std::ceil(size[axis] / voxel_size + reach);
            range.high[axis] = std::max(solid.extent()[axis], static_cast<int>(far)) - 1;
            extent[axis] = range.high[axis] - range.low[axis] + 1;
        }
        result_ = {BitGrid(extent), range.low};
        unite(result_.voxels, solid, VoxelIndex{} - range.low);
    }

    /// Sets the voxels that are nearer than the reach to a triangle. Any number of threads may, at
    /// once: each voxel is decided by itself, so what comes out does not depend on who was first.
    void add(std::size_t triangle) {
        GridTriangle corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 v = mesh_.vertices[mesh_.triangles[triangle][i]] - box_.min;
            corners[i] = {v.x / voxel_size_, v.y / voxel_size_, v.z / voxel_size_};
        }
        const VoxelRange range = voxels_in_box(corners, shape_, range_);
        if (range.empty()) return;
        TriangleRows(corners, shape_, range).for_each([&](int first, int last, int y, int z) {
            add_run(corners, first, last, y, z);
        });
    }

    WidenedVoxels take() { return std::move(result_); }

  private:
    void add_run(const GridTriangle& corners, int first, int last, int y, int z) {
        BitGrid::Word* row = result_.voxels.row(y - range_.low.y, z - range_.low.z);
        const int offset = range_.low.x;
        BitGrid::Word* const words = row;
        for_run_words(
            row, first - offset, last - offset, [&](BitGrid::Word& word, BitGrid::Word bits) {
                const int base = static_cast<int>(&word - words) * BitGrid::kWordBits + offset;
                BitGrid::Word open = bits & ~get_shared(word), found = 0;
                for (; open != 0; open &= open - 1) {
                    const int x = base + std::countr_zero(open);
                    const Vec3 centre{x + 0.5, y + 0.5, z + 0.5};
                    if (nearer_than({corners[0] - centre, corners[1] - centre, corners[2] - centre},
                                    shape_.reach)) {
                        found |= open & -open;
                    }
                }
                if (found != 0) set_shared(word, found);
            });
    }

    const Mesh& mesh_;
    Box box_;
    double voxel_size_;
    VoxelShape shape_;
    VoxelRange range_;  // of the result, counted from the solid grid's voxel (0,0,0)
    WidenedVoxels result_;
};

}  // namespace

WidenedVoxels widen(const BitGrid& solid, const Mesh& mesh, double voxel_size, double gap,
                    const Workers& workers) {
    const double reach = (gap - kGapTolerance) / voxel_size;
    if (!(reach > 0)) return {solid, {}};
    Widening widening(solid, mesh, voxel_size, reach);
    workers.for_ranges(static_cast<std::int64_t>(mesh.triangles.size()), kGrain,
                       [&](std::int64_t begin, std::int64_t end) {
                           for (std::int64_t i = begin; i < end; ++i) {
                               widening.add(static_cast<std::size_t>(i));
                           }
                       });
    return widening.take();
}

}  // namespace spectralpack
