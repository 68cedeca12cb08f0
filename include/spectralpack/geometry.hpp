#pragma once
/// Points, linear maps, transforms and boxes: plain values, double precision. Millimetres, or a mesh file's own unit
/// where that is said. Axes are right-handed with z up; vectors are columns (p' = M p).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace spectralpack {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator==(const Vec3&) const = default;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3 operator*(const Vec3& a, double s) { return s * a; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline Vec3 min(const Vec3& a, const Vec3& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
inline Vec3 max(const Vec3& a, const Vec3& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// A linear map by its rows; by default the identity.
struct Mat3 {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

    bool operator==(const Mat3&) const = default;
};

inline Vec3 operator*(const Mat3& m, const Vec3& v) {
    return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)};
}

inline Mat3 transposed(const Mat3& m) {
    return {{Vec3{m.rows[0].x, m.rows[1].x, m.rows[2].x}, Vec3{m.rows[0].y, m.rows[1].y, m.rows[2].y},
             Vec3{m.rows[0].z, m.rows[1].z, m.rows[2].z}}};
}

inline Mat3 operator*(const Mat3& a, const Mat3& b) {
    const Mat3 t = transposed(b);
    Mat3 product;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            product.rows[row][column] = dot(a.rows[row], t.rows[column]);
        }
    }
    return product;
}

inline Mat3 operator*(double s, const Mat3& m) { return {{s * m.rows[0], s * m.rows[1], s * m.rows[2]}}; }

inline double determinant(const Mat3& m) { return dot(m.rows[0], cross(m.rows[1], m.rows[2])); }

/// p' = linear p + translation. A copy's transform holds its scale; a negative determinant is a mirror.
struct Transform {
    Mat3 linear;
    Vec3 translation;

    bool operator==(const Transform&) const = default;
};

inline Vec3 operator*(const Transform& t, const Vec3& p) { return t.linear * p + t.translation; }

/// First b, then a.
inline Transform operator*(const Transform& a, const Transform& b) { return {a.linear * b.linear, a * b.translation}; }

/// An axis-aligned box. A default one is empty: it contains nothing and grows from its first point.
struct Box {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Vec3 min{kInfinity, kInfinity, kInfinity};
    Vec3 max{-kInfinity, -kInfinity, -kInfinity};

    bool empty() const { return min.x > max.x; }
    Vec3 size() const { return empty() ? Vec3{} : max - min; }
    double volume() const {
        const Vec3 s = size();
        return s.x * s.y * s.z;
    }
    void add(const Vec3& point) {
        min = spectralpack::min(min, point);
        max = spectralpack::max(max, point);
    }
    void add(const Box& other) {
        min = spectralpack::min(min, other.min);
        max = spectralpack::max(max, other.max);
    }
    bool operator==(const Box&) const = default;
};

/// Millimetres by which a mesh's box may stick out of the container.
inline constexpr double kContainTolerance = 1e-6;

/// A box of that size has room in one of this size, mm.
inline bool fits(const Vec3& size, const Vec3& room) {
    return size.x <= room.x + kContainTolerance && size.y <= room.y + kContainTolerance &&
           size.z <= room.z + kContainTolerance;
}

/// The boxes share a point: touching counts.
inline bool meet(const Box& a, const Box& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.max[axis] < b.min[axis] || b.max[axis] < a.min[axis]) return false;
    }
    return true;
}

/// Square of the Euclidean distance between two boxes, 0 where they meet.
inline double square_distance(const Box& a, const Box& b) {
    const Vec3 gap = max(Vec3{}, max(a.min - b.max, b.min - a.max));
    return dot(gap, gap);
}

inline double distance(const Box& a, const Box& b) { return std::sqrt(square_distance(a, b)); }

}  // namespace spectralpack
