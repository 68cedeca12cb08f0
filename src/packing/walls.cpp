#include "packing/walls.hpp"

#include <memory>
#include <utility>

#include "voxel/room.hpp"

namespace spectralpack {
namespace {

/// All round the mesh's solid, which is a hollow in it.
Mesh surroundings(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    Mesh around = box_surface({box.min - box.size(), box.max + box.size()});
    const auto first = static_cast<std::uint32_t>(around.vertices.size());
    around.vertices.insert(around.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles) {
        around.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    }
    return around;
}

}  // namespace

BitGrid blocked_voxels(const Container& container, const Extent& grid, double voxel_size, double wall_gap,
                       const Workers& workers) {
    if (!container.mesh && container.keep_out.empty()) return {};
    BitGrid blocked(grid);
    const GridPlace place{{wall_gap, wall_gap, wall_gap}, voxel_size};
    if (container.mesh) set_outside(blocked, place, *container.mesh->surface, wall_gap, workers);
    for (const KeepOut& keep_out : container.keep_out) {
        if (keep_out.mesh) {
            set_taken(blocked, place, *keep_out.mesh->surface, wall_gap, workers);
        } else {
            set_taken(blocked, place, keep_out.box, wall_gap);
        }
    }
    return blocked;
}

std::vector<StandingCopy> wall_surfaces(const Container& container, double wall_gap) {
    std::vector<StandingCopy> walls;
    const auto add = [&](const Mesh& mesh) {
        walls.push_back({std::make_shared<const Bvh>(mesh), {}, wall_gap, true});
    };
    if (container.mesh) add(surroundings(*container.mesh->surface));
    for (const KeepOut& keep_out : container.keep_out) {
        add(keep_out.mesh ? *keep_out.mesh->surface : box_surface(keep_out.box));
    }
    return walls;
}

}  // namespace spectralpack
