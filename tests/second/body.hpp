#pragma once
/// A closed mesh where it stands, for the second check: a tree of boxes over its triangles.

#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <map>
#include <numeric>

#include "triangles.hpp"

namespace second {

class Body {
  public:
    explicit Body(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
        std::erase_if(triangles_, [](const Triangle& t) { return t.is_degenerate(); });
        find_shells();
        if (!triangles_.empty()) build(0, triangles_.size());
    }

    const std::vector<Triangle>& triangles() const { return triangles_; }
    Box box() const { return nodes_.empty() ? Box{} : nodes_[0].box; }
    /// One corner of each connected part of the surface.
    const std::vector<Point>& shells() const { return shells_; }

    double volume() const {
        double six_times = 0;
        for (const Triangle& t : triangles_) {
            six_times += CGAL::scalar_product(t[0] - CGAL::ORIGIN,
                                              CGAL::cross_product(t[1] - CGAL::ORIGIN, t[2] - CGAL::ORIGIN));
        }
        return six_times / 6;
    }

    /// Calls pair(mine, its) for the triangles of pairs of leaves whose boxes, mine swept along `way`, are nearer than
    /// reach(), until it returns true. Returns whether it did.
    template <class Reach, class Pair>
    bool any_pair(const Body& other, const Vector& way, const Reach& reach, const Pair& pair) const {
        return !nodes_.empty() && !other.nodes_.empty() && visit(other, 0, 0, way, reach, pair);
    }

    /// How often the surface winds about a point that is not on it.
    int winding(const Point& p) const {
        static const Vector direction(0.57735, 0.211324865, 0.78867513);  // parallel to nothing in particular
        int count = 0;
        if (!nodes_.empty()) count_crossings(0, Kernel::Ray_3(p, direction), direction, count);
        return count;
    }

  private:
    struct Node {
        Box box;
        std::size_t first, last;      // of the triangles
        std::size_t left = 0, right;  // left 0: a leaf
    };

    std::size_t build(std::size_t first, std::size_t last) {
        const std::size_t at = nodes_.size();
        nodes_.push_back({{}, first, last, 0, 0});
        Box box;
        for (std::size_t i = first; i < last; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                box.add(triangles_[i][corner]);
            }
        }
        nodes_[at].box = box;
        if (last - first <= 4) return at;
        int axis = 0;
        for (int other = 1; other < 3; ++other) {
            if (box.max[other] - box.min[other] > box.max[axis] - box.min[axis]) axis = other;
        }
        const std::size_t middle = (first + last) / 2;
        const auto centre = [axis](const Triangle& t) { return t[0][axis] + t[1][axis] + t[2][axis]; };
        std::nth_element(triangles_.begin() + static_cast<std::ptrdiff_t>(first),
                         triangles_.begin() + static_cast<std::ptrdiff_t>(middle),
                         triangles_.begin() + static_cast<std::ptrdiff_t>(last),
                         [&](const Triangle& a, const Triangle& b) { return centre(a) < centre(b); });
        const std::size_t left = build(first, middle);
        const std::size_t right = build(middle, last);
        nodes_[at].left = left;
        nodes_[at].right = right;
        return at;
    }

    void find_shells() {
        std::map<Point, std::size_t> index;
        std::vector<std::size_t> parent;
        const auto root = [&](std::size_t i) {
            while (parent[i] != i) {
                i = parent[i] = parent[parent[i]];
            }
            return i;
        };
        for (const Triangle& t : triangles_) {
            std::size_t of_first = 0;
            for (int corner = 0; corner < 3; ++corner) {
                const auto [entry, is_new] = index.try_emplace(t[corner], parent.size());
                if (is_new) parent.push_back(entry->second);
                if (corner == 0) of_first = entry->second;
                parent[root(entry->second)] = root(of_first);
            }
        }
        for (const auto& [point, i] : index) {
            if (root(i) == i) shells_.push_back(point);
        }
    }

    template <class Reach, class Pair>
    bool visit(const Body& other, std::size_t mine, std::size_t its, const Vector& way, const Reach& reach,
               const Pair& pair) const {
        const Node &a = nodes_[mine], &b = other.nodes_[its];
        Box swept = a.box;
        swept.add(a.box.moved(way));
        const double limit = reach();
        if (swept.squared_distance(b.box) > limit * limit) return false;
        if (a.left == 0 && b.left == 0) {
            for (std::size_t i = a.first; i < a.last; ++i) {
                for (std::size_t k = b.first; k < b.last; ++k) {
                    if (pair(triangles_[i], other.triangles_[k])) return true;
                }
            }
            return false;
        }
        if (b.left == 0 || (a.left != 0 && a.last - a.first >= b.last - b.first)) {
            return visit(other, a.left, its, way, reach, pair) || visit(other, a.right, its, way, reach, pair);
        }
        return visit(other, mine, b.left, way, reach, pair) || visit(other, mine, b.right, way, reach, pair);
    }

    void count_crossings(std::size_t at, const Kernel::Ray_3& ray, const Vector& direction, int& count) const {
        const Node& node = nodes_[at];
        const Kernel::Iso_cuboid_3 cuboid(node.box.min[0], node.box.min[1], node.box.min[2], node.box.max[0],
                                          node.box.max[1], node.box.max[2]);
        if (!CGAL::do_intersect(ray, cuboid.bbox())) return;
        if (node.left != 0) {
            count_crossings(node.left, ray, direction, count);
            count_crossings(node.right, ray, direction, count);
            return;
        }
        for (std::size_t i = node.first; i < node.last; ++i) {
            const Triangle& t = triangles_[i];
            if (!CGAL::do_intersect(ray, t)) continue;
            count += CGAL::cross_product(t[1] - t[0], t[2] - t[0]) * direction > 0 ? 1 : -1;
        }
    }

    std::vector<Triangle> triangles_;
    std::vector<Point> shells_;
    std::vector<Node> nodes_;
};

/// The least distance of two surfaces, or `bound` where that is less; 0: they meet.
inline double distance(const Body& a, const Body& b, double bound) {
    double least = bound;
    a.any_pair(
        b, Vector(0, 0, 0), [&] { return least; },
        [&](const Triangle& mine, const Triangle& its) {
            if (CGAL::do_intersect(mine, its)) {
                least = 0;
            } else {
                least = std::min(least, std::sqrt(CGAL::squared_distance(mine, its)));
            }
            return least == 0;
        });
    return least;
}

/// Whether surfaces cross deeper than `tolerance`, at rest or as `a` moves along `way`.
inline bool cross(const Body& a, const Body& b, const Vector& way, double tolerance) {
    const bool moves = way.squared_length() > 0;
    return a.any_pair(
        b, way, [] { return 0.; },
        [&](const Triangle& mine, const Triangle& its) {
            if (!moves && !CGAL::do_intersect(mine, its)) return false;
            std::vector<Point> hull{mine[0], mine[1], mine[2]};
            if (moves) hull.insert(hull.end(), {mine[0] + way, mine[1] + way, mine[2] + way});
            return held_together(hull, way, its, tolerance);
        });
}

/// A point a little below a face, where the solid is.
inline Point below(const Triangle& t, double depth) {
    const Vector normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    return CGAL::centroid(t) - normal / length(normal) * depth;
}

/// Whether `a` has a point inside `b` more than about `tolerance` deep, where their surfaces do not cross.
inline bool lies_in(const Body& a, const Body& b, bool they_touch, double tolerance) {
    if (a.box().apart(b.box()) > -tolerance) return false;
    if (!they_touch) {
        return std::ranges::any_of(a.shells(), [&](const Point& p) { return b.winding(p) != 0; });
    }
    // Faces may lie on faces: look a little below each of them. What is thinner than that is let pass.
    const Box around = b.box();
    return std::ranges::any_of(a.triangles(), [&](const Triangle& t) {
        const Point p = below(t, 2 * tolerance);
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < around.min[axis] || p[axis] > around.max[axis]) return false;
        }
        return a.winding(p) != 0 && b.winding(p) != 0;
    });
}

/// Whether no point of `a` is outside `b`, where their surfaces do not cross.
inline bool lies_wholly_in(const Body& a, const Body& b, double tolerance) {
    return std::ranges::all_of(a.triangles(), [&](const Triangle& t) {
        const Point p = below(t, 2 * tolerance);
        return a.winding(p) == 0 || b.winding(p) != 0;
    });
}

}  // namespace second
