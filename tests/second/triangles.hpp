#pragma once
/// Triangles for the second check: pairs of them at rest (by CGAL), and on the way (by separating axes).

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace second {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangle = Kernel::Triangle_3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double length(const Vector& v) { return std::sqrt(v.squared_length()); }

struct Box {
    std::array<double, 3> min{kInfinity, kInfinity, kInfinity}, max{-kInfinity, -kInfinity, -kInfinity};

    void add(const Point& p) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], p[axis]);
            max[axis] = std::max(max[axis], p[axis]);
        }
    }
    void add(const Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], box.min[axis]);
            max[axis] = std::max(max[axis], box.max[axis]);
        }
    }
    Box moved(const Vector& by) const {
        Box box = *this;
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] += by[axis];
            box.max[axis] += by[axis];
        }
        return box;
    }
    /// How far apart along the axis that separates them best; negative: they overlap by that along every axis.
    double apart(const Box& other) const {
        double most = -kInfinity;
        for (int axis = 0; axis < 3; ++axis) {
            most = std::max({most, min[axis] - other.max[axis], other.min[axis] - max[axis]});
        }
        return most;
    }
    double squared_distance(const Box& other) const {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double gap = std::max({0., min[axis] - other.max[axis], other.min[axis] - max[axis]});
            sum += gap * gap;
        }
        return sum;
    }
};

/// Whether no translation of at most `tolerance` takes apart the hull of `a` (a triangle, which has normals[0], or one
/// and the same one moved along the way) and the triangle `b`.
inline bool held_together(const std::vector<Point>& a, const Vector& way, const Triangle& b, double tolerance) {
    const Vector edges_a[] = {a[1] - a[0], a[2] - a[1], a[0] - a[2], way};
    const Vector edges_b[] = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
    const auto within = [&](const Vector& axis) {
        const double size = length(axis);
        if (size < 1e-9) return true;  // edges in one direction: others separate if anything does
        std::pair<double, double> range_a{kInfinity, -kInfinity}, range_b = range_a;
        const auto widen = [&](std::pair<double, double>& range, const Point& p) {
            const double at = (p - a[0]) * axis / size;
            range = {std::min(range.first, at), std::max(range.second, at)};
        };
        for (const Point& p : a) {
            widen(range_a, p);
        }
        for (int corner = 0; corner < 3; ++corner) {
            widen(range_b, b[corner]);
        }
        return std::min(range_a.second - range_b.first, range_b.second - range_a.first) > tolerance;
    };
    const auto unit = [](const Vector& v) { return length(v) > 0 ? v / length(v) : v; };
    for (const Vector& edge : edges_b) {
        if (!within(CGAL::cross_product(unit(way), unit(edge)))) return false;
    }
    if (!within(CGAL::cross_product(unit(edges_b[0]), unit(edges_b[1])))) return false;
    for (int i = 0; i < 3; ++i) {
        if (!within(CGAL::cross_product(unit(way), unit(edges_a[i])))) return false;
    }
    if (!within(CGAL::cross_product(unit(edges_a[0]), unit(edges_a[1])))) return false;
    for (int i = 0; i < 3; ++i) {
        for (const Vector& edge : edges_b) {
            if (!within(CGAL::cross_product(unit(edges_a[i]), unit(edge)))) return false;
        }
    }
    return true;
}

}  // namespace second
