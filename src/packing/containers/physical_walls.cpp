#include "packing/containers/physical_walls.hpp"

#include <cmath>
#include <utility>

#include "geometry/slide.hpp"
#include "model/physical_surfaces.hpp"
#include "packing/containers/walls.hpp"

namespace spectralpack {
namespace {

constexpr double kWallRounding = 1e-6;  // mm
// A mesh that is not closed may not leave what it touches (slides_past()), so it would never leave the floor: their
// surfaces stand so much lower, mm.
constexpr double kBelow = 2 * kRecovery;

Mesh together(const std::vector<Mesh>& meshes) {
    Mesh all;
    for (const Mesh& mesh : meshes) {
        append(all, mesh);
    }
    return all;
}

void set_row(BitGrid& grid, int y, int z, bool value) {
    for (int x = 0; x < grid.extent().x; ++x) {
        grid.set(x, y, z, value);
    }
}

/// What of the voxels lies wholly beside the container's box or below it.
void set_outside_box(BitGrid& grid, const GridPlace& place, const Vec3& size) {
    const auto outside = [&](int index, int axis) {
        const double low = place.origin[axis] + index * place.voxel_size;
        return low + place.voxel_size <= kWallRounding || (axis < 2 && low >= size[axis] - kWallRounding);
    };
    const Extent& e = grid.extent();
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; ++y) {
            if (outside(z, 2) || outside(y, 1)) set_row(grid, y, z, true);
        }
    }
    for (int x = 0; x < e.x; ++x) {
        if (!outside(x, 0)) continue;
        for (int z = 0; z < e.z; ++z) {
            for (int y = 0; y < e.y; ++y) {
                grid.set(x, y, z);
            }
        }
    }
}

}  // namespace

Body standing_walls(const Container& container, const TraySetup& grid, const Vec3& corner, const Workers& workers) {
    auto voxels = std::make_shared<BitGrid>(Tray(grid).extent());
    const GridPlace place{corner, grid.voxel_size};
    set_outside_box(*voxels, place, container.size);
    if (container.mesh) set_outside(*voxels, place, *container.mesh->surface, 0, workers);
    for (int z = 0; z < voxels->extent().z; ++z) {
        if (corner.z + (z + 1) * grid.voxel_size <= container.size.z + kWallRounding) continue;
        for (int y = 0; y < voxels->extent().y; ++y) {
            set_row(*voxels, y, z, false);
        }
    }
    set_keep_outs(*voxels, place, container, 0, workers);
    TrayObject object{std::move(voxels), {}};
    object.fixed = true;
    return {std::make_shared<const Bvh>(together(physical_surfaces(container)), true, workers.stop()),
            {0, 0, -kBelow},
            std::move(object)};
}

TrayObject PhysicalWalls::moved(TrayObject object) const {
    object.position = object.position + VoxelIndex{margin, margin, margin};
    return object;
}

int walls_margin(double voxel_size, double wall_gap) { return static_cast<int>(std::ceil(wall_gap / voxel_size)) + 1; }

PhysicalWalls physical_walls(const Container& container, const TraySetup& tray, double wall_gap,
                             const Workers& workers) {
    const double dx = tray.voxel_size;
    PhysicalWalls walls;
    walls.margin = walls_margin(dx, wall_gap);
    const double wider = walls.margin * dx;
    walls.grid = tray;
    walls.grid.size = tray.size + Vec3{2 * wider, 2 * wider, wider};
    const double corner = wall_gap - wider;
    walls.corner = {corner, corner, corner};
    walls.part = standing_walls(container, walls.grid, walls.corner, workers);
    return walls;
}

}  // namespace spectralpack
