#pragma once
/// Linear maps and affine transforms: column vectors, p' = linear p + translation. As in the packing file the
/// matrix holds a part's scale; a negative determinant is a mirror.

#include <array>

#include "geometry/vec3.hpp"

namespace spectralpack {

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

struct Transform {
    Mat3 linear;
    Vec3 translation;

    bool operator==(const Transform&) const = default;
};

inline Vec3 operator*(const Transform& t, const Vec3& p) { return t.linear * p + t.translation; }

/// First b, then a.
inline Transform operator*(const Transform& a, const Transform& b) { return {a.linear * b.linear, a * b.translation}; }

}  // namespace spectralpack
