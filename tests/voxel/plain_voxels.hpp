#pragma once
/// The definition of solid voxels ("Solid voxels" in docs/conventions.md) written plainly: every
/// voxel against every triangle, winding numbers by solid angles, a flood fill voxel by voxel.
/// Shares no code with src/voxel.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/mesh_edges.hpp"
#include "spectralpack/mesh.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack::test {

using PlainTriangle = std::array<Vec3, 3>;

/// Textbook separating-axis test: the triangle and the open cube of half side `half` around
/// `centre`.
inline bool meets_cube(const PlainTriangle& triangle, const Vec3& centre, double half) {
    std::array<Vec3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
        v[i] = triangle[i] - centre;
    }
    const std::array<Vec3, 3> units{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    const std::array<Vec3, 3> edges{v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    std::vector<Vec3> axes(units.begin(), units.end());
    axes.push_back(cross(edges[0], edges[1]));
    for (const Vec3& edge : edges) {
        for (const Vec3& unit : units) {
            axes.push_back(cross(edge, unit));
        }
    }
    for (const Vec3& axis : axes) {
        const double size = length(axis);
        if (size < 1e-12) continue;  // parallel edges: no axis
        const double a = dot(axis, v[0]), b = dot(axis, v[1]), c = dot(axis, v[2]);
        const double reach = half * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
        const double rounding = 1e-12 * size;
        const bool box_axis = &axis < axes.data() + 3;
        const double slack = box_axis ? 0 : rounding;
        if (std::min({a, b, c}) >= reach + slack || std::max({a, b, c}) <= -reach - slack) return false;
    }
    return true;
}

/// Sum of the triangles' solid angles over 4 pi (Van Oosterom and Strackee 1983).
inline int winding_number(const std::vector<PlainTriangle>& triangles, const Vec3& point) {
    double sum = 0;
    for (const PlainTriangle& t : triangles) {
        const Vec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
        const double la = length(a), lb = length(b), lc = length(c);
        sum += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

/// Voxels that a breadth-first walk from the grid's outside does not reach are set.
inline void plain_fill(BitGrid& grid) {
    const Extent& n = grid.extent();
    Grid<char> outside(n);
    std::vector<VoxelIndex> stack;
    const auto visit = [&](const VoxelIndex& i) {
        if (!n.contains(i) || grid.get(i.x, i.y, i.z) || outside.at(i.x, i.y, i.z)) return;
        outside.at(i.x, i.y, i.z) = 1;
        stack.push_back(i);
    };
    const std::array<VoxelIndex, 6> steps{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                for (const VoxelIndex& step : steps) {
                    if (!n.contains(VoxelIndex{x, y, z} + step)) visit({x, y, z});
                }
            }
        }
    }
    while (!stack.empty()) {
        const VoxelIndex i = stack.back();
        stack.pop_back();
        for (const VoxelIndex& step : steps) {
            visit(i + step);
        }
    }
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            for (int x = 0; x < n.x; ++x) {
                if (!outside.at(x, y, z)) grid.set(x, y, z);
            }
        }
    }
}

/// Voxels from there on that a mesh takes along an axis up to its box maximum.
inline int plain_count(double reach, double voxel_size) {
    return std::max(1, static_cast<int>(std::ceil(reach / voxel_size - 1e-4)));
}

/// Where a mesh's voxel (0,0,0) has its corner: it leaves as much of its voxels on either side.
inline Vec3 plain_corner(const Mesh& mesh, double voxel_size) {
    const Box box = bounding_box(mesh);
    Vec3 corner = box.min;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = box.size()[axis], voxels = voxel_size * plain_count(size, voxel_size);
        if (voxels > size) corner[axis] -= (voxels - size) / 2;
    }
    return corner;
}

/// The mesh's triangles in voxel sizes from there.
inline std::vector<PlainTriangle> grid_triangles(const Mesh& mesh, double voxel_size, const Vec3& origin) {
    std::vector<PlainTriangle> triangles;
    for (const Triangle& t : mesh.triangles) {
        PlainTriangle& triangle = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            triangle[i] = (1 / voxel_size) * (mesh.vertices[t[i]] - origin);
        }
    }
    return triangles;
}

/// `corner`: of voxel (0,0,0), at most a voxel below the box minimum.
inline BitGrid plain_voxels(const Mesh& mesh, double voxel_size, const Vec3& corner) {
    const Vec3 reach = bounding_box(mesh).max - corner;
    Extent n;
    for (int axis = 0; axis < 3; ++axis) {
        n[axis] = plain_count(reach[axis], voxel_size);
    }
    const std::vector<PlainTriangle> triangles = grid_triangles(mesh, voxel_size, corner);
    const bool closed = is_closed(mesh);
    BitGrid grid(n);
    // Drawn in; drawn out where that marks nothing.
    for (const double half : {0.5 - 1e-4, 0.5 + 1e-4}) {
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y) {
                for (int x = 0; x < n.x; ++x) {
                    const Vec3 centre{x + 0.5, y + 0.5, z + 0.5};
                    bool solid = false;
                    for (const PlainTriangle& triangle : triangles) {
                        solid = solid || meets_cube(triangle, centre, half);
                    }
                    if (solid || (closed && winding_number(triangles, centre) != 0)) grid.set(x, y, z);
                }
            }
        }
        if (!grid.none()) break;
    }
    plain_fill(grid);
    return grid;
}

inline BitGrid plain_voxels(const Mesh& mesh, double voxel_size) {
    return plain_voxels(mesh, voxel_size, plain_corner(mesh, voxel_size));
}

}  // namespace spectralpack::test
