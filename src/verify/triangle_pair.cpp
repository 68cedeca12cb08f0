#include "verify/triangle_pair.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {
namespace {

double squared(const Vec3& v) { return dot(v, v); }

/// Squared distance from p to the segment a + t d, 0 <= t <= 1.
double point_segment(const Vec3& p, const Vec3& a, const Vec3& d) {
    const double dd = squared(d);
    const double t = dd > 0 ? std::clamp(dot(p - a, d) / dd, 0.0, 1.0) : 0.0;
    return squared(p - (a + t * d));
}

/// Squared distance of the inner points of two segments a + s u and b + t v where both nearest points are inner
/// ones; else infinity: an end point is nearest then. Ill-conditioned where the segments are almost
/// parallel, but always the distance of two points on them, and then an end point is as near.
double inner_segments(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
    const Vec3 w = a - b;
    const double uu = squared(u), uv = dot(u, v), vv = squared(v), uw = dot(u, w), vw = dot(v, w);
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) return Box::kInfinity;
    const double s = (uv * vw - vv * uw) / determinant;
    if (s < 0 || s > 1) return Box::kInfinity;
    const double t = std::clamp((vw + s * uv) / vv, 0.0, 1.0);
    return squared(w + s * u - t * v);
}

/// A triangle with what all tests need.
struct Face {
    explicit Face(const Corners& c) : corner(c), edge{c[1] - c[0], c[2] - c[1], c[0] - c[2]} {
        const Vec3 across = cross(edge[0], edge[1]);
        const double longest = std::max({squared(edge[0]), squared(edge[1]), squared(edge[2])});
        if (squared(across) > kNeedle * kNeedle * longest) normal = across;
    }

    /// On the inner side of all three edge planes.
    bool above(const Vec3& p) const {
        for (int i = 0; i < 3; ++i) {
            if (dot(cross(normal, edge[i]), p - corner[i]) < 0) return false;
        }
        return true;
    }

    Corners corner;
    std::array<Vec3, 3> edge;
    Vec3 normal;  ///< of length 2 area; 0 for a needle
};

/// Squared distance from p to the inside of the face; infinity where an edge is nearest.
double point_inside(const Vec3& p, const Face& face) {
    const double nn = squared(face.normal);
    if (!(nn > 0) || !face.above(p)) return Box::kInfinity;
    const double height = dot(p - face.corner[0], face.normal);
    return height * height / nn;
}

/// Heights of b's corners over a's plane, in units of |a.normal|.
std::array<double, 3> heights(const Face& a, const Face& b) {
    return {dot(b.corner[0] - a.corner[0], a.normal), dot(b.corner[1] - a.corner[0], a.normal),
            dot(b.corner[2] - a.corner[0], a.normal)};
}

/// True if b is wholly farther than `cutoff` from a's plane; with room for the rounding of a needle's normal.
bool beyond(const std::array<double, 3>& height, const Face& a, double cutoff) {
    const double low = std::min({height[0], height[1], height[2]});
    const double high = std::max({height[0], height[1], height[2]});
    const double gap = std::max(low, -high);
    const double reach = cutoff + 1e-4;
    return gap > 0 && gap * gap > reach * reach * squared(a.normal);
}

/// An edge of b goes through the face of a.
bool pierces(const std::array<double, 3>& height, const Face& a, const Face& b) {
    for (int i = 0; i < 3; ++i) {
        const double from = height[i], to = height[(i + 1) % 3];
        if ((from < 0) == (to < 0) || from == to) continue;
        if (a.above(b.corner[i] + from / (from - to) * b.edge[i])) return true;
    }
    return false;
}

}  // namespace

double least_height(const Corners& triangle) {
    const Vec3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[1], c = triangle[0] - triangle[2];
    const double longest = std::sqrt(std::max({squared(a), squared(b), squared(c)}));
    return longest > 0 ? length(cross(a, b)) / longest : 0;
}

double point_triangle_distance(const Vec3& point, const Corners& triangle) {
    const Face face(triangle);
    double best = point_inside(point, face);
    for (int i = 0; i < 3; ++i) {
        best = std::min(best, point_segment(point, triangle[i], face.edge[i]));
    }
    return std::sqrt(best);
}

double triangle_distance(const Corners& corners_a, const Corners& corners_b, double cutoff) {
    const Face a(corners_a), b(corners_b);
    const auto over_a = heights(a, b);
    if (beyond(over_a, a, cutoff)) return Box::kInfinity;
    const auto over_b = heights(b, a);
    if (beyond(over_b, b, cutoff)) return Box::kInfinity;
    if (pierces(over_a, a, b) || pierces(over_b, b, a)) return 0;
    double best = Box::kInfinity;
    for (int i = 0; i < 3; ++i) {
        best = std::min({best, point_inside(a.corner[i], b), point_inside(b.corner[i], a)});
        for (int j = 0; j < 3; ++j) {
            best = std::min({best, point_segment(a.corner[i], b.corner[j], b.edge[j]),
                             point_segment(b.corner[j], a.corner[i], a.edge[i]),
                             inner_segments(a.corner[i], a.edge[i], b.corner[j], b.edge[j])});
        }
    }
    return std::sqrt(best);
}

double crossing_depth(const Corners& corners_a, const Corners& corners_b) {
    const Face a(corners_a), b(corners_b);
    double depth = Box::kInfinity;
    // Along an axis the triangles cover two intervals; the way out is the shorter of the two.
    const auto try_axis = [&](const Vec3& axis) {
        double low_a = Box::kInfinity, high_a = -Box::kInfinity, low_b = Box::kInfinity, high_b = -Box::kInfinity;
        for (int i = 0; i < 3; ++i) {
            const double on_a = dot(axis, a.corner[i] - a.corner[0]);
            const double on_b = dot(axis, b.corner[i] - a.corner[0]);
            low_a = std::min(low_a, on_a);
            high_a = std::max(high_a, on_a);
            low_b = std::min(low_b, on_b);
            high_b = std::max(high_b, on_b);
        }
        depth = std::min(depth, std::min(high_a - low_b, high_b - low_a) / length(axis));
        return depth > 0;
    };
    // The Minkowski difference of two triangles has these facets: face and corner, and edge and edge.
    for (const Face* face : {&a, &b}) {
        if (squared(face->normal) > 0 && !try_axis(face->normal)) return 0;
    }
    for (const Vec3& edge_a : a.edge) {
        for (const Vec3& edge_b : b.edge) {
            const Vec3 axis = cross(edge_a, edge_b);
            const bool parallel = squared(axis) <= 1e-14 * squared(edge_a) * squared(edge_b);
            if (!parallel && !try_axis(axis)) return 0;
        }
    }
    return depth < Box::kInfinity ? depth : 0;
}

}  // namespace spectralpack
