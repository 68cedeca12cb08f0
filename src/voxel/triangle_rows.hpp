#pragma once
/// Which voxels a triangle meets, row by row: the separating-axis test of a triangle and a box
/// (Akenine-Moller 2001) with the tests arranged so that a row's voxels come out as one interval
/// (after Schwarz and Seidel 2010).

#include <array>

#include "geometry/vec3.hpp"
#include "voxel/grid.hpp"

namespace spectralpack {

using GridTriangle = std::array<Vec3, 3>;  ///< corners, in voxel sizes from the grid's lower corner

/// What a voxel is taken to be: its cube, drawn in by `shrink` on every side, then rounded out by a
/// ball of radius `reach` (both in voxel sizes; one of them is 0).
struct VoxelShape {
    double shrink = 0;
    double reach = 0;
};

/// Voxels low..high, both ends included; empty where high < low on some axis.
struct VoxelRange {
    VoxelIndex low, high;

    bool empty() const { return high.x < low.x || high.y < low.y || high.z < low.z; }
    std::int64_t count() const {
        return std::int64_t{high.x - low.x + 1} * (high.y - low.y + 1) * (high.z - low.z + 1);
    }
};

/// Voxels whose shape's box meets the triangle's box in more than a face, cut to `bounds`.
VoxelRange voxels_in_box(const GridTriangle& triangle, const VoxelShape& shape,
                         const VoxelRange& bounds);

/// The separating-axis test of one triangle against the voxels of a range. The axes are the
/// triangle's normal and the nine products of its edges with the coordinate axes; the coordinate
/// axes themselves are in the range, which must come from voxels_in_box(). With reach > 0 passing
/// the test is necessary for being met, not sufficient (the ball's corners are not cut off); with
/// reach 0 it is both.
///
/// Each axis bounds the voxel centre from two sides by all three corners, so nothing hangs on the
/// sign of a small area: needles and zero-area triangles come out as the segments and points they
/// are. Bounds are widened by their rounding error, which is below 1e-12 voxel sizes for all but
/// needles.
class TriangleRows {
  public:
    TriangleRows(const GridTriangle& triangle, const VoxelShape& shape, const VoxelRange& range);

    /// Calls visit(first x, last x, y, z) for every row of the range that has voxels that pass.
    template <class Visit>
    void for_each(Visit visit) const {
        for (int k = 0; k <= range_.high.z - range_.low.z; ++k) {
            double low = 0, high = range_.high.y - range_.low.y;
            for (int axis = 0; axis < 3; ++axis) {
                const double centre = in_layer_[axis].offset + in_layer_[axis].per_z * k;
                low = std::max(low, centre - in_layer_[axis].half);
                high = std::min(high, centre + in_layer_[axis].half);
            }
            if (!(low <= high)) continue;
            std::array<double, kRowAxes> layer;
            for (int axis = 0; axis < kRowAxes; ++axis) {
                layer[axis] = offset_[axis] + per_z_[axis] * k;
            }
            for (int j = round_up(low); j <= static_cast<int>(high); ++j) {
                visit_row(layer, j, k, visit);
            }
        }
    }

  private:
    static constexpr int kRowAxes =
        7;  ///< that bound x: the normal, three in the xy plane, three in the xz plane

    /// An axis of the yz plane: bounds y for a given z.
    struct LayerAxis {
        double offset, per_z, half;
    };

    /// Of a value that is not negative.
    static int round_up(double value) {
        const int whole = static_cast<int>(value);
        return whole + (whole < value ? 1 : 0);
    }

    template <class Visit>
    void visit_row(const std::array<double, kRowAxes>& layer, int j, int k, Visit& visit) const {
        double low = 0, high = range_.high.x - range_.low.x;
        for (int axis = 0; axis < kRowAxes; ++axis) {
            const double centre = layer[axis] + per_y_[axis] * j;
            low = std::max(low, centre - half_[axis]);
            high = std::min(high, centre + half_[axis]);
        }
        if (!(low <= high)) return;
        const int first = round_up(low), last = static_cast<int>(high);
        if (first <= last) {
            visit(range_.low.x + first, range_.low.x + last, range_.low.y + j, range_.low.z + k);
        }
    }

    VoxelRange range_;
    std::array<LayerAxis, 3> in_layer_;
    /// x in offset + per_y * y + per_z * z +- half, for voxel centres counted from range_.low.
    std::array<double, kRowAxes> offset_, per_y_, per_z_, half_;
};

}  // namespace spectralpack
