#pragma once
/// What the judge is compared with: slow and plain, in long double, sharing nothing with it.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "spectralpack/mesh.hpp"

namespace spectralpack::test {

using Real = long double;

struct Point {
    Real x = 0, y = 0, z = 0;
    Point() = default;
    Point(Real px, Real py, Real pz) : x(px), y(py), z(pz) {}
    Point(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator*(Real s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Point& a) { return std::sqrt(dot(a, a)); }

using PointTriangle = std::array<Point, 3>;

inline PointTriangle triangle_of(const Mesh& mesh, std::size_t i) {
    const Triangle& t = mesh.triangles[i];
    return {Point(mesh.vertices[t[0]]), Point(mesh.vertices[t[1]]), Point(mesh.vertices[t[2]])};
}

inline Real reference_distance(const Point& p, const Point& a, const Point& b) {
    const Point d = b - a;
    const Real dd = dot(d, d);
    const Real t = dd > 0 ? std::clamp<Real>(dot(p - a, d) / dd, 0, 1) : 0;
    return length(p - (a + t * d));
}

inline Real reference_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
    Real best = std::min({reference_distance(a, c, d), reference_distance(b, c, d), reference_distance(c, a, b),
                          reference_distance(d, a, b)});
    const Point u = b - a, v = d - c, w = a - c;
    const Real uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    const Real determinant = uu * vv - uv * uv;
    if (determinant > 0) {
        const Real s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) best = std::min(best, length(w + s * u - t * v));
    }
    return best;
}

inline Real reference_distance(const Point& p, const PointTriangle& t) {
    Real best = std::min(
        {reference_distance(p, t[0], t[1]), reference_distance(p, t[1], t[2]), reference_distance(p, t[2], t[0])});
    const Point n = cross(t[1] - t[0], t[2] - t[0]);
    if (dot(n, n) > 0) {
        bool above = true;
        for (int i = 0; i < 3; ++i) {
            above = above && dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), n) >= 0;
        }
        if (above) best = std::min(best, std::abs(dot(p - t[0], n)) / length(n));
    }
    return best;
}

inline bool reference_pierces(const Point& a, const Point& b, const PointTriangle& t) {
    const Point n = cross(t[1] - t[0], t[2] - t[0]);
    const Real at_a = dot(a - t[0], n), at_b = dot(b - t[0], n);
    if (at_a == at_b || at_a * at_b > 0) return false;
    const Point p = a + at_a / (at_a - at_b) * (b - a);
    for (int i = 0; i < 3; ++i) {
        if (dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), n) < 0) return false;
    }
    return true;
}

inline Real reference_distance(const PointTriangle& a, const PointTriangle& b) {
    Real best = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (reference_pierces(a[i], a[(i + 1) % 3], b) || reference_pierces(b[i], b[(i + 1) % 3], a)) {
            return 0;
        }
        best = std::min({best, reference_distance(a[i], b), reference_distance(b[i], a)});
        for (int j = 0; j < 3; ++j) {
            best = std::min(best, reference_distance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
        }
    }
    return best;
}

/// Least distance of two surfaces: every triangle with every triangle.
inline double reference_distance(const Mesh& a, const Mesh& b) {
    Real best = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < a.triangles.size(); ++i) {
        for (std::size_t j = 0; j < b.triangles.size(); ++j) {
            best = std::min(best, reference_distance(triangle_of(a, i), triangle_of(b, j)));
        }
    }
    return static_cast<double>(best);
}

inline double reference_surface_distance(const Mesh& mesh, const Vec3& p) {
    Real best = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        best = std::min(best, reference_distance(Point(p), triangle_of(mesh, i)));
    }
    return static_cast<double>(best);
}

/// Winding number by solid angles.
inline int reference_winding(const Mesh& mesh, const Vec3& point) {
    Real sum = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const PointTriangle t = triangle_of(mesh, i);
        const Point p(point), a = t[0] - p, b = t[1] - p, c = t[2] - p;
        const Real la = length(a), lb = length(b), lc = length(c);
        sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(sum / (2 * std::numbers::pi_v<Real>)));
}

/// How far two convex meshes have to be moved to come apart (negative: a lower bound of how far apart they are), by
/// all separating axes.
inline double convex_penetration(const Mesh& a, const Mesh& b) {
    Real least = std::numeric_limits<Real>::infinity();
    const auto try_axis = [&](const Point& axis) {
        const Real size = length(axis);
        if (size < 1e-9) return;
        Real low_a = std::numeric_limits<Real>::infinity(), high_a = -low_a, low_b = low_a, high_b = -low_a;
        for (const Vec3& v : a.vertices) {
            low_a = std::min(low_a, dot(axis, v) / size);
            high_a = std::max(high_a, dot(axis, v) / size);
        }
        for (const Vec3& v : b.vertices) {
            low_b = std::min(low_b, dot(axis, v) / size);
            high_b = std::max(high_b, dot(axis, v) / size);
        }
        least = std::min({least, high_a - low_b, high_b - low_a});
    };
    for (const Mesh* mesh : {&a, &b}) {
        for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
            const PointTriangle t = triangle_of(*mesh, i);
            try_axis(cross(t[1] - t[0], t[2] - t[0]));
        }
    }
    for (std::size_t i = 0; i < a.triangles.size(); ++i) {
        const PointTriangle s = triangle_of(a, i);
        for (std::size_t j = 0; j < b.triangles.size(); ++j) {
            const PointTriangle t = triangle_of(b, j);
            for (int k = 0; k < 9; ++k) {
                try_axis(cross(s[(k % 3 + 1) % 3] - s[k % 3], t[(k / 3 + 1) % 3] - t[k / 3]));
            }
        }
    }
    return static_cast<double>(least);
}

}  // namespace spectralpack::test
