#pragma once
/// Second part of a solid voxelisation: the voxels whose centre the surface winds round.

#include <vector>

#include "voxel/bit_grid.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Where the rays along x through the voxel centres cross a closed surface. Added up along a row,
/// signed, they give the winding number of each centre.
///
/// A ray meets a triangle where it meets its chord in the plane z = centre. The chord's ends are on
/// edges, and are computed from the edge alone, lower end first: two triangles that share an edge
/// get the same point. A plane meets the half-open edges with low z <= centre < high z, and the ray
/// passes a chord's end or not by y > centre, so every edge counts once for each triangle, with
/// opposite signs: the sum along a whole row is 0, exactly, whatever the rounding. A crossing is
/// within rounding of the true surface even where the ray runs along it, and voxels whose centre is
/// that close to the surface are set by it anyhow.
class Crossings {
  public:
    /// Rays of the rows of a grid of this extent.
    explicit Crossings(const Extent& extent) : extent_(extent) {}

    void add(const GridTriangle& triangle);
    void append(Crossings other);

    /// Sets the voxels of `grid` (of the same extent) with a winding number other than 0.
    /// O(crossings + rows).
    void set_wound(BitGrid& grid) const;

  private:
    struct Crossing {
        std::int64_t row;  ///< z * ny + y
        int x;             ///< the first voxel whose centre is beyond the surface
        int sign;
    };

    class Edge;
    void add_chord(const Edge& up, const Edge& down, int z);

    Extent extent_;
    std::vector<Crossing> crossings_;
};

}  // namespace spectralpack
