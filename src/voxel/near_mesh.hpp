#pragma once
/// The voxels near a mesh: how objects are widened.

#include "core/parallel.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/grid_mesh.hpp"

namespace spectralpack {

/// Sets the voxels of `grid` whose closed cube lies nearer than `reach` (in voxel sizes, > 0) to a triangle of the
/// mesh, which lies within the grid. The grid's voxel (0,0,0) is voxel `first` in the mesh's coordinates. Each voxel is
/// decided by itself, by set_near()'s test of a triangle, so what comes out does not depend on the threads.
void set_near(BitGrid& grid, const VoxelIndex& first, const GridMesh& mesh, double reach, const Workers& workers);

}  // namespace spectralpack
