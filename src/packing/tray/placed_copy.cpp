#include "packing/tray/placed_copy.hpp"

namespace spectralpack {

Settled settle_on_grid(const Shape& shape, const BestPlacement& best, double voxel_size, int detail, double wall_gap) {
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(best.index)];
    Vec3 corner;
    for (int axis = 0; axis < 3; ++axis) {
        corner[axis] = wall_gap + best.position[axis] * voxel_size;
    }
    const VoxelIndex& q = best.position;
    return {corner - oriented.corner,
            {oriented.solid.share(),
             q,
             shape.gap_class,
             false,
             oriented.fine.share(),
             {detail * q.x, detail * q.y, detail * q.z}}};
}

}  // namespace spectralpack
