#include "verify/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/triangle_sweep.hpp"

namespace spectralpack {
namespace {

/// Boxes are asked with so much more room than flat meetings need, for rounding.
constexpr double kSweepRoom = 1e-6;  ///< mm
/// Once a penetration is found, so many more pairs of triangles, or times, are looked at for a deeper one.
constexpr int kDeeperPairs = 4096;
constexpr int kDeeperTimes = 8;
/// Times of flat meetings nearer than this in travel are looked at together.
constexpr double kSameTime = 2;  ///< tolerances

Vec3 to_vec3(const fcl::Vector3<double>& v) { return {v[0], v[1], v[2]}; }

/// The box of a rectangle swept by a sphere.
struct TurnedBox {
    explicit TurnedBox(const fcl::RSS<double>& volume)
        : axes{to_vec3(volume.axis.col(0)), to_vec3(volume.axis.col(1)), to_vec3(volume.axis.col(2))},
          half{volume.l[0] / 2 + volume.r, volume.l[1] / 2 + volume.r, volume.r},
          centre(to_vec3(volume.To) + volume.l[0] / 2 * axes[0] + volume.l[1] / 2 * axes[1]) {}

    void place(const Transform& transform) {
        for (Vec3& axis : axes) {
            axis = transform.linear * axis;
        }
        centre = transform * centre;
    }

    /// Half the box's extent along an axis.
    double reach(const Vec3& along) const {
        return half.x * std::abs(dot(axes[0], along)) + half.y * std::abs(dot(axes[1], along)) +
               half.z * std::abs(dot(axes[2], along));
    }

    std::array<Vec3, 3> axes;  ///< unit vectors
    Vec3 half;                 ///< extents along them
    Vec3 centre;
};

/// May the boxes come as near as `room` while `a` moves?
bool meet(const TurnedBox& a, const TurnedBox& b, const Vec3& move, double room) {
    const Vec3 apart = b.centre - a.centre;
    double begin = 0, end = 1;
    const auto meet_along = [&](const Vec3& axis) {
        const double reach = a.reach(axis) + b.reach(axis) + room * length(axis);
        const double at = dot(axis, apart), speed = dot(axis, move);
        if (std::abs(speed) <= 1e-12 * length(move)) return std::abs(at) <= reach;
        const double middle = at / speed, slack = std::abs(reach / speed);
        begin = std::max(begin, middle - slack);
        end = std::min(end, middle + slack);
        return begin <= end;
    };
    for (const Vec3& axis : a.axes) {
        if (!meet_along(axis)) return false;
    }
    for (const Vec3& axis : b.axes) {
        if (!meet_along(axis)) return false;
    }
    // As seen along the move; an axis parallel to it gives the axis 0, which separates nothing.
    for (const TurnedBox* box : {&a, &b}) {
        for (const Vec3& axis : box->axes) {
            if (!meet_along(cross(axis, move))) return false;
        }
    }
    return true;
}

/// Works in a's own coordinates.
class Sweep {
  public:
    Sweep(const PosedSolid& posed_a, const PosedSolid& posed_b, const Vec3& move, double tolerance)
        : a_(*posed_a.solid), b_(*posed_b.solid), tolerance_(tolerance) {
        const Mat3 back = transposed(posed_a.pose.linear);
        b_to_a_ = {back * posed_b.pose.linear, back * (posed_b.pose.translation - posed_a.pose.translation)};
        move_ = back * move;
        oriented_ = a_.closed() && b_.closed();
    }

    SweepResult run() {
        if (!a_.hierarchy() || !b_.hierarchy() || !(length(move_) > 0)) return {};
        std::vector<std::pair<int, int>> open{{0, 0}};
        while (!open.empty() && further_pairs_ > 0) {
            const auto [i, j] = open.back();
            open.pop_back();
            const auto& node_a = a_.hierarchy()->getBV(i);
            const auto& node_b = b_.hierarchy()->getBV(j);
            const TurnedBox box_a(node_a.bv);
            TurnedBox box_b(node_b.bv);
            box_b.place(b_to_a_);
            if (!meet(box_a, box_b, move_, kFlatReach * tolerance_ + kSweepRoom)) continue;
            if (node_a.isLeaf() && node_b.isLeaf()) {
                look_at(a_.triangle(node_a.primitiveId()), b_.triangle(node_b.primitiveId()));
            } else if (node_b.isLeaf() ||
                       (!node_a.isLeaf() && dot(box_a.half, box_a.half) > dot(box_b.half, box_b.half))) {
                open.emplace_back(node_a.leftChild(), j);
                open.emplace_back(node_a.rightChild(), j);
            } else {
                open.emplace_back(i, node_b.leftChild());
                open.emplace_back(i, node_b.rightChild());
            }
        }
        if (found_.depth == 0) look_behind_flat_meetings();
        return found_;
    }

  private:
    void look_at(std::size_t triangle_a, std::size_t triangle_b) {
        const Corners on_a = a_.corners(triangle_a);
        Corners on_b = b_.corners(triangle_b);
        for (Vec3& corner : on_b) {
            corner = b_to_a_ * corner;
        }
        const TrianglePassage passage = pass(on_a, on_b, move_, tolerance_);
        if (passage.depth > found_.depth) found_ = {passage.depth, passage.at * length(move_)};
        if (found_.depth > 0) {
            --further_pairs_;
        } else if (passage.flat && (!passage.starts_flat || closing(on_a, on_b))) {
            flat_meetings_.push_back(passage.look_at);
        }
    }

    /// The triangles face each other as the one moves towards the other.
    bool closing(const Corners& on_a, const Corners& on_b) const {
        const auto forward = [&](const Corners& c) { return dot(cross(c[1] - c[0], c[2] - c[0]), move_); };
        return !oriented_ || (forward(on_a) > 0 && forward(on_b) < 0);
    }

    void look_behind_flat_meetings() {
        std::sort(flat_meetings_.begin(), flat_meetings_.end());
        const double same = kSameTime * tolerance_ / length(move_);
        double last = -1;
        for (const double t : flat_meetings_) {
            if (last >= 0 && t - last < same) continue;
            last = t;
            if (!compare_at(t)) continue;
            for (int i = 1; i <= kDeeperTimes; ++i) {
                compare_at(t + (1 - t) * i / kDeeperTimes);
            }
            return;
        }
    }

    /// Whether they overlap at that time.
    bool compare_at(double t) {
        const Relation relation = compare({&a_, {Mat3{}, t * move_}}, {&b_, b_to_a_}, tolerance_, 0);
        if (relation.kind == Relation::Kind::apart) return false;
        if (relation.depth > found_.depth) found_ = {relation.depth, t * length(move_)};
        return true;
    }

    const Solid& a_;
    const Solid& b_;
    const double tolerance_;
    Transform b_to_a_;
    Vec3 move_;
    bool oriented_ = false;  ///< both have an outside
    SweepResult found_;
    int further_pairs_ = kDeeperPairs;
    std::vector<double> flat_meetings_;  ///< when to look behind them, as shares of the move
};

}  // namespace

SweepResult sweep(const PosedSolid& a, const PosedSolid& b, const Vec3& move, double tolerance) {
    return Sweep(a, b, move, tolerance).run();
}

}  // namespace spectralpack
