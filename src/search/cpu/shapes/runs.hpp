#pragma once
/// A solid as straight runs of voxels along one axis: each voxel in exactly one run, no two runs
/// touching end to end. What a run costs does not depend on its length, neither in the collision
/// test nor in rho, so the axis with the fewest runs is taken: a plate has 20 times fewer along its
/// plane than across it.

#include <cstdint>
#include <vector>

#include "voxel/bit_grid.hpp"

namespace spectralpack {

struct Run {
    VoxelIndex start;
    int length = 0;

    bool operator==(const Run&) const = default;
};

struct Runs {
    int axis = 0;
    std::vector<Run> runs;
    std::int64_t voxels = 0;
};

/// Number of maximal runs along each axis; O(words).
std::vector<std::int64_t> count_runs(const BitGrid& bits);

/// The maximal runs along `axis`, ordered by start (z, y, x). O(words + runs).
Runs runs_along(const BitGrid& bits, int axis);

/// runs_along() the axis with the fewest; ties by axis.
Runs fewest_runs(const BitGrid& bits);

}  // namespace spectralpack
