#include "geometry/meeting_interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spectralpack {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<std::size_t, 3> kNext{1, 2, 0};

/// Whether no edge of `t` parts the two.
bool edges_overlap(const SeenTriangle& t, double area, const SeenTriangle& other, double graze_square) {
    const double own_low = std::min(0.0, area), own_high = std::max(0.0, area);
    for (std::size_t i = 0; i < 3; ++i) {
        const double eu = t.u[kNext[i]] - t.u[i], ev = t.v[kNext[i]] - t.v[i];
        const double square = eu * eu + ev * ev;
        if (!(square > 0)) continue;
        // Across the edge, times its length: t reaches from the edge to its third corner.
        double low = kInfinity, high = -kInfinity;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = eu * (other.v[k] - t.v[i]) - ev * (other.u[k] - t.u[i]);
            low = std::min(low, side);
            high = std::max(high, side);
        }
        const double overlap = std::min(own_high - low, high - own_low);
        if (!(overlap > 0 && overlap * overlap > graze_square * square)) return false;
    }
    return true;
}

/// Of the longest edge as seen.
double longest_square(const SeenTriangle& t) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double eu = t.u[kNext[i]] - t.u[i], ev = t.v[kNext[i]] - t.v[i];
        longest = std::max(longest, eu * eu + ev * ev);
    }
    return longest;
}

struct Heights {
    double low = kInfinity, high = -kInfinity;

    void add(double s) {
        low = std::min(low, s);
        high = std::max(high, s);
    }
};

/// The heights that `t`, seen edge on, covers where its shadow crosses that of `wall`.
Heights heights_at(const SeenTriangle& t, const SeenTriangle& wall) {
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double eu = wall.u[kNext[i]] - wall.u[i], ev = wall.v[kNext[i]] - wall.v[i];
        if (eu * eu + ev * ev > most) {
            most = eu * eu + ev * ev;
            longest = i;
        }
    }
    const double eu = wall.u[kNext[longest]] - wall.u[longest], ev = wall.v[kNext[longest]] - wall.v[longest];
    std::array<double, 3> side;
    for (std::size_t k = 0; k < 3; ++k) {
        side[k] = eu * (t.v[k] - wall.v[longest]) - ev * (t.u[k] - wall.u[longest]);
    }
    Heights heights;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = kNext[k];
        if (side[k] == 0) heights.add(t.s[k]);
        if (!((side[k] < 0 && side[next] > 0) || (side[k] > 0 && side[next] < 0))) continue;
        const double share = side[k] / (side[k] - side[next]);
        heights.add(t.s[k] + share * (t.s[next] - t.s[k]));
    }
    return heights;
}

/// The heights above `base` of the part of `t` that is over its shadow.
Heights heights_over(const SeenTriangle& t, const SeenTriangle& base, double base_area) {
    struct Point {
        double u, v, s;
    };
    // At most six corners but for rounding, which may make a cut through a sliver wind: 4, then 6, then 9.
    constexpr std::size_t kMostCorners = 9;
    std::array<Point, kMostCorners> here, there;
    Point *polygon = here.data(), *cut = there.data();
    std::size_t count = 3;
    // From a corner of the base: its plane's slopes times coordinates stay as small as they can.
    for (std::size_t k = 0; k < 3; ++k) {
        polygon[k] = {t.u[k] - base.u[0], t.v[k] - base.v[0], t.s[k] - base.s[0]};
    }
    const double turn = base_area > 0 ? 1 : -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double pu = base.u[i] - base.u[0], pv = base.v[i] - base.v[0];
        const double eu = turn * (base.u[kNext[i]] - base.u[i]), ev = turn * (base.v[kNext[i]] - base.v[i]);
        std::array<double, kMostCorners> side;
        bool all = true;
        for (std::size_t k = 0; k < count; ++k) {
            side[k] = eu * (polygon[k].v - pv) - ev * (polygon[k].u - pu);
            all = all && side[k] >= 0;
        }
        if (all) continue;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = k + 1 < count ? k + 1 : 0;
            const Point &p = polygon[k], &q = polygon[next];
            if (side[k] >= 0) cut[kept++] = p;
            if ((side[k] >= 0) == (side[next] >= 0)) continue;
            const double share = side[k] / (side[k] - side[next]);
            cut[kept++] = {p.u + share * (q.u - p.u), p.v + share * (q.v - p.v), p.s + share * (q.s - p.s)};
        }
        std::swap(polygon, cut);
        count = kept;
    }
    const double u1 = base.u[1] - base.u[0], v1 = base.v[1] - base.v[0], s1 = base.s[1] - base.s[0];
    const double u2 = base.u[2] - base.u[0], v2 = base.v[2] - base.v[0], s2 = base.s[2] - base.s[0];
    const double per_u = (s1 * v2 - s2 * v1) / base_area, per_v = (s2 * u1 - s1 * u2) / base_area;
    Heights heights;
    for (std::size_t k = 0; k < count; ++k) {
        heights.add(polygon[k].s - (per_u * polygon[k].u + per_v * polygon[k].v));
    }
    return heights;
}

double width_square(const SeenTriangle& t, double area) {
    const double longest = longest_square(t);
    return longest > 0 ? area * area / longest : 0;
}

double shadow_area(const SeenTriangle& t) {
    return (t.u[1] - t.u[0]) * (t.v[2] - t.v[0]) - (t.v[1] - t.v[0]) * (t.u[2] - t.u[0]);
}

}  // namespace

void SeenTriangle::see(const Corners& corners, const Vec3& offset, AxisDirection direction) {
    sign = direction.sign;
    const int along = direction.axis, across = (along + 1) % 3, aside = (along + 2) % 3;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = corners[k][across] + offset[across];
        v[k] = corners[k][aside] + offset[aside];
        s[k] = sign * (corners[k][along] + offset[along]);
    }
    u0 = std::min({u[0], u[1], u[2]}), u1 = std::max({u[0], u[1], u[2]});
    v0 = std::min({v[0], v[1], v[2]}), v1 = std::max({v[0], v[1], v[2]});
    low = std::min({s[0], s[1], s[2]}), high = std::max({s[0], s[1], s[2]});
}

double SeenTriangle::facing() const { return sign * shadow_area(*this); }

bool shadows_overlap(const SeenTriangle& a, const SeenTriangle& b, double graze) {
    const double area_a = shadow_area(a), area_b = shadow_area(b);
    const double square_a = longest_square(a), square_b = longest_square(b);
    if (!(square_a > 0) && !(square_b > 0)) return false;  // two points
    return edges_overlap(a, area_a, b, graze * graze) && edges_overlap(b, area_b, a, graze * graze);
}

MeetingInterval meeting_interval(const SeenTriangle& a, const SeenTriangle& b) {
    const double area_a = shadow_area(a), area_b = shadow_area(b);
    const double width_a = width_square(a, area_a), width_b = width_square(b, area_b);
    double enter, leave;
    if (std::max(width_a, width_b) > kThinShadow * kThinShadow) {
        const bool over_b = width_b >= width_a;
        const Heights heights = over_b ? heights_over(a, b, area_b) : heights_over(b, a, area_a);
        enter = over_b ? -heights.high : heights.low;
        leave = over_b ? -heights.low : heights.high;
    } else {
        const Heights of_a = heights_at(a, b), of_b = heights_at(b, a);
        enter = of_b.low - of_a.high;
        leave = of_b.high - of_a.low;
    }
    // Rounding must not lead beyond the boxes.
    return {std::max(enter, b.low - a.high), std::min(leave, b.high - a.low)};
}

}  // namespace spectralpack
