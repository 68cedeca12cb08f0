#include "geometry/minimum_box.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "geometry/convex_hull.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kMostVertices = 400;
constexpr std::size_t kMostEdges = 60;  // up to so many, every two of them are crossed
constexpr double kParallel = 1e-6;
constexpr int kDirections = 5;      // half the side of the cube of directions
constexpr double kWorthIt = 1e-4;   // by so much of its volume the axes' own box must be larger
constexpr double kImproved = 1e-9;  // a smaller gain is rounding
constexpr int kMostRounds = 50;

struct Point {
    double u = 0, v = 0;
};

std::vector<Vec3> used_vertices(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            used[vertex] = true;
        }
    }
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) points.push_back(mesh.vertices[i]);
    }
    return points;
}

/// The vertices that lie farthest in each of the directions to the points of a cube's surface.
std::vector<Vec3> extremes(const std::vector<Vec3>& points) {
    std::set<std::size_t> kept;
    for (int i = -kDirections; i <= kDirections; ++i) {
        for (int j = -kDirections; j <= kDirections; ++j) {
            for (int k = -kDirections; k <= kDirections; ++k) {
                if (std::max({std::abs(i), std::abs(j), std::abs(k)}) < kDirections) continue;
                const Vec3 direction{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                std::size_t farthest = 0;
                for (std::size_t p = 1; p < points.size(); ++p) {
                    if (dot(direction, points[p]) > dot(direction, points[farthest])) farthest = p;
                }
                kept.insert(farthest);
            }
        }
    }
    std::vector<Vec3> result;
    for (const std::size_t p : kept) {
        result.push_back(points[p]);
    }
    return result;
}

/// Corners of the outline, counter-clockwise (Andrew's monotone chain).
std::vector<Point> outline(std::vector<Point> points) {
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    std::vector<Point> hull;
    const auto add = [&](const Point& p, std::size_t floor) {
        while (hull.size() >= floor + 2) {
            const Point &a = hull[hull.size() - 2], &b = hull.back();
            if ((b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u) > 0) break;
            hull.pop_back();
        }
        hull.push_back(p);
    };
    for (const Point& p : points) {
        add(p, 0);
    }
    const std::size_t lower = hull.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
        add(*p, lower);
    }
    hull.pop_back();
    return hull;
}

struct FramedBox {
    Mat3 frame;
    double volume = Box::kInfinity;
};

double volume_in(const Mat3& frame, const std::vector<Vec3>& points) {
    Box box;
    for (const Vec3& p : points) {
        box.add(frame * p);
    }
    return box.volume();
}

/// The best box with an axis along the unit vector n and a side on an edge of the outline seen along it.
FramedBox best_along(const Vec3& n, const std::vector<Vec3>& points) {
    const int least = std::abs(n.x) <= std::abs(n.y) ? (std::abs(n.x) <= std::abs(n.z) ? 0 : 2)
                                                     : (std::abs(n.y) <= std::abs(n.z) ? 1 : 2);
    Vec3 axis;
    axis[least] = 1;
    Vec3 u = cross(axis, n);
    u = 1 / length(u) * u;
    const Vec3 v = cross(n, u);
    std::vector<Point> flat;
    double low = Box::kInfinity, high = -Box::kInfinity;
    for (const Vec3& p : points) {
        flat.push_back({dot(u, p), dot(v, p)});
        low = std::min(low, dot(n, p));
        high = std::max(high, dot(n, p));
    }
    const std::vector<Point> corners = outline(std::move(flat));
    FramedBox best;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double du = b.u - a.u, dv = b.v - a.v, edge = std::sqrt(du * du + dv * dv);
        if (!(edge > 0)) continue;
        const Point along{du / edge, dv / edge};
        double first = Box::kInfinity, last = -first, width = 0;
        for (const Point& p : corners) {
            const double t = along.u * p.u + along.v * p.v;
            first = std::min(first, t);
            last = std::max(last, t);
            width = std::max(width, along.u * (p.v - a.v) - along.v * (p.u - a.u));
        }
        const double volume = (last - first) * width * (high - low);
        if (volume < best.volume) {
            const Vec3 x = along.u * u + along.v * v;
            best = {{{x, cross(n, x), n}}, volume};
        }
    }
    return best;
}

/// Unit vectors, one of each pair of opposite ones.
std::vector<Vec3> axes_to_try(const ConvexHull& hull) {
    std::vector<Vec3> axes;
    std::set<std::array<std::int64_t, 3>> seen;
    const auto add = [&](Vec3 axis) {
        if (axis.z < 0 || (axis.z == 0 && (axis.y < 0 || (axis.y == 0 && axis.x < 0)))) axis = -axis;
        axis = 1 / length(axis) * axis;
        const auto rounded = [](double value) { return static_cast<std::int64_t>(std::llround(value * 1e6)); };
        if (seen.insert({rounded(axis.x), rounded(axis.y), rounded(axis.z)}).second) axes.push_back(axis);
    };
    for (const Vec3& normal : hull.normals) {
        add(normal);
    }
    if (hull.edges.size() > kMostEdges) return axes;
    for (std::size_t i = 0; i < hull.edges.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Vec3 across = cross(hull.edges[i], hull.edges[k]);
            if (length(across) > kParallel * length(hull.edges[i]) * length(hull.edges[k])) add(across);
        }
    }
    return axes;
}

/// Of the frames that differ by a rotation of the cube, the one with the greatest trace.
Mat3 nearest_identity(const Mat3& frame) {
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    Mat3 best = frame;
    double greatest = -4;
    for (const auto& order : kOrders) {
        for (int signs = 0; signs < 8; ++signs) {
            Mat3 turned;
            for (int row = 0; row < 3; ++row) {
                turned.rows[row] = (signs >> row & 1 ? -1.0 : 1.0) * frame.rows[order[row]];
            }
            const double trace = turned.rows[0].x + turned.rows[1].y + turned.rows[2].z;
            if (determinant(turned) > 0 && trace > greatest + 1e-9) {
                greatest = trace;
                best = turned;
            }
        }
    }
    return best;
}

}  // namespace

Mat3 minimum_box_frame(const Mesh& mesh) {
    const std::vector<Vec3> points = used_vertices(mesh);
    ConvexHull hull = convex_hull(points);
    if (hull.vertices.size() > kMostVertices) hull = convex_hull(extremes(hull.vertices));
    if (hull.vertices.empty()) return {};

    FramedBox best;
    for (const Vec3& axis : axes_to_try(hull)) {
        const FramedBox found = best_along(axis, hull.vertices);
        if (found.volume < best.volume * (1 - kImproved)) best = found;
    }
    bool improved = true;
    for (int round = 0; improved && round < kMostRounds; ++round) {
        improved = false;
        for (int axis = 0; axis < 3; ++axis) {
            const FramedBox found = best_along(best.frame.rows[static_cast<std::size_t>(axis)], hull.vertices);
            if (found.volume < best.volume * (1 - kImproved)) {
                best = found;
                improved = true;
            }
        }
    }
    // The thinned hull may have flattered it: the mesh itself decides.
    const Mat3 frame = nearest_identity(best.frame);
    return volume_in(frame, points) < (1 - kWorthIt) * volume_in({}, points) ? frame : Mat3{};
}

}  // namespace spectralpack
