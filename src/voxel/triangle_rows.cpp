#include "voxel/triangle_rows.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {
namespace {

int round_down(double value) {
    const int whole = static_cast<int>(value);
    return whole - (whole > value ? 1 : 0);
}

/// 1 / a; where a is nothing, so much that the bound is either passed by far or missed by far.
double inverse(double a) { return std::abs(a) < 1e-200 ? 1e200 : 1 / a; }

}  // namespace

VoxelRange voxels_in_box(const GridTriangle& triangle, const VoxelShape& shape, const VoxelRange& bounds) {
    const Vec3 least = min(min(triangle[0], triangle[1]), triangle[2]);
    const Vec3 most = max(max(triangle[0], triangle[1]), triangle[2]);
    const double inset = shape.shrink - shape.reach;
    VoxelRange range;
    for (int axis = 0; axis < 3; ++axis) {
        // Voxel i's open interval is (i + inset, i + 1 - inset).
        range.low[axis] = std::max(bounds.low[axis], round_down(least[axis] + inset));
        range.high[axis] = std::min(bounds.high[axis], -round_down(-(most[axis] - inset)) - 1);
    }
    return range;
}

TriangleRows::TriangleRows(const GridTriangle& triangle, const VoxelShape& shape, const VoxelRange& range)
    : range_(range) {
    // Counted from the centre of the range's first voxel: the numbers stay small, and voxel i's
    // centre is i.
    const Vec3 origin{range.low.x + 0.5, range.low.y + 0.5, range.low.z + 0.5};
    const GridTriangle v{triangle[0] - origin, triangle[1] - origin, triangle[2] - origin};
    const std::array<Vec3, 3> edges{v[1] - v[0], v[2] - v[1], v[0] - v[2]};

    double longest = 0, farthest = 1;
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            longest = std::max(longest, std::abs(edges[i][axis]));
            farthest = std::max(farthest, std::abs(v[i][axis]));
        }
    }
    // Several times the rounding error of the products below; never 0, so that 0 <= 0 holds for
    // points.
    const double error = 1e-15 * longest * farthest + 1e-30;

    // |a x + b y + c z - middle| <= half, with the box's and the ball's extent along the axis in
    // half.
    const double box = 0.5 - shape.shrink;
    const auto extent = [&](double a, double b, double c) {
        const double cube = box * (std::abs(a) + std::abs(b) + std::abs(c));
        return shape.reach == 0 ? cube : cube + shape.reach * std::sqrt(a * a + b * b + c * c);
    };

    const Vec3 normal = cross(edges[0], edges[1]);
    const double per_x = inverse(normal.x);
    offset_ = dot(normal, v[0]) * per_x;
    per_y_ = -normal.y * per_x;
    per_z_ = -normal.z * per_x;
    half_ = (extent(normal.x, normal.y, normal.z) + 8 * longest * error + 1e-60) * std::abs(per_x);

    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& e = edges[i];
        const Vec3& a = v[i];
        const Vec3& c = v[i == 0 ? 2 : i - 1];  // the corner that is not on the edge
        const double inverse_y = inverse(e.y), inverse_z = inverse(e.z);
        // The product of the edge with z is e.y x - e.x y: two projections, of the edge and of the
        // other corner.
        const auto bound = [&](double first, double second, double across, double along, double by) {
            const double half = std::abs(first - second) / 2 + extent(across, along, 0) + 4 * error;
            return Bound{(first + second) / 2 * by, along * by, half * std::abs(by)};
        };
        xy_[i] = bound(e.y * a.x - e.x * a.y, e.y * c.x - e.x * c.y, e.y, e.x, inverse_y);
        xz_[i] = bound(e.z * a.x - e.x * a.z, e.z * c.x - e.x * c.z, e.z, e.x, inverse_z);
        yz_[i] = bound(e.z * a.y - e.y * a.z, e.z * c.y - e.y * c.z, e.z, e.y, inverse_z);
    }
}

}  // namespace spectralpack
