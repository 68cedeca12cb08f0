#pragma once
/// A+g of docs/conventions.md: an object's voxels widened by a gap in millimetres, whatever the
/// voxel size.

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/lazy_grid.hpp"

namespace spectralpack {

/// Voxels whose open interior lies nearer than `gap` (Euclidean, less kGapTolerance) to the solid.
struct WidenedVoxels {
    LazyGrid voxels;
    VoxelIndex offset;  ///< of its voxel (0,0,0) in the unwidened grid; components <= 0

    /// The very same grid, not an equal one.
    bool operator==(const WidenedVoxels&) const = default;
};

/// Whether no two objects in a container of this size can keep such a gap, wherever they stand: one is all it holds.
inline bool holds_one_only(const Vec3& size, double gap) { return gap > length(size); }

inline constexpr double kGapTolerance = 1e-6;  ///< mm: so that a voxel exactly `gap` away stays out

/// `solid` are the mesh's voxels, `corner` is that of its voxel (0,0,0), not above the box minimum. gap > 0, finite.
/// The result contains `solid`. Exact: decided by the distance between the closed voxel and the mesh's triangles.
/// Throws ResourceError where the result would be beyond all memory.
WidenedVoxels widen(const BitGrid& solid, const Mesh& mesh, const Vec3& corner, double voxel_size, double gap,
                    const Workers& workers);

/// What widen() gives for the mesh turned, from that of the mesh, voxels once they are asked for; `solid` is the extent
/// of the unwidened voxels.
WidenedVoxels turned(const WidenedVoxels& widened, const Extent& solid, const AxisTurn& turn);

}  // namespace spectralpack
