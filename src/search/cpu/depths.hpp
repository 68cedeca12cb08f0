#pragma once
/// How deep a solid's voxels lie inside it, which bounds phi from below where the solid is free: all voxels nearer to x
/// than delta(x) belong to the solid, so at a free position q none of them is occupied and phi(x + q) >= delta(x).

#include <cstdint>
#include <vector>

#include "search/cpu/runs.hpp"

namespace spectralpack {

inline constexpr int kDeepest = 63;

/// For each of `runs`, within the solid's grid, the sum over its voxels of delta(x) = min(kDeepest, Manhattan distance
/// from x to the nearest voxel outside `solid`). `solid_runs` are the solid's own. O(voxels of the solid's grid).
std::vector<std::uint32_t> depth_sums(const BitGrid& solid, const Runs& solid_runs, const Runs& runs);

}  // namespace spectralpack
