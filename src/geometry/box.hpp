#pragma once
/// Axis-aligned boxes. A default box is empty: it contains nothing and grows from its first point.

#include <limits>

#include "geometry/vec3.hpp"

namespace spectralpack {

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

/// Square of the Euclidean distance between two boxes, 0 where they meet.
inline double square_distance(const Box& a, const Box& b) {
    const Vec3 gap = max(Vec3{}, max(a.min - b.max, b.min - a.max));
    return dot(gap, gap);
}

inline double distance(const Box& a, const Box& b) { return std::sqrt(square_distance(a, b)); }

}  // namespace spectralpack
