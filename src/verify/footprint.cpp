#include "verify/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {
namespace {

constexpr double kSliver = 1e-7;  ///< mm

/// Twice the area of the triangle a, b, c; positive if c is left of a -> b.
double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Polygon with_box(std::vector<Point2> corners) {
    Polygon polygon;
    polygon.corners = std::move(corners);
    if (polygon.empty()) return polygon;
    polygon.low = polygon.high = polygon.corners.front();
    for (const Point2& p : polygon.corners) {
        polygon.low = {std::min(polygon.low.x, p.x), std::min(polygon.low.y, p.y)};
        polygon.high = {std::max(polygon.high.x, p.x), std::max(polygon.high.y, p.y)};
    }
    return polygon;
}

bool boxes_meet(const Polygon& a, const Polygon& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Andrew's monotone chain.
Polygon convex_hull(std::vector<Point2> points) {
    std::sort(points.begin(), points.end(),
              [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point2> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Point2& p : points) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return with_box(std::move(hull));
}

/// The part of a convex polygon on the left (`side` 1) or right (-1) of the line a -> b.
Polygon clipped(const Polygon& polygon, const Point2& a, const Point2& b, double side) {
    std::vector<Point2> kept;
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point2& p = polygon.corners[i];
        const Point2& q = polygon.corners[(i + 1) % count];
        const double at_p = side * turn(a, b, p), at_q = side * turn(a, b, q);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p < 0) != (at_q < 0)) {
            const double t = at_p / (at_p - at_q);
            kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return with_box(std::move(kept));
}

/// Too narrow to hold a disc of radius kSliver / 2: area against circumference.
bool is_sliver(const Polygon& polygon) {
    double area = 0, around = 0;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Point2& p = polygon.corners[i];
        const Point2& q = polygon.corners[(i + 1) % polygon.corners.size()];
        area += turn(polygon.corners.front(), p, q) / 2;
        around += std::hypot(q.x - p.x, q.y - p.y);
    }
    return polygon.corners.size() < 3 || 2 * area <= kSliver * around;
}

/// Cuts `hole` out of `piece` and adds what is left to `pieces`.
void subtract(Polygon piece, const Polygon& hole, std::vector<Polygon>& pieces) {
    for (std::size_t i = 0; i < hole.corners.size() && !piece.empty(); ++i) {
        const Point2& a = hole.corners[i];
        const Point2& b = hole.corners[(i + 1) % hole.corners.size()];
        Polygon outer = clipped(piece, a, b, -1);
        if (!is_sliver(outer)) pieces.push_back(std::move(outer));
        piece = clipped(piece, a, b, 1);
        if (is_sliver(piece)) return;
    }
}

/// The segment has a point strictly inside the convex polygon (Cyrus and Beck's clipping).
bool enters(const Point2& from, const Point2& to, const Polygon& polygon) {
    if (std::max(from.x, to.x) <= polygon.low.x || std::min(from.x, to.x) >= polygon.high.x ||
        std::max(from.y, to.y) <= polygon.low.y || std::min(from.y, to.y) >= polygon.high.y) {
        return false;
    }
    double begin = 0, end = 1;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Point2& a = polygon.corners[i];
        const Point2& b = polygon.corners[(i + 1) % polygon.corners.size()];
        const double at_from = turn(a, b, from), at_to = turn(a, b, to);
        if (at_from <= 0 && at_to <= 0) return false;
        if (at_from < 0) begin = std::max(begin, at_from / (at_from - at_to));
        if (at_to < 0) end = std::min(end, at_from / (at_from - at_to));
    }
    return begin < end;
}

}  // namespace

Point2 Polygon::centre() const {
    Point2 sum;
    for (const Point2& p : corners) {
        sum = {sum.x + p.x, sum.y + p.y};
    }
    const auto count = static_cast<double>(corners.size());
    return {sum.x / count, sum.y / count};
}

PlaneFrame::PlaneFrame(const Corners& triangle) : origin_(triangle[0]) {
    // Along the longest edge, so that the axes of a needle are as good as they can be.
    Vec3 longest;
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = triangle[(i + 1) % 3] - triangle[i];
        if (dot(edge, edge) > dot(longest, longest)) longest = edge;
    }
    const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[1]);
    x_axis_ = 1 / length(longest) * longest;
    const Vec3 across = cross(normal, x_axis_);
    y_axis_ = 1 / length(across) * across;
    normal_ = cross(x_axis_, y_axis_);
}

Point2 PlaneFrame::to_plane(const Vec3& point) const {
    return {dot(point - origin_, x_axis_), dot(point - origin_, y_axis_)};
}

Vec3 PlaneFrame::to_space(const Point2& point) const { return origin_ + point.x * x_axis_ + point.y * y_axis_; }

double PlaneFrame::height(const Vec3& point) const { return dot(point - origin_, normal_); }

Polygon in_plane(const PlaneFrame& frame, const Corners& triangle_of_frame) {
    return with_box({frame.to_plane(triangle_of_frame[0]), frame.to_plane(triangle_of_frame[1]),
                     frame.to_plane(triangle_of_frame[2])});
}

Polygon footprint(const PlaneFrame& frame, const Corners& triangle, double reach) {
    // A point of the plane within reach of the triangle is so of a point of the triangle whose height is at most
    // reach, and lies within reach of that point's projection.
    const double slab = reach * (1 + 1e-6);  // for rounding
    std::vector<Point2> points;
    const auto add = [&](const Vec3& p) {
        const Point2 q = frame.to_plane(p);
        for (const double dx : {-slab, slab}) {
            for (const double dy : {-slab, slab}) {
                points.push_back({q.x + dx, q.y + dy});
            }
        }
    };
    for (int i = 0; i < 3; ++i) {
        const Vec3& p = triangle[i];
        const Vec3& q = triangle[(i + 1) % 3];
        const double at_p = frame.height(p), at_q = frame.height(q);
        if (std::abs(at_p) <= slab) add(p);
        for (const double limit : {-slab, slab}) {
            if ((at_p < limit) != (at_q < limit)) add(p + (limit - at_p) / (at_q - at_p) * (q - p));
        }
    }
    return points.empty() ? Polygon{} : convex_hull(std::move(points));
}

std::vector<Polygon> free_pieces(const Polygon& polygon, const std::vector<Polygon>& footprints) {
    std::vector<Polygon> pieces{polygon}, cut;
    for (const Polygon& hole : footprints) {
        cut.clear();
        for (Polygon& piece : pieces) {
            if (boxes_meet(piece, hole)) {
                subtract(std::move(piece), hole, cut);
            } else {
                cut.push_back(std::move(piece));
            }
        }
        pieces.swap(cut);
    }
    return pieces;
}

bool clear_path(const Point2& from, const Point2& to, const std::vector<Polygon>& footprints) {
    return std::none_of(footprints.begin(), footprints.end(),
                        [&](const Polygon& hole) { return enters(from, to, hole); });
}

}  // namespace spectralpack
