#pragma once
/// A mesh seen from its voxel grid.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Which axes of a mesh are reversed: x becomes -x.
using Signs = std::array<bool, 3>;

/// Coordinates in voxel sizes from the grid's lower corner. Refers to the mesh, which must outlive
/// it.
class GridMesh {
  public:
    /// `box` is the mesh's; `shift` that of the (reversed) box minimum from the grid's lower
    /// corner, in voxel sizes.
    ///
    /// Differences and quotients round alike for x and -x: a mesh with reversed axes has, bit by
    /// bit, the coordinates that it would have if it were turned first.
    GridMesh(const Mesh& mesh, const Box& box, const Signs& reversed, double voxel_size,
             const Vec3& shift = {});

    std::int64_t size() const { return static_cast<std::int64_t>(triangles_.size()); }
    GridTriangle operator[](std::int64_t i) const {
        const Triangle& t = triangles_[static_cast<std::size_t>(i)];
        return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    }

  private:
    const std::vector<Triangle>& triangles_;
    std::vector<Vec3> vertices_;
};

}  // namespace spectralpack
