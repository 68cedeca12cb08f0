#pragma once
/// What the placement search sees of a part: its voxels in each distinct orientation. Immutable
/// once made (but for voxels that are turned when asked for) and shared by all copies of the part.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "voxel/axis_turn.hpp"
#include "voxel/voxel_box.hpp"
#include "voxel/voxelize.hpp"
#include "voxel/widen.hpp"

namespace spectralpack {

struct OrientedShape {
    int orientation = 0;  ///< index in the job's orientation set
    Vec3 reach;           ///< from the corner to the box maximum, mm: decides the candidates
    Vec3 corner;          ///< of voxel (0,0,0), in the turned mesh's coordinates, mm
    LazyGrid solid;       ///< A
    /// A+g, in voxels of dx / s, against the objects of each gap class of the tray, where g = max(own
    /// gap, the class's gap); for g = 0 the unwidened voxels with offset 0. Each holds the unwidened voxels. One per
    /// class, in the tray's order; equal g share one grid.
    std::vector<WidenedVoxels> widened;
    /// The unwidened voxels of dx / s; with s = 1 it may be none, `solid` being the same. A is the voxels of dx that it
    /// reaches into.
    LazyGrid fine{};
    /// All voxels here, those of dx and finer ones, are those of orientation `turned_from` of the shape turned like
    /// that; -1: of none that comes before. Where the turn reverses an axis, that one follows from none; where it only
    /// exchanges axes, from none or by a turn that reverses one.
    int turned_from = -1;
    AxisTurn turn{};

    bool is_turned() const { return turned_from >= 0; }
    /// By an exchange of axes alone.
    bool is_exchanged() const { return is_turned() && !turn.reverses(); }
};

/// Whether best_placement() may answer with this candidate of orientation `index` of the shape (section 4.3). Asked
/// from several threads, and only of what would be the best so far. While objects are only added to the tray, a
/// candidate that was turned down once stays so: engines may take it for colliding from then on.
using Admits = std::function<bool(int index, const VoxelIndex& position)>;

struct Shape {
    std::uint64_t id = 0;  ///< distinct for distinct shapes: engines key their caches by it
    int gap_class = 0;     ///< index into the tray's gap classes of the part's own gap
    /// By ascending orientation index, equal voxels merged.
    std::vector<OrientedShape> orientations;
    /// How many copies are likely to be asked about in the same tray, 0 if that is not known. It tells engines what is
    /// worth remembering.
    int copies = 0;
    Admits admits{};  ///< null: every candidate
    /// Boxes of voxels of dx. Where there are any, the asker knows of all candidates whose boxes, A+g included, meet
    /// none of these that they collide or would be turned down: engines need not look there.
    std::vector<VoxelBox> only_near{};

    bool is_once() const { return copies == 1; }
};

/// Voxelises `mesh` (mm, scaled, not turned) in every rotation at voxel_size / detail, widens it for
/// every gap class, and merges orientations with equal voxels (and equal reach to 1e-6 mm) into the
/// least index. `room`: as voxelize_orientations() has it; against gaps that are longer than its diagonal
/// (holds_one_only()) the voxels are not widened.
/// `gap_classes`: the job's distinct gaps, ascending; `gap` is one of them.
Shape make_shape(std::uint64_t id, const Mesh& mesh, const std::vector<Mat3>& rotations, double voxel_size, int detail,
                 double gap, const std::vector<double>& gap_classes, const Workers& workers,
                 const Vec3& room = kAnyRoom);

}  // namespace spectralpack
