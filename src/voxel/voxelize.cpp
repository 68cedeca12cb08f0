#include "voxel/voxelize.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "geometry/mesh_edges.hpp"
#include "voxel/enclosed.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/permute.hpp"
#include "voxel/surface.hpp"
#include "voxel/winding.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 40;
constexpr double kMaxAlong = 1 << 30;
constexpr std::int64_t kGrain = 1 << 11;  ///< triangles a task takes at least

Extent grid_extent(const Vec3& size, double voxel_size) {
    const Extent extent{voxels_along(size.x, voxel_size), voxels_along(size.y, voxel_size),
                        voxels_along(size.z, voxel_size)};
    if (extent.count() > kMaxVoxels) {
        throw ResourceError("a part of " + std::to_string(extent.x) + " x " + std::to_string(extent.y) + " x " +
                            std::to_string(extent.z) + " voxels is too large");
    }
    return extent;
}

BitGrid solid_voxels(const GridMesh& mesh, const Extent& extent, bool closed, const Workers& workers) {
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

bool encloses_solid(const Mesh& mesh) { return count_edges(MeshEdges(mesh)).closed; }

BitGrid voxels_of(const Mesh& mesh, const Box& box, bool closed, double voxel_size, const Workers& workers) {
    const Extent extent = grid_extent(box.size(), voxel_size);
    return solid_voxels(GridMesh(mesh, box.min, voxel_size), extent, closed, workers);
}

Vec3 permuted(const Vec3& v, const AxisOrder& order) { return {v[order[0]], v[order[1]], v[order[2]]}; }

}  // namespace

int voxels_along(double size, double voxel_size) {
    const double voxels = std::ceil(size / voxel_size - kSurfaceShrink);
    if (!(voxels <= kMaxAlong)) {
        throw ResourceError("a part of " + std::to_string(size) + " mm is too large for voxels of " +
                            std::to_string(voxel_size) + " mm");
    }
    return std::max(1, static_cast<int>(voxels));
}

BitGrid voxelize(const Mesh& mesh, double voxel_size, const Workers& workers) {
    return voxels_of(mesh, bounding_box(mesh), encloses_solid(mesh), voxel_size, workers);
}

StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size, const Workers& workers) {
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
    return {solid_voxels(GridMesh(mesh, box.min, voxel_size, shift), extent, encloses_solid(mesh), workers), position};
}

std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh, const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers) {
    const bool closed = encloses_solid(mesh);
    // Of rotations that differ in the order of their axes the first, the root, is voxelised.
    struct Source {
        std::size_t root;
        AxisOrder order;
    };
    std::vector<Source> sources;
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        std::optional<AxisOrder> order;
        for (std::size_t k = 0; k < roots.size() && !order; ++k) {
            order = exchanged_axes(rotations[i], rotations[roots[k]]);
            if (order) sources.push_back({roots[k], *order});
        }
        if (order) continue;
        sources.push_back({i, {0, 1, 2}});
        roots.push_back(i);
    }

    std::vector<OrientedVoxels> result(rotations.size());
    workers.for_each(static_cast<std::int64_t>(roots.size()), [&](std::int64_t k) {
        const std::size_t root = roots[static_cast<std::size_t>(k)];
        const Mesh turned = transformed(mesh, {rotations[root], {}});
        const Box box = bounding_box(turned);
        result[root] = {voxels_of(turned, box, closed, voxel_size, workers), box.size(), box.min};
    });
    workers.for_each(static_cast<std::int64_t>(sources.size()), [&](std::int64_t task) {
        const auto i = static_cast<std::size_t>(task);
        if (sources[i].root == i) return;
        const OrientedVoxels& root = result[sources[i].root];
        const AxisOrder& order = sources[i].order;
        result[i] = {permuted(root.solid, order), permuted(root.size, order), permuted(root.min, order)};
    });
    return result;
}

}  // namespace spectralpack
