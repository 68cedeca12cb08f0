#pragma once
/// Fine voxels of dx / s seen from coarse ones of dx, s being the detail of a tray. Positions are whole multiples of
/// dx, so the fine voxel f = s x + p (0 <= p < s per axis) that is moved by a position stays in its *part* p: two fine
/// grids meet exactly if two of their equal parts do, each a grid of coarse size.

#include <vector>

#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// Number of parts: s to the third.
inline int part_count(int detail) { return detail * detail * detail; }

/// a / b rounded down; b > 0. Details of 1 and 2 are what nearly all ask for, and to divide takes ten times as long.
inline int floor_div(int a, int b) {
    if (b <= 2) return a >> (b - 1);
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// a / b rounded up; b > 0.
inline int ceil_div(int a, int b) { return -floor_div(-a, b); }

struct SplitVoxels {
    std::vector<BitGrid> parts;  ///< part (px, py, pz) has index (pz s + py) s + px; all of one extent
    VoxelIndex offset;           ///< of their voxel (0,0,0), in coarse voxels
};

/// The parts of `fine`, whose voxel (0,0,0) is the fine voxel `at`. O(voxels set).
SplitVoxels split(const BitGrid& fine, const VoxelIndex& at, int detail);

struct CoarseVoxels {
    BitGrid voxels;
    VoxelIndex offset;  ///< of its voxel (0,0,0), in coarse voxels
};

/// The coarse voxels of which some fine voxel is set. O(fine words + coarse voxels).
CoarseVoxels reached_voxels(const BitGrid& fine, const VoxelIndex& at, int detail);

/// The coarse voxels of which every fine voxel is set. O(fine words + coarse voxels).
CoarseVoxels filled_voxels(const BitGrid& fine, const VoxelIndex& at, int detail);

}  // namespace spectralpack
