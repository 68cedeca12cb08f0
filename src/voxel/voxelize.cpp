#include "voxel/voxelize.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "geometry/mesh_edges.hpp"
#include "voxel/axis_turns.hpp"
#include "voxel/enclosed.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/permute.hpp"
#include "voxel/surface.hpp"
#include "voxel/winding.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 40;
constexpr double kMaxAlong = 1 << 30;
constexpr std::int64_t kGrain = 1 << 13;  ///< triangles a task takes at least

Extent grid_extent(const Vec3& size, double voxel_size) {
    const Extent extent{voxels_along(size.x, voxel_size), voxels_along(size.y, voxel_size),
                        voxels_along(size.z, voxel_size)};
    if (extent.count() > kMaxVoxels) {
        throw ResourceError("a part of " + std::to_string(extent.x) + " x " +
                            std::to_string(extent.y) + " x " + std::to_string(extent.z) +
                            " voxels is too large");
    }
    return extent;
}

BitGrid solid_voxels(const GridMesh& mesh, const Extent& extent, bool closed,
                     const Workers& workers) {
    BitGrid grid(extent);
    Crossings crossings(extent);
    std::mutex appending;
    workers.for_ranges(mesh.size(), kGrain, [&](std::int64_t begin, std::int64_t end) {
        Crossings found(extent);
        for (std::int64_t i = begin; i < end; ++i) {
            const GridTriangle triangle = mesh[i];
            set_surface(grid, triangle, kSurfaceShrink);
            if (closed) found.add(triangle);
        }
        const std::lock_guard lock(appending);
        crossings.append(std::move(found));
    });
    if (closed) crossings.set_wound(grid);
    if (grid.none()) {
        // Thinner than the shrink, or an open mesh of faces that all lie on voxel faces.
        for (std::int64_t i = 0; i < mesh.size(); ++i) {
            set_surface(grid, mesh[i], -kSurfaceShrink);
        }
    }
    fill_enclosed(grid);
    return grid;
}

bool encloses_solid(const Mesh& mesh) {
    return count_edges(MeshEdges(mesh)).closed;
}

/// Box of the mesh with reversed axes. 0 - x, not -x, so that no minus zero gets out.
Box reversed_box(const Box& box, const Signs& reversed) {
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        if (!reversed[static_cast<std::size_t>(axis)]) continue;
        result.min[axis] = 0 - box.max[axis];
        result.max[axis] = 0 - box.min[axis];
    }
    return result;
}

Vec3 permuted(const Vec3& v, const std::array<int, 3>& axes) {
    return {v[axes[0]], v[axes[1]], v[axes[2]]};
}

/// `mesh` not turned but with the given axes reversed.
OrientedVoxels reversed_voxels(const Mesh& mesh, const Box& box, const Signs& reversed, bool closed,
                               double voxel_size, const Workers& workers) {
    const Extent extent = grid_extent(box.size(), voxel_size);
    return {solid_voxels(GridMesh(mesh, box, reversed, voxel_size), extent, closed, workers),
            box.size(), reversed_box(box, reversed).min};
}

OrientedVoxels turned_voxels(const Mesh& mesh, const Mat3& rotation, bool closed, double voxel_size,
                             const Workers& workers) {
    const Mesh turned = transformed(mesh, {rotation, {}});
    return reversed_voxels(turned, bounding_box(turned), {}, closed, voxel_size, workers);
}

}  // namespace

int voxels_along(double size, double voxel_size) {
    const double voxels = std::ceil(size / voxel_size - kSurfaceShrink);
    if (!(voxels <= kMaxAlong)) {
        throw ResourceError("a part of " + std::to_string(size) +
                            " mm is too large for voxels of " + std::to_string(voxel_size) + " mm");
    }
    return std::max(1, static_cast<int>(voxels));
}

BitGrid voxelize(const Mesh& mesh, double voxel_size, const Workers& workers) {
    return reversed_voxels(mesh, bounding_box(mesh), {}, encloses_solid(mesh), voxel_size, workers)
        .solid;
}

StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size,
                           const Workers& workers) {
    const Box box = bounding_box(mesh);
    VoxelIndex position;
    Vec3 shift;
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = corner[axis] / voxel_size;
        const double whole = std::floor(voxels + kSurfaceShrink);
        if (!(std::abs(whole) <= kMaxAlong)) {
            throw ResourceError("a part stands too far from the grid");
        }
        position[axis] = static_cast<int>(whole);
        shift[axis] = voxels - whole;
    }
    const Extent extent = grid_extent(box.size() + voxel_size * shift, voxel_size);
    return {solid_voxels(GridMesh(mesh, box, {}, voxel_size, shift), extent, encloses_solid(mesh),
                         workers),
            position};
}

std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh,
                                                  const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers) {
    const bool closed = encloses_solid(mesh);
    const Box box = bounding_box(mesh);
    const SignPatterns patterns(rotations);
    std::vector<OrientedVoxels> by_pattern(patterns.first_of.size());
    workers.for_each(static_cast<std::int64_t>(by_pattern.size()), [&](std::int64_t task) {
        const auto i = static_cast<std::size_t>(task);
        by_pattern[i] = reversed_voxels(mesh, box, patterns.signs(i), closed, voxel_size, workers);
    });
    std::vector<OrientedVoxels> result(rotations.size());
    workers.for_each(static_cast<std::int64_t>(rotations.size()), [&](std::int64_t task) {
        const auto i = static_cast<std::size_t>(task);
        const std::optional<AxisTurn>& turn = patterns.turns[i];
        if (!turn) {
            result[i] = turned_voxels(mesh, rotations[i], closed, voxel_size, workers);
            return;
        }
        const OrientedVoxels& source = by_pattern[patterns.pattern_of[i]];
        result[i] = {permuted(source.solid, turn->axes), permuted(source.size, turn->axes),
                     permuted(source.min, turn->axes)};
    });
    return result;
}

}  // namespace spectralpack
