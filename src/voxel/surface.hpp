#pragma once
/// First part of a solid voxelisation: the voxels that the surface enters.

#include "voxel/bit_grid.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Sets the voxels of `grid` that the triangle meets, each taken as its cube drawn in by `shrink`
/// on every side. May be called from several threads at once.
void set_surface(BitGrid& grid, const GridTriangle& triangle, double shrink);

}  // namespace spectralpack
