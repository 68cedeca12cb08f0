#pragma once
/// Solid voxelisation: the definition every engine shares ("Solid voxels" in docs/conventions.md;
/// the paper's section 3.1 asks for a conservative voxelisation, after Schwarz and Seidel 2010).
///
/// A voxel belongs to an object if its open interior meets the solid:
///  - the surface enters it: some triangle meets the voxel's cube (separating-axis test), the cube
///    drawn in by kSurfaceShrink on every side, so that a face that lies on a voxel face marks
///    neither side by itself; or
///  - its centre has a non-zero winding number (closed meshes only: else it is undefined); or
///  - it cannot be reached from outside through voxels that are not solid (from face to face):
///    closed hollows are filled and never used.
/// The mesh stands in the middle of its voxels, so those of a turned mesh are its voxels turned.
/// Self-intersections, several shells and inside-out shells work. A mesh that marks nothing this way (thinner than the
/// shrink, or open and with all its faces on voxel faces) is tested against cubes drawn out by as much instead.

#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/lazy_grid.hpp"

namespace spectralpack {

inline constexpr double kSurfaceShrink = 1e-4;  ///< in voxel sizes

/// Voxels along one axis of a mesh box of this size (mm): ceil, less the shrink, at least one.
int voxels_along(double size, double voxel_size);

/// How far the box minimum of a mesh with a box of this size (mm) lies above the corner of its voxel (0,0,0), mm: on
/// either side as much of its voxels is left over.
Vec3 inset(const Vec3& size, double voxel_size);

/// Voxels of `mesh` (mm, already rotated and scaled), extent = voxels_along(box size) per axis;
/// voxel (0,0,0)'s lower corner lies inset() below the box minimum. Never empty for a mesh with a triangle.
/// O(triangles + voxels met). Throws ResourceError when the grid would exceed 2^40 voxels.
BitGrid voxelize(const Mesh& mesh, double voxel_size, const Workers& workers);

/// A mesh that stands off the grid (a refined placement, section 3.2).
struct StandingVoxels {
    BitGrid solid;
    VoxelIndex position;  ///< of solid's voxel (0,0,0) in the grid
};

/// voxelize() of a mesh whose box minimum stands at `corner`, mm from the grid's lower corner; the
/// mesh's own coordinates only say its shape. A corner within kSurfaceShrink of a voxel's end
/// belongs to the next voxel; where it is inset() above a voxel corner, the result is that of voxelize().
StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size, const Workers& workers);
/// The same for who knows already whether the mesh is_closed().
StandingVoxels voxelize_at(const Mesh& mesh, const Vec3& corner, double voxel_size, bool closed,
                           const Workers& workers);

/// Room for a part of any size.
inline constexpr Vec3 kAnyRoom{Box::kInfinity, Box::kInfinity, Box::kInfinity};

/// A mesh in one orientation.
struct OrientedVoxels {
    LazyGrid solid;
    Vec3 corner;  ///< of voxel (0,0,0), in the turned mesh's coordinates: position q moves it by q * dx - corner
    Vec3 reach;   ///< from there to the turned mesh's box maximum, mm
    std::size_t origin = 0;  ///< the rotation that was voxelised and whose voxels these are, turned:
    AxisTurn turn;
};

/// The voxels for every rotation, in their order. Of rotations that differ by an axis_turn() the first is voxelised,
/// and its voxels are turned for the others once they are asked for: one of the cube's 24 rotations, 14 of the 208 in
/// steps of 45 degrees. But where the inset keeps a turned mesh out of `room`, mm, into which its box fits, it is
/// voxelised by itself, with the box minimum on the corner along those axes.
std::vector<OrientedVoxels> voxelize_orientations(const Mesh& mesh, const std::vector<Mat3>& rotations,
                                                  double voxel_size, const Workers& workers,
                                                  const Vec3& room = kAnyRoom);

}  // namespace spectralpack
