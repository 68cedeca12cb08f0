#pragma once
/// What distances between the centres of voxels tell of which voxels lie near a surface: all but a thin layer.

#include "core/parallel.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

struct ToldByCentres {
    BitGrid near;  ///< voxels that are sure to lie nearer than `reach` to the surface
    BitGrid far;   ///< and those that are sure not to; what is in neither is within about 1.8 voxels of that distance
};

/// True for a reach and grid for which told_by_centres() is made: its sums have 16 bits, and its memory a bound.
bool centres_can_tell(const Extent& extent, double reach);

/// `entered`: voxels so that each point of the surface lies in the closed cube of one of them, and each cube has one,
/// to 1e-6 voxels. `reach` > 0, in voxels. A point in a cube is no farther from another cube than their centres are
/// from each other, and nearer by the diagonal of a voxel, the square root of 3, at most. Distances are found axis by
/// axis (Saito and Toriwaki 1994): O(voxels * reach), eight at a time.
ToldByCentres told_by_centres(const BitGrid& entered, double reach, const Workers& workers);

}  // namespace spectralpack
