#include "voxel/room.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "voxel/bit_rows.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/near_triangle.hpp"
#include "voxel/surface.hpp"
#include "voxel/voxelize.hpp"
#include "voxel/widen.hpp"
#include "voxel/winding.hpp"

namespace spectralpack {
namespace {

/// Sets what the surface enters, or what is nearer to it than the gap.
void set_surface(BitGrid& grid, const GridMesh& mesh, double reach, const Workers& workers) {
    for_each_triangle(mesh, workers, [&](const GridTriangle& triangle) {
        set_surface(grid, triangle, kSurfaceShrink);
        if (reach > 0) set_near(grid, {}, triangle, reach, workers);
    });
}

double reach_of(double gap, double voxel_size) { return std::max(0.0, gap - kGapTolerance) / voxel_size; }

}  // namespace

void set_outside(BitGrid& grid, const GridPlace& place, const Mesh& mesh, double gap, const Workers& workers) {
    const GridMesh grid_mesh(mesh, place.origin, place.voxel_size);
    Crossings crossings(grid.extent());
    std::mutex appending;
    workers.for_ranges(grid_mesh.size(), kTrianglesPerTask, [&](std::int64_t begin, std::int64_t end) {
        Crossings found(grid.extent());
        for (std::int64_t i = begin; i < end; ++i) {
            found.add(grid_mesh[i]);
        }
        const std::lock_guard lock(appending);
        crossings.append(std::move(found));
    });
    BitGrid inside(grid.extent());
    crossings.set_wound(inside);
    BitGrid outside(grid.extent());
    outside.fill(true);
    subtract(outside, inside, {});
    unite(grid, outside, {});
    set_surface(grid, grid_mesh, reach_of(gap, place.voxel_size), workers);
}

void set_taken(BitGrid& grid, const GridPlace& place, const Mesh& mesh, double gap, const Workers& workers) {
    const StandingVoxels standing = voxelize_at(mesh, bounding_box(mesh).min - place.origin, place.voxel_size, workers);
    unite(grid, standing.solid, standing.position);
    set_surface(grid, GridMesh(mesh, place.origin, place.voxel_size), reach_of(gap, place.voxel_size), workers);
}

void set_taken(BitGrid& grid, const GridPlace& place, const Box& box, double gap) {
    VoxelIndex low, high;
    for (int axis = 0; axis < 3; ++axis) {
        const double n = grid.extent()[axis];
        const double from = (box.min[axis] - gap - place.origin[axis]) / place.voxel_size;
        const double to = (box.max[axis] + gap - place.origin[axis]) / place.voxel_size;
        low[axis] = static_cast<int>(std::clamp(std::floor(from + kSurfaceShrink), 0.0, n));
        high[axis] = static_cast<int>(std::clamp(std::ceil(to - kSurfaceShrink), 0.0, n)) - 1;
        if (high[axis] < low[axis]) return;
    }
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for_run_words(grid.row(y, z), low.x, high.x, set_shared);
        }
    }
}

}  // namespace spectralpack
