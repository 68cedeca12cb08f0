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
#include "voxel/permute.hpp"
#include "voxel/surface.hpp"
#include "voxel/winding.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 40;
constexpr double kMaxAlong = 1 << 30;
constexpr std::int64_t kGrain = 1 << 13;  ///< triangles a task takes at least

/// Which axes of a mesh are reversed before it is voxelised: x becomes -x.
using Signs = std::array<bool, 3>;

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

/// A mesh seen from its grid.
class GridMesh {
  public:
    GridMesh(const Mesh& mesh, const Box& box, const Signs& reversed, double voxel_size)
        : triangles_(mesh.triangles), vertices_(mesh.vertices.size()) {
        // Differences and quotients round alike for x and -x: a reversed mesh gets the bits it
        // would get if it were turned first.
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                const double v = mesh.vertices[i][axis];
                const double distance = reversed[static_cast<std::size_t>(axis)]
                                            ? box.max[axis] - v
                                            : v - box.min[axis];
                vertices_[i][axis] = distance / voxel_size;
            }
        }
    }

    std::int64_t size() const { return static_cast<std::int64_t>(triangles_.size()); }
    GridTriangle operator[](std::int64_t i) const {
        const Triangle& t = triangles_[static_cast<std::size_t>(i)];
        return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    }

  private:
    const std::vector<Triangle>& triangles_;
    std::vector<Vec3> vertices_;
};

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

/// A rotation that takes axes to axes: its axis i is `axes[i]` of the mesh with `reversed` axes (of
/// the mesh).
struct AxisTurn {
    std::array<int, 3> axes;
    Signs reversed;
};

std::optional<AxisTurn> axis_turn(const Mat3& rotation) {
    AxisTurn turn{{-1, -1, -1}, {}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double entry = rotation.rows[static_cast<std::size_t>(row)][column];
            if (entry == 0) continue;
            if (std::abs(entry) != 1 || turn.axes[static_cast<std::size_t>(row)] != -1)
                return std::nullopt;
            turn.axes[static_cast<std::size_t>(row)] = column;
            turn.reversed[static_cast<std::size_t>(column)] = entry < 0;
        }
    }
    const auto& a = turn.axes;
    if (a[0] < 0 || a[1] < 0 || a[2] < 0 || a[0] == a[1] || a[1] == a[2] || a[0] == a[2]) {
        return std::nullopt;
    }
    return turn;
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

std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh,
                                                  const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers) {
    const bool closed = encloses_solid(mesh);
    const Box box = bounding_box(mesh);
    std::vector<Signs> patterns;          // of the axis turns among the rotations
    std::vector<std::size_t> pattern_of;  // by rotation
    std::vector<std::optional<AxisTurn>> turns;
    for (const Mat3& rotation : rotations) {
        turns.push_back(axis_turn(rotation));
        if (turns.back()) {
            const auto known = std::ranges::find(patterns, turns.back()->reversed);
            pattern_of.push_back(static_cast<std::size_t>(known - patterns.begin()));
            if (known == patterns.end()) patterns.push_back(turns.back()->reversed);
        } else {
            pattern_of.push_back(0);
        }
    }

    std::vector<OrientedVoxels> by_pattern(patterns.size());
    workers.for_each(static_cast<std::int64_t>(patterns.size()), [&](std::int64_t task) {
        const auto i = static_cast<std::size_t>(task);
        by_pattern[i] = reversed_voxels(mesh, box, patterns[i], closed, voxel_size, workers);
    });
    std::vector<OrientedVoxels> result(rotations.size());
    workers.for_each(static_cast<std::int64_t>(rotations.size()), [&](std::int64_t task) {
        const auto i = static_cast<std::size_t>(task);
        if (!turns[i]) {
            result[i] = turned_voxels(mesh, rotations[i], closed, voxel_size, workers);
            return;
        }
        const OrientedVoxels& source = by_pattern[pattern_of[i]];
        const std::array<int, 3>& axes = turns[i]->axes;
        result[i] = {permuted(source.solid, axes), permuted(source.size, axes),
                     permuted(source.min, axes)};
    });
    return result;
}

}  // namespace spectralpack
