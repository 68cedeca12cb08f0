#include "packing/containers/fixed_copies.hpp"

#include <utility>

#include "voxel/voxelize.hpp"

namespace spectralpack {

Body stand_fixed(const Mesh& mesh, double gap, Tray& tray, double wall_gap, const Workers& workers) {
    const Vec3 corner{wall_gap, wall_gap, wall_gap};
    const int detail = tray.detail();
    StandingVoxels voxels = voxelize_at(mesh, bounding_box(mesh).min - corner, tray.voxel_size() / detail, workers);
    TrayObject object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, detail,
                                    tray.gap_class_of(gap));
    object.fixed = true;
    const ObjectId id = tray.add(std::move(object));
    return {std::make_shared<const Bvh>(mesh, false, workers.stop()), {}, tray.object(id)};
}

}  // namespace spectralpack
