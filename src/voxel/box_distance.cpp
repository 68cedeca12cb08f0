#include "voxel/box_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace spectralpack {
namespace {

constexpr double kHalf = 0.5;

/// From the cube to a point, per axis.
Vec3 outside_part(const Vec3& p) {
    return {p.x - std::clamp(p.x, -kHalf, kHalf), p.y - std::clamp(p.y, -kHalf, kHalf),
            p.z - std::clamp(p.z, -kHalf, kHalf)};
}

double squared(const Vec3& v) { return dot(v, v); }

/// The square of the distance from the cube to a + t d is convex in t and quadratic between the t
/// at which the segment passes a plane of the cube; its slope tells on which side of each of these
/// the minimum is.
double squared_segment_distance(const Vec3& a, const Vec3& d) {
    double low = 0, high = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] == 0) continue;
        for (const double plane : {-kHalf, kHalf}) {
            const double t = (plane - a[axis]) / d[axis];
            if (!(t > low && t < high)) continue;
            if (dot(outside_part(a + t * d), d) > 0) {
                high = t;
            } else {
                low = t;
            }
        }
    }
    // Between low and high each axis counts all along or not at all.
    const Vec3 middle = outside_part(a + (low + high) / 2 * d);
    double slope = 0, curvature = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (middle[axis] == 0) continue;
        slope += (a[axis] - std::copysign(kHalf, middle[axis])) * d[axis];
        curvature += d[axis] * d[axis];
    }
    const double t = curvature > 0 ? std::clamp(-slope / curvature, low, high) : low;
    return std::min(
        {squared(outside_part(a + t * d)), squared(outside_part(a + low * d)), squared(outside_part(a + high * d))});
}

/// True when the point's foot on the triangle's plane is in the triangle.
bool foot_inside(const GridTriangle& v, const Vec3& normal, const Vec3& p) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& a = v[i];
        const Vec3& b = v[i == 2 ? 0 : i + 1];
        if (dot(cross(b - a, p - a), normal) < 0) return false;
    }
    return true;
}

/// Distance where the triangle's nearest point is none of its border: to the cube's corner nearest
/// to the plane, or 0 where the plane cuts the cube within the triangle.
std::optional<double> squared_inner_distance(const GridTriangle& v) {
    const Vec3 normal = cross(v[1] - v[0], v[2] - v[0]);
    const double square = squared(normal);
    if (square == 0) return std::nullopt;
    // Of the cube's corners, `far` is the one farthest along the normal and -far the least far.
    const Vec3 far{std::copysign(kHalf, normal.x), std::copysign(kHalf, normal.y), std::copysign(kHalf, normal.z)};
    const double plane = dot(normal, v[0]), reach = dot(normal, far);
    const double side = plane > 0 ? 1 : -1;
    if (std::abs(plane) > reach) {
        if (!foot_inside(v, normal, side * far)) return std::nullopt;
        const double gap = std::abs(plane) - reach;
        return gap * gap / square;
    }
    // The border does not meet the cube, or that would be found as a segment's distance 0: then the
    // cube's section is wholly within the triangle or wholly without, and any point of it tells.
    if (!foot_inside(v, normal, (plane / reach) * far)) return std::nullopt;
    return 0.0;
}

}  // namespace

double squared_box_distance(const GridTriangle& triangle) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& a = triangle[i];
        least = std::min(least, squared_segment_distance(a, triangle[i == 2 ? 0 : i + 1] - a));
        if (least == 0) return 0;
    }
    return std::min(least, squared_inner_distance(triangle).value_or(least));
}

NearCubes::NearCubes(const GridTriangle& triangle, double distance)
    : triangle_(triangle),
      distance_(distance),
      ab_(triangle[1] - triangle[0]),
      ac_(triangle[2] - triangle[0]),
      ab_ab_(dot(ab_, ab_)),
      ab_ac_(dot(ab_, ac_)),
      ac_ac_(dot(ac_, ac_)) {}

/// From there to the triangle's nearest point (Ericson, Real-Time Collision Detection, section 5.1.5).
Vec3 NearCubes::nearest_from(const Vec3& point) const {
    const Vec3 p = point - triangle_[0];
    const double d1 = dot(ab_, p), d2 = dot(ac_, p);
    if (d1 <= 0 && d2 <= 0) return Vec3{} - p;
    const double d3 = d1 - ab_ab_, d4 = d2 - ab_ac_;
    if (d3 >= 0 && d4 <= d3) return ab_ - p;
    const double d5 = d1 - ab_ac_, d6 = d2 - ac_ac_;
    if (d6 >= 0 && d5 <= d6) return ac_ - p;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 / (d1 - d3) * ab_ - p;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 / (d2 - d6) * ac_ - p;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        return ab_ + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (ac_ - ab_) - p;
    }
    // Clamped, because of a needle little is left of these areas but rounding.
    const double sum = va + vb + vc;
    if (!(sum > 0)) return Vec3{} - p;
    const double of_b = std::clamp(vb / sum, 0.0, 1.0), of_c = std::clamp(vc / sum, 0.0, 1 - of_b);
    return of_b * ab_ + of_c * ac_ - p;
}

bool NearCubes::contain(const Vec3& centre) const {
    // Any point of the triangle shows that it is near, and any direction in which the two are far enough apart that it
    // is not. The point nearest to the cube's centre is nearly always enough of both; if not, the one nearest to that
    // point of the cube which is nearest to it, and so on.
    constexpr int kPoints = 4;
    const double near = distance_ * distance_;
    const GridTriangle from{triangle_[0] - centre, triangle_[1] - centre, triangle_[2] - centre};
    Vec3 in_cube;  // counted from the centre, as `from` is
    for (int i = 0; i < kPoints; ++i) {
        const Vec3 nearest = in_cube + nearest_from(centre + in_cube);
        const Vec3 between = outside_part(nearest);
        if (squared(between) < near) return true;
        const double ahead = std::min({dot(between, from[0]), dot(between, from[1]), dot(between, from[2])});
        const double cube = kHalf * (std::abs(between.x) + std::abs(between.y) + std::abs(between.z));
        if (ahead - cube >= distance_ * length(between)) return false;
        in_cube = nearest - between;
    }
    return squared_box_distance(from) < near;
}

}  // namespace spectralpack
