#include "geometry/loop_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace spectralpack {
namespace {

using Node = std::uint32_t;
constexpr Node kNone = std::numeric_limits<Node>::max();
constexpr Node kUnknown = kNone - 1;

constexpr double kThin = 1e-6;  // of the area's extent

/// Twice the signed area: positive where c is left of the way from a to b.
double area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double square(const PlanePoint& a, const PlanePoint& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The segments share a point.
bool meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
        return false;
    }
    const double ac = area(a, b, c), ad = area(a, b, d), ca = area(c, d, a), cb = area(c, d, b);
    return !((ac > 0 && ad > 0) || (ac < 0 && ad < 0) || (ca > 0 && cb > 0) || (ca < 0 && cb < 0));
}

/// One outer loop with its holes: a ring of nodes that becomes shorter ear by ear. A bridge goes there and back, so
/// points at its ends have two nodes.
class Area {
  public:
    Area(std::span<const PlanePoint> points, const Loop& outer) : points_(points) { first_ = add(outer); }

    /// Holes in the order of their rightmost points, the one furthest right first: then none stands between the next
    /// one's rightmost point and the ring.
    void join(std::vector<const Loop*> holes);

    void clip(std::vector<Triangle>& triangles);

  private:
    const PlanePoint& at(Node node) const { return points_[point_[node]]; }

    Node add(const Loop& loop) {
        const Node first = static_cast<Node>(point_.size());
        const auto count = static_cast<Node>(loop.size());
        for (Node i = 0; i < count; ++i) {
            point_.push_back(loop[i]);
            next_.push_back(first + (i + 1) % count);
            before_.push_back(first + (i + count - 1) % count);
        }
        return first;
    }

    void link(Node node, Node next) {
        next_[node] = next;
        before_[next] = node;
    }

    /// A line from the node towards `target` begins inside the area.
    bool opens_towards(Node node, const PlanePoint& target) const {
        const PlanePoint &a = at(before_[node]), &b = at(node), &c = at(next_[node]);
        const bool left_of_in = area(a, b, target) > 0, left_of_out = area(b, c, target) > 0;
        return area(a, b, c) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
    }

    bool crosses(Node from, Node to, Node node) const {
        const Node next = next_[node];
        for (const Node end : {point_[node], point_[next]}) {
            if (end == point_[from] || end == point_[to]) return false;
        }
        return meet(at(from), at(to), at(node), at(next));
    }

    bool sees(Node from, Node to, Node nodes) const {
        if (!opens_towards(from, at(to)) || !opens_towards(to, at(from))) return false;
        for (Node node = 0; node < nodes; ++node) {
            if (crosses(from, to, node)) return false;
        }
        return true;
    }

    void bridge(Node outer, Node hole);
    void judge(Node node);
    Node blocker(Node node) const;
    Node best_ear(bool thin_too);

    std::span<const PlanePoint> points_;
    std::vector<Node> point_, next_, before_, blocker_;
    std::vector<double> height_;   // of each node's triangle over its longest side; negative where the ring turns right
    std::vector<double> quality_;  // that, in longest sides
    Node first_ = 0;
    double thin_ = 0;
};

void Area::bridge(Node outer, Node hole) {
    const Node outer_again = add({point_[outer]}), hole_again = add({point_[hole]});
    const Node after = next_[outer], end = before_[hole];
    link(outer, hole);
    link(end, hole_again);
    link(hole_again, outer_again);
    link(outer_again, after);
}

void Area::join(std::vector<const Loop*> holes) {
    const auto rightmost = [&](const Loop& loop) {
        return *std::max_element(loop.begin(), loop.end(),
                                 [&](std::uint32_t a, std::uint32_t b) { return points_[a].x < points_[b].x; });
    };
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const Loop* a, const Loop* b) { return points_[rightmost(*a)].x > points_[rightmost(*b)].x; });
    std::vector<Node> starts;
    for (const Loop* hole : holes) {
        starts.push_back(add(*hole));
    }
    for (const Node start : starts) {
        Node hole = start;
        for (Node node = next_[start]; node != start; node = next_[node]) {
            if (at(node).x > at(hole).x) hole = node;
        }
        std::vector<std::pair<double, Node>> near;
        Node node = first_;
        do {
            near.emplace_back(square(at(hole), at(node)), node);
            node = next_[node];
        } while (node != first_);
        std::sort(near.begin(), near.end());
        const auto nodes = static_cast<Node>(point_.size());
        const auto seen = std::find_if(near.begin(), near.end(),
                                       [&](const auto& candidate) { return sees(candidate.second, hole, nodes); });
        bridge((seen == near.end() ? near.begin() : seen)->second, hole);
    }
}

/// How good an ear the node is, but for what stands in its way.
void Area::judge(Node node) {
    const PlanePoint &a = at(before_[node]), &b = at(node), &c = at(next_[node]);
    const double longest = std::sqrt(std::max({square(a, b), square(b, c), square(c, a)}));
    height_[node] = longest > 0 ? area(a, b, c) / longest : 0;
    quality_[node] = longest > 0 ? height_[node] / longest : 0;
    blocker_[node] = kUnknown;
}

/// A node whose point lies in the triangle or on the side that clipping would make; kNone: there is none.
Node Area::blocker(Node node) const {
    const Node before = before_[node], next = next_[node];
    const PlanePoint &a = at(before), &b = at(node), &c = at(next);
    const double side = std::sqrt(square(a, c)), slack = thin_ * side;
    const double low_x = std::min({a.x, b.x, c.x}) - thin_, high_x = std::max({a.x, b.x, c.x}) + thin_;
    const double low_y = std::min({a.y, b.y, c.y}) - thin_, high_y = std::max({a.y, b.y, c.y}) + thin_;
    for (Node other = next_[next]; other != before; other = next_[other]) {
        const PlanePoint& p = at(other);
        if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
        const std::uint32_t point = point_[other];
        if (point == point_[before] || point == point_[node] || point == point_[next]) continue;
        if (area(a, b, p) < 0 || area(b, c, p) < 0 || area(c, a, p) < -slack) continue;
        return other;
    }
    return kNone;
}

Node Area::best_ear(bool thin_too) {
    Node best = kNone;
    Node node = first_;
    do {
        if (quality_[node] > 0 && (best == kNone || quality_[node] > quality_[best]) &&
            (thin_too || height_[node] > thin_)) {
            if (blocker_[node] != kNone && (blocker_[node] == kUnknown || next_[blocker_[node]] == kNone)) {
                blocker_[node] = blocker(node);
            }
            if (blocker_[node] == kNone) best = node;
        }
        node = next_[node];
    } while (node != first_);
    return best;
}

void Area::clip(std::vector<Triangle>& triangles) {
    double low_x = at(first_).x, high_x = low_x, low_y = at(first_).y, high_y = low_y;
    height_.resize(point_.size());
    quality_.resize(point_.size());
    blocker_.resize(point_.size());
    std::size_t left = 0;
    Node node = first_;
    do {
        low_x = std::min(low_x, at(node).x);
        high_x = std::max(high_x, at(node).x);
        low_y = std::min(low_y, at(node).y);
        high_y = std::max(high_y, at(node).y);
        judge(node);
        ++left;
        node = next_[node];
    } while (node != first_);
    thin_ = kThin * std::max(high_x - low_x, high_y - low_y);

    for (; left >= 3; --left) {
        Node ear = best_ear(false);
        if (ear == kNone) ear = best_ear(true);
        if (ear == kNone) {  // the loops cross: whatever is left is closed all the same
            ear = first_;
            for (node = next_[first_]; node != first_; node = next_[node]) {
                if (quality_[node] > quality_[ear]) ear = node;
            }
        }
        const Node before = before_[ear], next = next_[ear];
        const std::uint32_t a = point_[before], b = point_[ear], c = point_[next];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
        link(before, next);
        next_[ear] = kNone;
        first_ = next;
        judge(before);
        judge(next);
    }
}

double signed_area(std::span<const PlanePoint> points, const Loop& loop) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        sum += area(points[loop[0]], points[loop[i]], points[loop[i + 1]]);
    }
    return sum;
}

bool contains(std::span<const PlanePoint> points, const Loop& loop, const PlanePoint& p) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const PlanePoint &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if ((area(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

}  // namespace

std::vector<Triangle> fill_loops(std::span<const PlanePoint> points, const std::vector<Loop>& loops) {
    std::vector<double> areas;
    for (const Loop& loop : loops) {
        areas.push_back(signed_area(points, loop));
    }
    std::vector<std::vector<const Loop*>> holes(loops.size());
    std::vector<std::size_t> alone;  // holes in nothing: of a body that faces inwards
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (areas[i] >= 0) continue;
        std::size_t outer = loops.size();
        for (std::size_t k = 0; k < loops.size(); ++k) {
            if (areas[k] > 0 && (outer == loops.size() || areas[k] < areas[outer]) &&
                contains(points, loops[k], points[loops[i][0]])) {
                outer = k;
            }
        }
        if (outer == loops.size()) {
            alone.push_back(i);
        } else {
            holes[outer].push_back(&loops[i]);
        }
    }
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (areas[i] < 0) continue;
        Area filled(points, loops[i]);
        filled.join(std::move(holes[i]));
        filled.clip(triangles);
    }
    for (const std::size_t i : alone) {
        const std::size_t first = triangles.size();
        Area(points, Loop(loops[i].rbegin(), loops[i].rend())).clip(triangles);
        for (std::size_t t = first; t < triangles.size(); ++t) {
            std::swap(triangles[t][1], triangles[t][2]);
        }
    }
    return triangles;
}

}  // namespace spectralpack
