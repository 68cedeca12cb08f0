#pragma once
/// The voxels near a triangle: a step of widening objects and of keeping clear of walls.

#include "core/parallel.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Sets the voxels of `grid` whose closed cube lies nearer than `reach` (in voxel sizes, > 0) to the triangle. The
/// grid's voxel (0,0,0) is voxel `first` in the triangle's coordinates. Any number of threads may, at once: each voxel
/// is decided by itself, so what comes out does not depend on who was first. Of `workers` only check() is called.
void set_near(BitGrid& grid, const VoxelIndex& first, const GridTriangle& triangle, double reach,
              const Workers& workers);

}  // namespace spectralpack
