#include "voxel/voxelize.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "geometry/mesh_edges.hpp"
#include "spectralpack/error.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/enclosed.hpp"
#include "voxel/grid_mesh.hpp"
#include "voxel/surface.hpp"
#include "voxel/winding.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 40;
constexpr double kMaxAlong = 1 << 30;

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
    workers.for_ranges(mesh.size(), kTrianglesPerTask, [&](std::int64_t begin, std::int64_t end) {
        Crossings found(extent);
        for (std::int64_t i = begin; i < end; ++i) {
            if (i % kTrianglesPerTask == 0) workers.check();
            const GridTriangle triangle = mesh[i];
            set_surface(grid, triangle, kSurfaceShrink);
            if (closed) found.add(triangle);
        }
        const std::lock_guard lock(appending);
        crossings.append(std::move(found));
    });
    workers.check();
    if (closed) crossings.set_wound(grid);
    workers.check();
    if (grid.none()) {
        // Thinner than the shrink, or an open mesh of faces that all lie on voxel faces.
        for (std::int64_t i = 0; i < mesh.size(); ++i) {
            set_surface(grid, mesh[i], -kSurfaceShrink);
        }
    }
    fill_enclosed(grid);
    return grid;
}

/// `corner`: of voxel (0,0,0), at most a voxel below the box minimum on each axis.
BitGrid voxels_of(const Mesh& mesh, const Box& box, const Vec3& corner, bool closed, double voxel_size,
                  const Workers& workers) {
    return solid_voxels(GridMesh(mesh, corner, voxel_size), grid_extent(box.size(), voxel_size), closed, workers);
}

/// inset(), but 0 along axes where it would keep a box out of the room that it fits into.
Vec3 inset_within(const Vec3& size, double voxel_size, const Vec3& room) {
    Vec3 in = inset(size, voxel_size);
    if (!fits(size, room)) return in;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] + in[axis] > room[axis]) in[axis] = 0;
    }
    return in;
}

}  // namespace

int voxels_along(double size, double voxel_size) {
    const double voxels = std::ceil(size / voxel_size - kSurfaceShrink);
    if (!(voxels <= kMaxAlong)) {
        throw ResourceError("a part of " + std::to_string(size) + " mm is too large for voxels of " +
                            std::to_string(voxel_size) + " mm");
    }
    return std::max(1, static_cast<int>(voxels));
}

Vec3 inset(const Vec3& size, double voxel_size) {
    Vec3 in;
    for (int axis = 0; axis < 3; ++axis) {
        in[axis] = std::max(0.0, voxels_along(size[axis], voxel_size) * voxel_size - size[axis]) / 2;
    }
    return in;
}

BitGrid voxelize(const Mesh& mesh, double voxel_size, const Workers& workers) {
    const Box box = bounding_box(mesh);
    return voxels_of(mesh, box, box.min - inset(box.size(), voxel_size), is_closed(mesh), voxel_size, workers);
}

StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size, const Workers& workers) {
    return voxelize_at(mesh, corner, voxel_size, is_closed(mesh), workers);
}

StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size, bool closed,
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
    return {solid_voxels(GridMesh(mesh, box.min, voxel_size, shift), extent, closed, workers), position};
}

std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh, const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers, const Vec3& room) {
    const bool closed = is_closed(mesh);
    std::vector<OrientedVoxels> result(rotations.size());
    const auto stand = [&](std::size_t i, const Box& box) {
        const Vec3 in = inset_within(box.size(), voxel_size, room);
        result[i].corner = box.min - in;
        result[i].reach = box.size() + in;
        return in == inset(box.size(), voxel_size);
    };
    std::vector<Box> boxes(rotations.size());
    std::vector<std::size_t> origins;  // whose voxels others may have
    std::vector<std::size_t> own;      // whose voxels are made from the mesh
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        std::optional<AxisTurn> turn;
        for (std::size_t k = 0; k < origins.size() && !turn; ++k) {
            turn = axis_turn(rotations[origins[k]], rotations[i]);
            if (turn) result[i].origin = origins[k];
        }
        boxes[i] = turn ? turned(boxes[result[i].origin], *turn) : bounding_box(transformed(mesh, {rotations[i], {}}));
        const bool in_the_middle = stand(i, boxes[i]);
        if (turn && in_the_middle) {
            result[i].turn = *turn;
            continue;
        }
        result[i].origin = i;
        own.push_back(i);
        if (in_the_middle) origins.push_back(i);
    }
    workers.for_each(static_cast<std::int64_t>(own.size()), [&](std::int64_t k) {
        const std::size_t i = own[static_cast<std::size_t>(k)];
        const Mesh one = transformed(mesh, {rotations[i], {}});
        result[i].solid = LazyGrid(voxels_of(one, boxes[i], result[i].corner, closed, voxel_size, workers));
    });
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        if (result[i].origin != i) result[i].solid = turned(result[result[i].origin].solid, result[i].turn);
    }
    return result;
}

}  // namespace spectralpack
