#include "formats/polygon_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/stopped.hpp"
#include "formats/mesh_parsers.hpp"

namespace spectralpack {
namespace {

struct Point2 {
    double x = 0, y = 0;
    bool operator==(const Point2&) const = default;
};

/// Twice the signed area of a, b, c.
double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The loop seen along its own normal (Newell's method), counter-clockwise.
std::vector<Point2> flattened(const std::vector<Vec3>& vertices, std::span<const std::uint32_t> loop) {
    Vec3 normal;
    const Vec3 origin = vertices[loop[0]];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        normal = normal + cross(vertices[loop[i]] - origin, vertices[loop[(i + 1) % loop.size()]] - origin);
    }
    int drop = 0;  // the axis the face looks along most
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
    }
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(u, v);
    std::vector<Point2> points;
    points.reserve(loop.size());
    for (const std::uint32_t vertex : loop) {
        points.push_back({vertices[vertex][u] - origin[u], vertices[vertex][v] - origin[v]});
    }
    return points;
}

/// Convex and once around: every corner turns left, and the direction of walking turns by one full
/// circle.
bool is_convex(const std::vector<Point2>& points) {
    const std::size_t n = points.size();
    int reversals = 0;  // of the walk along x: two for a convex loop
    double last = 0, first = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 &a = points[i], &b = points[(i + 1) % n], &c = points[(i + 2) % n];
        if (turn(a, b, c) < 0) return false;
        const double step = b.x - a.x;
        if (step == 0) continue;
        if (first == 0) first = step;
        if (last * step < 0) ++reversals;
        last = step;
    }
    if (first * last < 0) ++reversals;
    return reversals <= 2;
}

/// Ear clipping. A corner's being an ear changes only when a neighbour goes, so each loss of an ear
/// means two new tests, each against the reflex corners alone.
class EarClipper {
  public:
    EarClipper(std::vector<Point2> points, std::span<const std::uint32_t> loop, std::vector<Triangle>& triangles)
        : points_(std::move(points)), loop_(loop), triangles_(triangles), left_(points_.size()) {
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < n; ++i) {
            previous_.push_back((i + n - 1) % n);
            next_.push_back((i + 1) % n);
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (turn_at(i) <= 0) reflex_.push_back(i);
            queue_.push_back(i);
        }
        gone_.assign(n, false);
    }

    void clip() {
        for (std::size_t at = 0; left_ > 3 && at < queue_.size(); ++at) {
            const std::size_t i = queue_[at];
            if (gone_[i] || !is_ear(i)) continue;
            remove(i);
            queue_.push_back(previous_[i]);
            queue_.push_back(next_[i]);
        }
        // What is left is a triangle, or a loop that crosses or lies on itself: there is no right
        // answer, a fan keeps its volume.
        std::size_t i = 0;
        while (gone_[i]) {
            ++i;
        }
        for (; left_ > 2; --left_) {
            const std::size_t second = next_[i], third = next_[second];
            triangles_.push_back({loop_[i], loop_[second], loop_[third]});
            next_[i] = third;
        }
    }

  private:
    double turn_at(std::size_t i) const { return turn(points_[previous_[i]], points_[i], points_[next_[i]]); }

    bool is_ear(std::size_t i) const {
        const Point2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
        if (turn(a, b, c) <= 0) return false;
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t other) {
            if (gone_[other]) return false;
            const Point2& p = points_[other];
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    void remove(std::size_t i) {
        triangles_.push_back({loop_[previous_[i]], loop_[i], loop_[next_[i]]});
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        gone_[i] = true;
        --left_;
    }

    std::vector<Point2> points_;
    std::span<const std::uint32_t> loop_;
    std::vector<Triangle>& triangles_;
    std::size_t left_;
    std::vector<std::size_t> previous_, next_;
    std::vector<std::size_t> reflex_;  ///< at the start; a corner never becomes reflex later
    std::vector<std::size_t> queue_;   ///< corners to test
    std::vector<bool> gone_;
};

}  // namespace

bool triangulate(const std::vector<Vec3>& vertices, std::span<const std::uint32_t> loop,
                 std::vector<Triangle>& triangles) {
    std::vector<Point2> points;
    if (loop.size() > 3) points = flattened(vertices, loop);
    if (loop.size() == 3 || is_convex(points)) {
        for (std::size_t i = 2; i < loop.size(); ++i) {
            triangles.push_back({loop[0], loop[i - 1], loop[i]});
        }
        return true;
    }
    if (loop.size() > kMostConcaveCorners) return false;
    EarClipper(std::move(points), loop, triangles).clip();
    return true;
}

void PolygonFaces::reserve(std::size_t faces) {
    faces_.reserve(faces);
    corners_.reserve(3 * faces);
}

void PolygonFaces::add(std::span<const std::int64_t> corners, std::uint32_t place) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    faces_.push_back({corners_.size(), place});
}

std::vector<Triangle> PolygonFaces::triangles(const std::vector<Vec3>& vertices,
                                              const std::function<void(std::uint32_t, const std::string&)>& fail,
                                              const StopToken& stop) const {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> loop;
    std::size_t begin = 0;
    StopPoll poll(stop);
    for (const Face& face : faces_) {
        poll.step();
        loop.clear();
        for (; begin < face.end; ++begin) {
            const std::int64_t corner = corners_[begin];
            if (corner < 0 || std::cmp_greater_equal(corner, vertices.size())) {
                fail(face.place,
                     "a face refers to a vertex that is not there (there are " + std::to_string(vertices.size()) + ")");
            }
            loop.push_back(static_cast<std::uint32_t>(corner));
        }
        if (loop.size() < 3) fail(face.place, "a face has fewer than three corners");
        if (!triangulate(vertices, loop, triangles)) {
            fail(face.place, "a concave face has more than " + std::to_string(kMostConcaveCorners) + " corners");
        }
        if (triangles.size() > kMostTriangles) fail(face.place, "there are too many triangles");
    }
    return triangles;
}

}  // namespace spectralpack
