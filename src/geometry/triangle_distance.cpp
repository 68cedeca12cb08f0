#include "geometry/triangle_distance.hpp"

namespace spectralpack {

namespace {

/// A triangle with what all tests against it share.
struct Prepared {
    explicit Prepared(const Corners& corners) : corner(corners) {
        for (int i = 0; i < 3; ++i) {
            edge[i] = corner[(i + 1) % 3] - corner[i];
            const double square = dot(edge[i], edge[i]);
            inverse_square[i] = square > 0 ? 1 / square : 0;
        }
        // From the corner between the two shorter edges the cross product loses least on needles.
        const int longest = dot(edge[0], edge[0]) >= dot(edge[1], edge[1])
                                ? (dot(edge[0], edge[0]) >= dot(edge[2], edge[2]) ? 0 : 2)
                                : (dot(edge[1], edge[1]) >= dot(edge[2], edge[2]) ? 1 : 2);
        base = (longest + 2) % 3;
        normal = cross(edge[base], -edge[(base + 2) % 3]);
        normal_square = dot(normal, normal);
    }

    Corners corner;
    std::array<Vec3, 3> edge;  ///< i: from corner i to corner i + 1
    std::array<double, 3> inverse_square;
    int base = 0;
    Vec3 normal;
    double normal_square = 0;
};

class Closest {
  public:
    Closest(const Corners& a, const Corners& b) : a_(a), b_(b) {}

    ClosestPoints find() {
        std::array<double, 3> a_side, b_side;  // of the other's plane, times its normal's length
        for (int i = 0; i < 3; ++i) {
            a_side[i] = dot(b_.normal, a_.corner[i] - b_.corner[b_.base]);
            b_side[i] = dot(a_.normal, b_.corner[i] - a_.corner[a_.base]);
        }
        if (passes_through(a_, a_side, b_, false) || passes_through(b_, b_side, a_, true)) {
            return {0, on_a_, on_a_};
        }
        for (int i = 0; i < 3; ++i) {
            corner_to_triangle(a_.corner[i], b_, false);
            corner_to_triangle(b_.corner[i], a_, true);
            for (int j = 0; j < 3; ++j) {
                edge_to_edge(i, j);
            }
        }
        return {std::sqrt(square_), on_a_, on_b_};
    }

  private:
    static constexpr double kSamePoint = 1e-12;  ///< times the edge: what rounding leaves of 0

    void offer(const Vec3& on_a, const Vec3& on_b) {
        const Vec3 apart = on_a - on_b;
        const double square = dot(apart, apart);
        if (square < square_) {
            square_ = square;
            on_a_ = on_a;
            on_b_ = on_b;
        }
    }

    /// `swapped`: the corner is b's, the triangle a.
    void corner_to_triangle(const Vec3& p, const Prepared& t, bool swapped) {
        const auto offer_point = [&](const Vec3& on_t) { swapped ? offer(on_t, p) : offer(p, on_t); };
        for (int i = 0; i < 3; ++i) {
            const double s = dot(p - t.corner[i], t.edge[i]) * t.inverse_square[i];
            offer_point(t.corner[i] + std::clamp(s, 0.0, 1.0) * t.edge[i]);
        }
        if (!(t.normal_square > 0)) return;
        // Weights of the two other corners as seen from the base corner.
        const Vec3 u = t.edge[t.base], v = -t.edge[(t.base + 2) % 3];
        const Vec3 w = p - t.corner[t.base];
        const double weight_u = dot(cross(w, v), t.normal) / t.normal_square;
        const double weight_v = dot(cross(u, w), t.normal) / t.normal_square;
        if (weight_u > 0 && weight_v > 0 && weight_u + weight_v < 1) {
            offer_point(t.corner[t.base] + weight_u * u + weight_v * v);
        }
    }

    /// The common perpendicular of two edges, where it meets both within. (Elsewhere a corner is
    /// nearest.)
    void edge_to_edge(int i, int j) {
        const Vec3& u = a_.edge[i];
        const Vec3& v = b_.edge[j];
        const Vec3 n = cross(u, v);
        const double square = dot(n, n);
        if (!(square > 0)) return;
        const Vec3 w = b_.corner[j] - a_.corner[i];
        const double s = dot(cross(w, v), n) / square;
        if (!(s >= 0 && s <= 1)) return;
        const double t = dot(cross(w, u), n) / square;
        if (!(t >= 0 && t <= 1)) return;
        offer(a_.corner[i] + s * u, b_.corner[j] + t * v);
    }

    /// Does an edge of `t` pass through the inside of `through`? `side`: where t's corners lie.
    /// What only touches is found by the other tests. The plane of a needle may be noise, so where
    /// signs say that the edge passes, the point in question decides. `swapped`: t is b.
    bool passes_through(const Prepared& t, const std::array<double, 3>& side, const Prepared& through, bool swapped) {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            if (!((side[i] < 0 && side[j] > 0) || (side[i] > 0 && side[j] < 0))) continue;
            int left = 0, right = 0;
            for (int k = 0; k < 3; ++k) {
                const Vec3 p = through.corner[k] - t.corner[i];
                const double turn = dot(t.edge[i], cross(p, through.edge[k]));
                left += turn >= 0;
                right += turn <= 0;
            }
            if (left == 3 || right == 3) {
                const double along = side[i] / (side[i] - side[j]);
                corner_to_triangle(t.corner[i] + along * t.edge[i], through, swapped);
                if (square_ <= kSamePoint * kSamePoint * dot(t.edge[i], t.edge[i])) return true;
            }
        }
        return false;
    }

    Prepared a_, b_;
    double square_ = Box::kInfinity;
    Vec3 on_a_, on_b_;
};

}  // namespace

ClosestPoints closest_points(const Corners& a, const Corners& b) { return Closest(a, b).find(); }

double plane_separation(const Corners& a, const Corners& b) {
    double most = -Box::kInfinity;
    for_each_plane(a, b, [&](const Vec3&, double separation) { most = std::max(most, separation); });
    return most;
}

}  // namespace spectralpack
