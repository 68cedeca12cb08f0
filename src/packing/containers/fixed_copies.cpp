#include "packing/containers/fixed_copies.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "voxel/voxelize.hpp"

namespace spectralpack {

Body stand_fixed(const Mesh& mesh, double gap, Tray& tray, double wall_gap, const Workers& workers) {
    const Vec3 corner{wall_gap, wall_gap, wall_gap};
    const std::vector<double>& gaps = tray.setup().gap_classes;
    const int detail = tray.detail();
    StandingVoxels voxels = voxelize_at(mesh, bounding_box(mesh).min - corner, tray.voxel_size() / detail, workers);
    const auto gap_class = std::lower_bound(gaps.begin(), gaps.end(), gap) - gaps.begin();
    TrayObject object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position, detail,
                                    static_cast<int>(gap_class));
    object.fixed = true;
    const ObjectId id = tray.add(std::move(object));
    return {std::make_shared<const Bvh>(mesh), {}, tray.object(id)};
}

}  // namespace spectralpack
