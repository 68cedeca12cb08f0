#pragma once
/// Which voxels a triangle meets, row by row: the separating-axis test of a triangle and a box
/// (Akenine-Moller 2001) with the tests arranged so that a row's voxels come out as one interval
/// (after Schwarz and Seidel 2010).

#include <algorithm>
#include <array>
#include <cstdint>

#include "spectralpack/geometry.hpp"
#include "spectralpack/grid.hpp"

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
VoxelRange voxels_in_box(const GridTriangle& triangle, const VoxelShape& shape, const VoxelRange& bounds);

/// The separating-axis test of one triangle against the voxels of a range. The axes are the
/// triangle's normal and the nine products of its edges with the coordinate axes; the coordinate
/// axes themselves are in the range, which must come from voxels_in_box(). With reach > 0 passing
/// the test is necessary for being met, not sufficient (the ball's corners are not cut off); with
/// reach 0 it is both.
///
/// Each axis bounds the voxel centre from two sides by all three corners, so nothing hangs on the
/// sign of a small area: needles and zero-area triangles come out as the segments and points they
/// are. Bounds are widened by their rounding error: about 1e-14 of the triangle's size, but for the
/// planes of needles, which bound nothing.
class TriangleRows {
  public:
    TriangleRows(const GridTriangle& triangle, const VoxelShape& shape, const VoxelRange& range);

    /// Calls visit(first x, last x, y, z) for every row of the range that has voxels that pass.
    template <class Visit>
    void for_each(Visit visit) const {
        const int rows = range_.high.y - range_.low.y + 1;
        const int layers = range_.high.z - range_.low.z + 1;
        const Interval whole{0.0, static_cast<double>(range_.high.x - range_.low.x)};
        for (int begin = 0; begin < rows; begin += kBlock) {
            const int end = std::min(rows, begin + kBlock);
            std::array<Interval, kBlock> by_y;
            for (int j = begin; j < end; ++j) {
                by_y[static_cast<std::size_t>(j - begin)] = meet(xy_, j, whole);
            }
            for (int k = 0; k < layers; ++k) {
                const Interval y = meet(yz_, k, {static_cast<double>(begin), end - 1.0});
                if (y.empty()) continue;
                const Interval by_z = meet(xz_, k, whole);
                for (int j = round_up(y.low); j <= static_cast<int>(y.high); ++j) {
                    const double centre = offset_ + per_z_ * k + per_y_ * j;
                    Interval x = by_y[static_cast<std::size_t>(j - begin)];
                    x.cut(by_z.low, by_z.high);
                    x.cut(centre - half_, centre + half_);
                    if (x.empty()) continue;
                    const int first = round_up(x.low), last = static_cast<int>(x.high);
                    if (first > last) continue;
                    visit(range_.low.x + first, range_.low.x + last, range_.low.y + j, range_.low.z + k);
                }
            }
        }
    }

  private:
    static constexpr int kBlock = 64;  ///< rows whose bounds are kept at a time

    struct Interval {
        double low, high;

        bool empty() const { return !(low <= high); }
        void cut(double other_low, double other_high) {
            low = std::max(low, other_low);
            high = std::min(high, other_high);
        }
    };

    /// Bounds one coordinate of the voxel centre by another: offset + slope * other +- half.
    /// Coordinates are counted from the centre of the range's first voxel.
    struct Bound {
        double offset, slope, half;
    };

    static Interval meet(const std::array<Bound, 3>& bounds, int at, Interval interval) {
        for (const Bound& bound : bounds) {
            const double centre = bound.offset + bound.slope * at;
            interval.cut(centre - bound.half, centre + bound.half);
        }
        return interval;
    }

    /// Of a value that is not negative.
    static int round_up(double value) {
        const int whole = static_cast<int>(value);
        return whole + (whole < value ? 1 : 0);
    }

    VoxelRange range_;
    std::array<Bound, 3> xy_, xz_, yz_;     ///< x by y, x by z, y by z; one for each edge
    double offset_, per_y_, per_z_, half_;  ///< x by y and z: the triangle's plane
};

}  // namespace spectralpack
