#include "voxel/widen.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "spectralpack/error.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/near_mesh.hpp"

namespace spectralpack {
namespace {

constexpr double kMaxReach = 1 << 29;  ///< voxels: keeps indices within an int

}  // namespace

WidenedVoxels widen(const BitGrid& solid, const Mesh& mesh, const Vec3& corner, double voxel_size, double gap,
                    const Workers& workers) {
    const double reach = (gap - kGapTolerance) / voxel_size;
    if (!(reach > 0)) return {LazyGrid(solid), {}};
    if (!(reach <= kMaxReach)) {
        throw ResourceError("a gap of " + std::to_string(gap) + " mm is too large for voxels of " +
                            std::to_string(voxel_size) + " mm");
    }
    const Box box = bounding_box(mesh);
    const GridMesh grid_mesh(mesh, corner, voxel_size);
    VoxelIndex first;
    Extent extent;
    for (int axis = 0; axis < 3; ++axis) {
        const double below = (box.min - corner)[axis] / voxel_size, above = (box.max - corner)[axis] / voxel_size;
        first[axis] = std::min(0, static_cast<int>(std::floor(below - reach)));
        extent[axis] = std::max(solid.extent()[axis], static_cast<int>(std::ceil(above + reach))) - first[axis];
    }
    BitGrid wide(extent);
    unite(wide, solid, VoxelIndex{} - first);
    set_near(wide, first, grid_mesh, reach, workers);
    return {LazyGrid(std::move(wide)), first};
}

WidenedVoxels turned(const WidenedVoxels& widened, const Extent& solid, const AxisTurn& turn) {
    const Extent& n = widened.voxels.extent();
    const VoxelBox box{widened.offset, widened.offset + VoxelIndex{n.x, n.y, n.z}};
    return {turned(widened.voxels, turn), turned(box, turn, solid).lo};
}

}  // namespace spectralpack
