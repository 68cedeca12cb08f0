#include "geometry/triangle_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spectralpack {
namespace {

/// What the search for crossings may cost: a look at two boxes is one step.
constexpr std::int64_t kStepsPerTriangle = 2000, kLeastSteps = 10'000'000, kStepsPerTest = 16;

struct Interval {
    double low, high;
};

/// Signed distances of b's corners from the plane of a. None unless some are further than
/// `tolerance` on either side.
std::optional<std::array<double, 3>> sides(const Corners& a, const Vec3& unit_normal, const Corners& b,
                                           double tolerance) {
    std::array<double, 3> side{};
    bool above = false, below = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool shared = b[i] == a[0] || b[i] == a[1] || b[i] == a[2];
        side[i] = shared ? 0 : dot(b[i] - a[0], unit_normal);
        above = above || side[i] > tolerance;
        below = below || side[i] < -tolerance;
    }
    if (!above || !below) return std::nullopt;
    return side;
}

/// Where a triangle with corners on both sides of a plane meets a line in that plane, as positions
/// along `direction`.
Interval span_on(const Corners& t, const std::array<double, 3>& side, const Vec3& direction, const Vec3& origin) {
    Interval span{Box::kInfinity, -Box::kInfinity};
    const auto meet = [&](double position) {
        span.low = std::min(span.low, position);
        span.high = std::max(span.high, position);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double from = dot(t[i] - origin, direction), to = dot(t[j] - origin, direction);
        if (side[i] == 0) meet(from);
        if (side[i] * side[j] < 0) meet(from + (to - from) * (side[i] / (side[i] - side[j])));
    }
    return span;
}

Vec3 unit(const Vec3& v) {
    const double size = length(v);
    return size > 0 ? v * (1 / size) : Vec3{};
}

class CrossingSearch {
  public:
    CrossingSearch(const Mesh& mesh, double tolerance)
        : tree_(mesh),
          tolerance_(tolerance),
          steps_left_(kLeastSteps + kStepsPerTriangle * static_cast<std::int64_t>(mesh.triangles.size())) {}

    SelfCrossings run() {
        if (!tree_.nodes().empty()) within(0);
        return found_;
    }

  private:
    /// Pairs of triangles both under `index`.
    void within(std::uint32_t index) {
        const Bvh::Node& node = tree_.nodes()[index];
        if (node.leaf()) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                test(i, i + 1, node.first + node.count);
            }
            return;
        }
        within(index + 1);
        within(node.first);
        between(index + 1, node.first);
    }

    /// Pairs with one triangle under each.
    void between(std::uint32_t first, std::uint32_t second) {
        const Bvh::Node &a = tree_.nodes()[first], &b = tree_.nodes()[second];
        if (!spend(1) || !meet(a.box(), b.box())) return;
        if (a.leaf() && b.leaf()) {
            for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
                test(i, b.first, b.first + b.count);
            }
        } else if (b.leaf() || (!a.leaf() && a.box().volume() > b.box().volume())) {
            between(first + 1, second);
            between(a.first, second);
        } else {
            between(first, second + 1);
            between(first, b.first);
        }
    }

    /// Triangle `i` against those of [begin, end).
    void test(std::uint32_t i, std::uint32_t begin, std::uint32_t end) {
        const Corners one = tree_.corners(i);
        const Box box = bounding_box(one);
        for (std::uint32_t j = begin; j < end; ++j) {
            const Corners two = tree_.corners(j);
            if (!spend(1)) return;
            if (!meet(box, bounding_box(two))) continue;
            if (!spend(kStepsPerTest)) return;
            const auto place = crossing_point(one, two, tolerance_);
            if (!place) continue;
            ++found_.pairs;
            if (!found_.place) found_.place = place;
        }
    }

    bool spend(std::int64_t steps) {
        steps_left_ -= steps;
        if (steps_left_ < 0) found_.complete = false;
        return found_.complete;
    }

    Bvh tree_;
    double tolerance_;
    std::int64_t steps_left_;
    SelfCrossings found_;
};

}  // namespace

std::optional<Vec3> crossing_point(const Corners& a, const Corners& b, double tolerance) {
    const Vec3 normal_a = unit(cross(a[1] - a[0], a[2] - a[0])), normal_b = unit(cross(b[1] - b[0], b[2] - b[0]));
    const auto side_b = sides(a, normal_a, b, tolerance);
    if (!side_b) return std::nullopt;
    const auto side_a = sides(b, normal_b, a, tolerance);
    if (!side_a) return std::nullopt;
    const Vec3 line = unit(cross(normal_a, normal_b));
    if (line == Vec3{}) return std::nullopt;
    const Vec3& origin = a[0];
    const Interval on_a = span_on(a, *side_a, line, origin), on_b = span_on(b, *side_b, line, origin);
    const double low = std::max(on_a.low, on_b.low), high = std::min(on_a.high, on_b.high);
    if (!(high - low > tolerance)) return std::nullopt;
    // A point of the line of intersection: where an edge of a passes through the plane of b, then
    // along the line.
    Vec3 point = origin;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double from = (*side_a)[i], to = (*side_a)[j];
        if (from * to < 0) point = a[i] + (from / (from - to)) * (a[j] - a[i]);
    }
    return point + ((low + high) / 2 - dot(point - origin, line)) * line;
}

SelfCrossings self_crossings(const Mesh& mesh, double tolerance) { return CrossingSearch(mesh, tolerance).run(); }

}  // namespace spectralpack
