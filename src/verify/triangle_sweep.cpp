#include "verify/triangle_sweep.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

/// Two edges whose cross product is this much smaller than they are count as parallel.
constexpr double kParallel = 1e-7;

/// Times t of a move, 0 <= t <= 1.
struct Times {
    double begin = 0, end = 1;

    bool empty() const { return !(begin < end); }
    /// Keeps those with at_start + t rate > least.
    void keep_above(double at_start, double rate, double least) {
        const double missing = least - at_start;
        if (rate > 0) {
            begin = std::max(begin, missing / rate);
        } else if (rate < 0) {
            end = std::min(end, missing / rate);
        } else if (missing >= 0) {
            end = -Box::kInfinity;
        }
    }
};

/// The triangles seen along one axis: `a` comes from below.
struct Shadow {
    double entered = 0;  ///< how far a's upper end lies above b's lower end at the start
    double left = 0;     ///< how far b's upper end lies above a's lower end at the start
    double speed = 0;    ///< of a, along the axis, >= 0

    double width() const { return entered + left; }
    double overlap(double t) const { return std::min(entered + t * speed, left - t * speed); }
};

class Passage {
  public:
    Passage(const Corners& a, const Corners& b, const Vec3& move, double tolerance)
        : a_(a), b_(b), move_(move), tolerance_(tolerance) {}

    TrianglePassage run() {
        TrianglePassage passage;
        if (!all_axes()) return passage;
        if (!deep_.empty()) {
            passage.at = deepest_time();
            passage.depth = overlap(passage.at);
            if (passage.depth > tolerance_) return passage;
            passage.depth = 0;
        }
        if (flattest_ < 0) return passage;
        const Shadow& flat = shadows_[flattest_];
        if (flat.entered + flat.speed <= tolerance_) return passage;  // it does not get through
        passage.flat = true;
        passage.starts_flat = flat.entered > -kFlatReach * tolerance_;
        passage.look_at = std::clamp((flat.width() + kFlatReach * tolerance_ - flat.entered) / flat.speed, 0.0, 1.0);
        return passage;
    }

  private:
    /// False as soon as the triangles are known to stay apart.
    bool all_axes() {
        const std::array<Vec3, 3> edges_a{a_[1] - a_[0], a_[2] - a_[1], a_[0] - a_[2]};
        const std::array<Vec3, 3> edges_b{b_[1] - b_[0], b_[2] - b_[1], b_[0] - b_[2]};
        // What the theorem does not ask for, but flat pairs need: the outlines as seen along the move.
        for (const auto* edges : {&edges_a, &edges_b}) {
            for (const Vec3& edge : *edges) {
                if (!across(edge, move_)) return false;
            }
        }
        if (!across(edges_a[0], edges_a[1]) || !across(edges_b[0], edges_b[1])) return false;
        for (const Vec3& edge_a : edges_a) {
            for (const Vec3& edge_b : edges_b) {
                if (!across(edge_a, edge_b)) return false;
            }
        }
        return true;
    }

    /// Looks along the axis perpendicular to both.
    bool across(const Vec3& u, const Vec3& v) {
        const Vec3 axis = cross(u, v);
        const double squared = dot(axis, axis);
        if (squared <= kParallel * kParallel * dot(u, u) * dot(v, v)) return true;
        return look_along(1 / std::sqrt(squared) * axis);
    }

    bool look_along(Vec3 axis) {
        Shadow shadow;
        shadow.speed = dot(axis, move_);
        if (shadow.speed < 0) {
            axis = -axis;
            shadow.speed = -shadow.speed;
        }
        const double a1 = dot(axis, a_[1] - a_[0]), a2 = dot(axis, a_[2] - a_[0]);
        const double b0 = dot(axis, b_[0] - a_[0]), b1 = dot(axis, b_[1] - a_[0]), b2 = dot(axis, b_[2] - a_[0]);
        shadow.entered = std::max({0.0, a1, a2}) - std::min({b0, b1, b2});
        shadow.left = std::max({b0, b1, b2}) - std::min({0.0, a1, a2});
        const bool flat = shadow.width() <= kFlatWidth * tolerance_;
        if (flat && (flattest_ < 0 || shadow.speed > shadows_[flattest_].speed)) flattest_ = count_;
        shadows_[count_++] = shadow;
        deep_.keep_above(shadow.entered, shadow.speed, tolerance_);
        deep_.keep_above(shadow.left, -shadow.speed, tolerance_);
        const double least = flat ? -kFlatReach * tolerance_ : tolerance_;
        near_.keep_above(shadow.entered, shadow.speed, least);
        near_.keep_above(shadow.left, -shadow.speed, least);
        return !near_.empty();
    }

    double overlap(double t) const {
        double least = Box::kInfinity;
        for (int i = 0; i < count_; ++i) {
            least = std::min(least, shadows_[i].overlap(t));
        }
        return least;
    }

    /// The overlap is the least of linear functions of time, so it rises and then falls.
    double deepest_time() const {
        double begin = deep_.begin, end = deep_.end;
        for (int round = 0; round < 60; ++round) {
            const double one = begin + (end - begin) / 3, two = end - (end - begin) / 3;
            (overlap(one) < overlap(two) ? begin : end) = overlap(one) < overlap(two) ? one : two;
        }
        return (begin + end) / 2;
    }

    const Corners& a_;
    const Corners& b_;
    const Vec3 move_;
    const double tolerance_;
    Times deep_;  ///< overlap above the tolerance on all axes so far
    Times near_;  ///< the same, but on axes along which they are flat they need only be near
    std::array<Shadow, 17> shadows_;
    int count_ = 0;
    int flattest_ = -1;  ///< of those along which they are flat, the axis of the fastest passage
};

}  // namespace

TrianglePassage pass(const Corners& a, const Corners& b, const Vec3& move, double tolerance) {
    return Passage(a, b, move, tolerance).run();
}

}  // namespace spectralpack
