#pragma once
/// A mesh seen from its voxel grid.

#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Coordinates in voxel sizes from the grid's lower corner. Refers to the mesh, which must outlive
/// it.
class GridMesh {
  public:
    /// `box_min` is the mesh's; `shift` says how far that is from the grid's lower corner, in voxel
    /// sizes.
    GridMesh(const Mesh& mesh, const Vec3& box_min, double voxel_size, const Vec3& shift = {});

    std::int64_t size() const { return static_cast<std::int64_t>(triangles_.size()); }
    GridTriangle operator[](std::int64_t i) const {
        const Triangle& t = triangles_[static_cast<std::size_t>(i)];
        return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    }

    /// The mesh in these coordinates.
    Mesh in_grid() const { return {vertices_, triangles_}; }

  private:
    const std::vector<Triangle>& triangles_;
    std::vector<Vec3> vertices_;
};

inline constexpr std::int64_t kTrianglesPerTask = 1 << 11;  ///< at least

/// Calls visit(triangle) for each of the mesh, from several threads.
template <class Visit>
void for_each_triangle(const GridMesh& mesh, const Workers& workers, Visit visit) {
    workers.for_ranges(mesh.size(), kTrianglesPerTask, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            visit(mesh[i]);
            if (i % kTrianglesPerTask == 0) workers.check();
        }
    });
}

}  // namespace spectralpack
