#pragma once
/// A+g of docs/conventions.md: an object's voxels widened by a gap in millimetres, whatever the
/// voxel size.

#include "core/parallel.hpp"
#include "geometry/mesh.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// Voxels whose open interior lies nearer than `gap` (Euclidean, less kGapTolerance) to the solid.
struct WidenedVoxels {
    BitGrid voxels;
    VoxelIndex offset;  ///< of its voxel (0,0,0) in the unwidened grid; components <= 0
};

inline constexpr double kGapTolerance = 1e-6;  ///< mm: so that a voxel exactly `gap` away stays out

/// `solid` must be voxelize(mesh, voxel_size). gap > 0, finite. The result contains `solid`.
/// Exact: decided by the distance between the closed voxel and the mesh's triangles.
/// Throws ResourceError where the result would be beyond all memory.
WidenedVoxels widen(const BitGrid& solid, const Mesh& mesh, double voxel_size, double gap, const Workers& workers);

}  // namespace spectralpack
