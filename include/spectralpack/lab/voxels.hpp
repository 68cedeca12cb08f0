#pragma once
/// The laboratory: voxels, for people who write their own strategies. What a mesh's voxels are is one definition for
/// all engines (docs/conventions.md, "Solid voxels"; the paper's section 3.1).

#include <cstdint>
#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/grid.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack::lab {

/// Voxels of a mesh, a byte each: 1 where the voxel's open interior meets the solid, else 0. Index order: x fastest,
/// then y, then z.
struct Voxels {
    Grid<std::uint8_t> solid;
    double voxel_size = 0;  ///< mm
    Vec3 corner;            ///< of voxel (0,0,0), in the mesh's coordinates, mm
};

/// The same, a bit each. A row is the voxels of one (y, z) along x in `words_per_row` whole words, rows by y, then z:
/// voxel x is bit x % 64 of word x / 64. Bits beyond the extent are 0.
struct VoxelBits {
    Extent extent;
    int words_per_row = 0;
    std::vector<std::uint64_t> words;
    double voxel_size = 0;
    Vec3 corner;

    bool at(int x, int y, int z) const {
        const auto row = static_cast<std::size_t>(static_cast<std::int64_t>(z) * extent.y + y);
        const std::size_t word = row * static_cast<std::size_t>(words_per_row) + static_cast<std::size_t>(x / 64);
        return (words[word] >> (x % 64)) & 1;
    }
};

/// Solid voxels of `mesh` as it lies, in millimetres. The mesh stands in the middle of its voxels: per axis their
/// number is the box's size / voxel_size, rounded up. Closed hollows are filled; a mesh that is not closed has its
/// surface only. O(triangles + voxels met). Throws UsageError unless voxel_size > 0, InputError for a mesh that cannot
/// be used (spectralpack/job.hpp), ResourceError beyond 2^40 voxels. `threads` <= 0: all the machine has.
Voxels voxelize(const Mesh& mesh, double voxel_size, int threads = 0);
VoxelBits voxelize_bits(const Mesh& mesh, double voxel_size, int threads = 0);

}  // namespace spectralpack::lab
