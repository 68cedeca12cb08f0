#pragma once
/// Grids with their axes exchanged, and the rotations that differ in nothing else.

#include <array>
#include <optional>

#include "geometry/transform.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

using AxisOrder = std::array<int, 3>;  ///< a permutation of 0, 1, 2: axis i is taken from axis order[i]

/// The grid whose axis i is axis order[i] of `grid`.
BitGrid permuted(const BitGrid& grid, const AxisOrder& order);

/// The order with turn.rows[i] == of.rows[order[i]], where there is one: then what `turn` does to a
/// mesh is what `of` does with the axes exchanged, to the last bit, and so are the voxels. Of the
/// 24 rotations of the cube 8 are left. (Not the reversal of an axis: the grid starts at the box
/// minimum, and lies otherwise on the mesh after it.)
std::optional<AxisOrder> exchanged_axes(const Mat3& turn, const Mat3& of);

}  // namespace spectralpack
