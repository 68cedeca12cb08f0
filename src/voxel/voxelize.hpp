#pragma once
/// Solid voxelisation: the definition every engine shares ("Solid voxels" in docs/conventions.md;
/// the paper's section 3.1 asks for a conservative voxelisation, after Schwarz and Seidel 2010).
///
/// A voxel belongs to an object if its open interior meets the solid:
///  - the surface enters it: some triangle, drawn in by kSurfaceShrink voxel sizes, meets the voxel
///    (separating-axis test), so a face that lies on a voxel face marks neither side by itself; or
///  - its centre has a non-zero winding number (closed meshes only: for an open mesh it is not
///  defined); or
///  - it cannot be reached from outside through voxels that are not solid (6-connected): closed
///  hollows are
///    filled and never used.
/// The mesh's box minimum lies on a voxel corner. Self-intersections, several shells and inside-out
/// shells work.

#include <vector>

#include "core/parallel.hpp"
#include "geometry/mesh.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

inline constexpr double kSurfaceShrink = 1e-4;  ///< in voxel sizes

/// Voxels along one axis of a mesh box of this size (mm): ceil, less the shrink, at least one.
int voxels_along(double size, double voxel_size);

/// Voxels of `mesh` (mm, already rotated and scaled), extent = voxels_along(box size) per axis;
/// voxel (0,0,0)'s lower corner is the box minimum. Never empty for a mesh with a triangle.
/// O(triangles + voxels met). Throws ResourceError when the grid would exceed 2^40 voxels.
BitGrid voxelize(const Mesh& mesh, double voxel_size, const Workers& workers);

/// A mesh that stands off the grid (a refined placement, section 3.2).
struct StandingVoxels {
    BitGrid solid;
    VoxelIndex position;  ///< of solid's voxel (0,0,0) in the grid
};

/// voxelize() of a mesh whose box minimum stands at `corner`, mm from the grid's lower corner; the
/// mesh's own coordinates only say its shape. A corner within kSurfaceShrink of a voxel's end
/// belongs to the next voxel; where it is a voxel corner, the result is that of voxelize().
StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size,
                           const Workers& workers);

/// A mesh in one orientation: what voxelize() and the box give for the mesh turned by `rotation`.
struct OrientedVoxels {
    BitGrid solid;
    Vec3 size;  ///< of the turned mesh's box, mm
    Vec3 min;   ///< the turned mesh's box minimum, mm: the transform of position q is q * dx - min
};

/// voxelize() for every rotation, in their order. Axis permutations with signs are voxelised once
/// per sign pattern (8 times, not 24) and permuted, which is what voxelising each would give.
std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh,
                                                  const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers);

}  // namespace spectralpack
