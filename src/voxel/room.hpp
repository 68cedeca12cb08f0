#pragma once
/// Which voxels of a grid are not wholly free: what lies outside a closed mesh, and what a mesh or a box takes up.
/// Grids here stand anywhere: `origin` is the lower corner of voxel (0,0,0), in the mesh's coordinates, mm. Voxels
/// nearer than `gap` mm (Euclidean, less kGapTolerance) count as taken, too; with gap 0 what only touches does not.

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

struct GridPlace {
    Vec3 origin;
    double voxel_size = 1;
};

/// Sets the voxels of `grid` that are not wholly inside the closed mesh.
void set_outside(BitGrid& grid, const GridPlace& place, const Mesh& mesh, double gap, const Workers& workers);

/// Sets the voxels of `grid` that the solid of the mesh enters.
void set_taken(BitGrid& grid, const GridPlace& place, const Mesh& mesh, double gap, const Workers& workers);

/// The same for a box, and with the box grown by the gap on every side.
void set_taken(BitGrid& grid, const GridPlace& place, const Box& box, double gap);

}  // namespace spectralpack
