#include "packing/containers/walls.hpp"

#include <memory>
#include <utility>

#include "model/physical_surfaces.hpp"

namespace spectralpack {
namespace {

/// All round the mesh's solid, which is a hollow in it.
Mesh surroundings(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    Mesh around = box_surface({box.min - box.size(), box.max + box.size()});
    append(around, inside_out(mesh));
    return around;
}

}  // namespace

void set_keep_outs(BitGrid& grid, const GridPlace& place, const Container& container, double wall_gap,
                   const Workers& workers) {
    for (const KeepOut& keep_out : container.keep_out) {
        if (keep_out.mesh) {
            set_taken(grid, place, *keep_out.mesh->surface, wall_gap, workers);
        } else {
            set_taken(grid, place, keep_out.box, wall_gap);
        }
    }
}

BitGrid blocked_voxels(const Container& container, const Extent& grid, double voxel_size, double wall_gap,
                       const Workers& workers) {
    if (!container.mesh && container.keep_out.empty()) return {};
    BitGrid blocked(grid);
    const GridPlace place{{wall_gap, wall_gap, wall_gap}, voxel_size};
    if (container.mesh) set_outside(blocked, place, *container.mesh->surface, wall_gap, workers);
    set_keep_outs(blocked, place, container, wall_gap, workers);
    return blocked;
}

std::vector<PlacedSurface> wall_surfaces(const Container& container, double wall_gap, const StopToken& stop) {
    std::vector<PlacedSurface> walls;
    const auto add = [&](const Mesh& mesh) {
        walls.push_back({std::make_shared<const Bvh>(mesh, false, stop), {}, wall_gap, true});
    };
    if (container.mesh) add(surroundings(*container.mesh->surface));
    for (const KeepOut& keep_out : container.keep_out) {
        add(surface_of(keep_out));
    }
    return walls;
}

}  // namespace spectralpack
