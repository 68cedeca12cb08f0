#pragma once
/// The container and its keep-outs as a tray sees them: voxels that are not wholly free, and surfaces that
/// refinement stays clear of.

#include <vector>

#include "core/parallel.hpp"
#include "refine/refiner.hpp"
#include "spectralpack/packing.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/room.hpp"

namespace spectralpack {

/// Voxels of the tray's grid that are not wholly inside the container or nearer than the wall gap to it or to a
/// keep-out. The grid's lower corner is `wall_gap` inside the container's box. An empty grid for a box without
/// keep-outs: there all is free.
BitGrid blocked_voxels(const Container& container, const Extent& grid, double voxel_size, double wall_gap,
                       const Workers& workers);

/// Of a grid at `place`, the voxels that a keep-out enters or comes nearer to than the wall gap.
void set_keep_outs(BitGrid& grid, const GridPlace& place, const Container& container, double wall_gap,
                   const Workers& workers);

/// The same walls as surfaces, with the free side outside. None for the container's box, which the refiner knows.
std::vector<PlacedSurface> wall_surfaces(const Container& container, double wall_gap, const StopToken& stop = {});

}  // namespace spectralpack
