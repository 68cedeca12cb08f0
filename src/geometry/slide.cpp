/// The exact swept test. For triangles a (moving by t along the axis) and b, C = b - a is a convex
/// polytope and their distance f(t) is that of the point t e from C: convex in t, and
/// differentiable where positive, its slope being e . (pa - pb) / f for the closest points pa and
/// pb.
///
/// gap > 0. Two levels: the move is stopped where f falls to gap + slack/2, but only if it would go
/// on to fall under the floor, gap - tolerance, within the move: sliding along a face at exactly
/// the gap never does.
///
/// gap 0. Distances cannot tell touching from crossing. But the line t e meets the inside of C
/// exactly if the triangles overlap as seen along e, an exact test for an axis; those that do not,
/// by more than a tolerance, are let pass. For the others the line is in C for t in an interval
/// [enter, leave].
///
/// Along any unit vector n from b to a, f(t) is at least their separation at the start plus t n.e. Where n is a face's
/// normal or an axis that is most often exactly f, and the same for all pairs of two faces: so the way that a pair lets
/// the mesh go is never put below the one on which these bounds keep f at the contact's level. That is what it stops at
/// anyway, and it lets a pair be left out by its bound alone as soon as another one of the same faces has been asked.

#include "geometry/slide.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "geometry/open_leaf.hpp"
#include "geometry/triangle_distance.hpp"

namespace spectralpack {

namespace {

constexpr int kNewtonSteps = 64;   ///< never reached but by noise; any step is a safe place to stop
constexpr double kReached = 1e-8;  ///< mm: at gap 0, a distance that is contact
constexpr double kFree = Box::kInfinity;

/// A box in the move's own axes: `low`, `high` along it (growing in its direction), u and v across.
struct Sweep {
    double low, high, u0, u1, v0, v1;
};

/// Along one axis.
template <int kAxis>
class Slide {
  public:
    Slide(const Bvh& moving, const Vec3& offset, const Bvh& still, int sign, double gap, double at_most,
          std::atomic<double>& free)
        : moving_(moving),
          still_(still),
          offset_(offset),
          sign_(sign),
          touching_(gap == 0),
          gap_(touching_ ? 0 : std::max(gap, kSlideSlack)),
          at_most_(at_most),
          free_(free),
          faces_known_(moving.faces_outwards() && still.faces_outwards()) {}

    void run(const SlidePart& part) {
        if (moving_.nodes().empty() || still_.nodes().empty()) return;
        stack_.push_back(part);
        while (!stack_.empty() && best() > 0) {
            const Pair pair = stack_.back();
            stack_.pop_back();
            if (pair.earliest < best()) visit(pair);
        }
    }

    /// slide_parts(): the tree of node pairs from the root down, level by level.
    std::vector<SlidePart> parts(std::size_t count) {
        std::vector<Pair> result;
        if (!moving_.nodes().empty() && !still_.nodes().empty()) push(pair_of(0, 0));
        std::size_t split = 0;
        for (; split < stack_.size() && result.size() + stack_.size() - split < count; ++split) {
            const Pair pair = stack_[split];
            if (are_leaves(pair)) {
                result.push_back(pair);
            } else {
                visit(pair);
            }
        }
        result.insert(result.end(), stack_.begin() + static_cast<std::ptrdiff_t>(split), stack_.end());
        std::ranges::stable_sort(result, {}, &Pair::earliest);
        return result;
    }

  private:
    using Pair = SlidePart;

    /// The way that is free as far as is known, here or to those who ask about others at the same time.
    double best() const { return std::min(at_most_, free_.load(std::memory_order_relaxed)); }

    /// The distance at which a contact is put.
    double level() const { return gap_ + kSlideSlack / 2; }

    Sweep sweep(const Box& box, const Vec3& offset) const {
        constexpr int u = (kAxis + 1) % 3, v = (kAxis + 2) % 3;
        const double low = box.min[kAxis] + offset[kAxis], high = box.max[kAxis] + offset[kAxis];
        return {sign_ > 0 ? low : -high, sign_ > 0 ? high : -low, box.min[u] + offset[u],
                box.max[u] + offset[u],  box.min[v] + offset[v],  box.max[v] + offset[v]};
    }

    /// When boxes could first be in contact, negative where they may be at the start; infinite when never.
    double earliest(const Sweep& a, const Sweep& b) const {
        const double du = std::max(a.u0 - b.u1, b.u0 - a.u1);
        const double dv = std::max(a.v0 - b.v1, b.v0 - a.v1);
        if (touching_) {
            if (du > -kTouchTolerance || dv > -kTouchTolerance) return Box::kInfinity;
            if (a.low > b.high + kRecovery) return Box::kInfinity;  // gone past
        } else {
            const double across = std::max(du, 0.0) * std::max(du, 0.0) + std::max(dv, 0.0) * std::max(dv, 0.0);
            const double floor = gap_ - kSlideTolerance;
            if (across >= floor * floor || a.low > b.high) return Box::kInfinity;
        }
        return b.low - a.high - level();
    }

    Pair pair_of(std::uint32_t a, std::uint32_t b) const {
        return {a, b, earliest(sweep(moving_.nodes()[a].box(), offset_), sweep(still_.nodes()[b].box(), {}))};
    }

    void push(const Pair& pair) {
        if (pair.earliest < best()) stack_.push_back(pair);
    }

    bool are_leaves(const Pair& pair) const {
        return moving_.nodes()[pair.moving].leaf() && still_.nodes()[pair.still].leaf();
    }

    void visit(const Pair& pair) {
        const Bvh::Node& a = moving_.nodes()[pair.moving];
        const Bvh::Node& b = still_.nodes()[pair.still];
        if (are_leaves(pair)) {
            meet(a, b);
            return;
        }
        const bool split_a = b.leaf() || (!a.leaf() && extent(a.box()) > extent(b.box()));
        Pair one = split_a ? pair_of(pair.moving + 1, pair.still) : pair_of(pair.moving, pair.still + 1);
        Pair two = split_a ? pair_of(a.first, pair.still) : pair_of(pair.moving, b.first);
        if (one.earliest < two.earliest) std::swap(one, two);  // the earlier contact on top
        push(one);
        push(two);
    }

    static double extent(const Box& box) {
        const Vec3 size = box.max - box.min;
        return size.x + size.y + size.z;
    }

    /// Two leaves' triangles, those out of each other's way left out by their boxes.
    void meet(const Bvh::Node& a, const Bvh::Node& b) {
        const auto sweep_of = [&](const Corners& corners) { return sweep(bounding_box(corners), {}); };
        ahead_.open(still_, b, {}, sweep_of);
        leaf_.open(moving_, a, offset_, sweep_of);
        const Sweep all = sweep(b.box(), {});
        for (std::size_t i = 0; i < a.count; ++i) {
            const Corners& one = leaf_.corners(i);
            const Sweep& swept = leaf_.outline(i);
            if (earliest(swept, all) >= best()) continue;
            for (std::size_t j = 0; j < b.count; ++j) {
                const Corners& other = ahead_.corners(j);
                const Sweep& there = ahead_.outline(j);
                const double from = earliest(swept, there);
                const double known = best();
                if (from >= known || parted(one, other, known)) continue;
                const Bound planes = by_planes(one, other);
                if (planes.until >= known || planes.kept) continue;
                const bool apart = planes.apart || there.low - swept.high > kRecovery;
                const double way = touching_ ? touch(one, other, apart) : approach(one, other);
                lower(free_, std::max({from, planes.until, way}));
            }
        }
    }

    ClosestPoints closest(const Corners& a, const Corners& b, double way) const {
        Corners moved = a;
        for (Vec3& corner : moved) {
            corner[kAxis] += sign_ * way;
        }
        return closest_points(moved, b);
    }

    /// At gap 0 surfaces may have passed one another a little already, and then what parts them says nothing.
    double least_separation() const { return touching_ ? kRecovery : level(); }

    /// What the planes of two triangles say.
    struct Bound {
        double until = 0;    ///< no contact before that way
        bool apart = false;  ///< by more than may be passed already
        bool kept = false;   ///< gap > 0: they stay at least as far apart as the floor on all of the way
    };
    Bound by_planes(const Corners& a, const Corners& b) const {
        Bound bound;
        for_each_plane(a, b, [&](const Vec3& from_b, double separation) {
            const double rise = sign_ * from_b[kAxis];
            if (separation > least_separation()) {
                bound.apart = true;
                bound.until = std::max(bound.until, rise < 0 ? (separation - level()) / -rise : kFree);
            }
            const double least = separation + std::min(0.0, rise * at_most_);
            bound.kept |= !touching_ && least >= gap_ - kSlideTolerance / 2;
        });
        return bound;
    }

    /// True when the direction that parted two triangles last keeps these from contact, too, for as far as is known to
    /// be free.
    bool parted(const Corners& a, const Corners& b, double best) const {
        const Vec3& n = parting_;
        const double near = std::min({dot(n, a[0] - b[0]), dot(n, a[1] - b[0]), dot(n, a[2] - b[0])});
        const double far = std::max({0.0, dot(n, b[1] - b[0]), dot(n, b[2] - b[0])});
        const double separation = near - far;
        return separation > least_separation() &&
               separation + std::min(0.0, best * sign_ * n[kAxis]) >= gap_ + 2 * kSlideSlack;
    }

    /// A moment at which f is at most `reached`, before it is under `level` (level < reached), when
    /// going from `way` in steps of sign `heading`; none if f never is before `end`, in that order.
    struct Contact {
        bool found;
        double way;
        Vec3 apart;  ///< where none was found: what shows it, of any length
    };
    Contact first_contact(const Corners& a, const Corners& b, double way, double end, double level, double reached,
                          int heading = 1) const {
        for (int step = 0; step < kNewtonSteps; ++step) {
            const ClosestPoints now = closest(a, b, way);
            if (now.distance <= reached) return {true, way, {}};
            const double slope = heading * sign_ * now.apart()[kAxis] / now.distance;
            if (!(slope < 0)) return {false, way, now.apart()};
            way += heading * (now.distance - level) / -slope;
            if (heading * (end - way) <= 0) return {false, way, now.apart()};
        }
        return {true, way, {}};
    }

    /// gap > 0: how far this pair lets the mesh go, where that is less than best(); or else kFree. What it says depends
    /// on at_most_, never on what is known by now, so that the least of all is the same in any order.
    double approach(const Corners& a, const Corners& b) {
        const Contact stop = stop_at(a, b);
        if (!stop.found) return kFree;
        const double now = closest(a, b, stop.way).distance;
        // The gap's own floor does not sink with repeated moves; that of a pair too near to begin
        // with follows it, a sixteenth for the iteration to end in.
        const double floor = std::min(gap_ - kSlideTolerance, now - kSlideTolerance / 8);
        if (floor <= 0) return 0;
        const Contact fall = first_contact(a, b, stop.way, at_most_, floor, floor + kSlideTolerance / 16);
        return fall.found ? stop.way : kFree;
    }

    /// The first moment at the level of a contact, before best().
    Contact stop_at(const Corners& a, const Corners& b) {
        const Contact stop = first_contact(a, b, 0, best(), level(), gap_ + kSlideSlack);
        if (!stop.found) parting_ = (1 / length(stop.apart)) * stop.apart;
        return stop;
    }

    /// gap 0: likewise. `apart`: it is known that they are.
    double touch(const Corners& a, const Corners& b, bool apart) {
        if (overlap_across(a, b) <= kTouchTolerance) return kFree;
        if (apart) return first_touch(a, b);
        if (closest(a, b, 0).distance > kRecovery) return first_touch(a, b);
        const double far = 1 + size_along(a, b);
        const Contact leave = first_contact(a, b, far, -far, 0, kReached, -1);
        const Contact enter = first_contact(a, b, -far, far, 0, kReached);
        if (!leave.found || !enter.found) return 0;
        const bool flat = enter.way >= -kRecovery && leave.way <= kRecovery;
        if (flat && faces_known_) {
            // Two faces on each other. If a trails with its face and b's looks after it, they part.
            // If they look at each other and have passed, it is overlapping a little already.
            if (facing(a) < 0 && facing(b) > 0) return kFree;
            if (facing(a) > 0 && facing(b) < 0) return enter.way > 0 ? first_touch(a, b) : 0;
        }
        const bool behind = leave.way < -10 * kReached;
        const bool soon_behind = !flat && leave.way <= kRecovery;
        return behind || soon_behind ? kFree : first_touch(a, b);
    }

    double first_touch(const Corners& a, const Corners& b) {
        const Contact stop = stop_at(a, b);
        return stop.found && first_contact(a, b, stop.way, at_most_, 0, kReached).found ? stop.way : kFree;
    }

    double size_along(const Corners& a, const Corners& b) const {
        Box box;
        for (int i = 0; i < 3; ++i) {
            box.add(a[static_cast<std::size_t>(i)]);
            box.add(b[static_cast<std::size_t>(i)]);
        }
        return box.size()[kAxis];
    }

    /// The normal's component in the direction of the move.
    double facing(const Corners& t) const { return sign_ * cross(t[1] - t[0], t[2] - t[0])[kAxis]; }

    /// By how much two triangles overlap as seen along the move: the least way across it that would
    /// part them (negative or 0 when they do not overlap). Of flat polygons, so the directions to
    /// try are the normals of their edges.
    double overlap_across(const Corners& a, const Corners& b) const {
        constexpr int u = (kAxis + 1) % 3, v = (kAxis + 2) % 3;
        double least = Box::kInfinity;
        for (const Corners* t : {&a, &b}) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 edge = (*t)[(i + 1) % 3] - (*t)[i];
                const double length = std::sqrt(edge[u] * edge[u] + edge[v] * edge[v]);
                if (!(length > 0)) continue;
                const double nu = -edge[v] / length, nv = edge[u] / length;
                double a0 = Box::kInfinity, a1 = -a0, b0 = a0, b1 = -a0;
                for (std::size_t k = 0; k < 3; ++k) {
                    // From a corner of a, so that rounding is that of the triangles' sizes.
                    const Vec3 pa = a[k] - a[0], pb = b[k] - a[0];
                    const double ha = nu * pa[u] + nv * pa[v], hb = nu * pb[u] + nv * pb[v];
                    a0 = std::min(a0, ha), a1 = std::max(a1, ha);
                    b0 = std::min(b0, hb), b1 = std::max(b1, hb);
                }
                least = std::min({least, a1 - b0, b1 - a0});
            }
        }
        return std::isfinite(least) ? least : 0;
    }

    const Bvh& moving_;
    const Bvh& still_;
    Vec3 offset_;
    int sign_;
    bool touching_;
    double gap_;
    double at_most_;
    std::atomic<double>& free_;
    bool faces_known_;
    std::vector<Pair> stack_;
    OpenLeaf<Sweep> leaf_, ahead_;
    Vec3 parting_;  ///< of length 1 (at first 0), from b to a
};

/// Calls of<axis>().
template <class Of>
auto along(int axis, const Of& of) {
    switch (axis) {
        case 0:
            return of.template operator()<0>();
        case 1:
            return of.template operator()<1>();
        default:
            return of.template operator()<2>();
    }
}

}  // namespace

void slide(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double gap, double at_most,
           std::atomic<double>& free, const SlidePart& part) {
    along(direction.axis,
          [&]<int kAxis>() { Slide<kAxis>(moving, offset, still, direction.sign, gap, at_most, free).run(part); });
}

std::vector<SlidePart> slide_parts(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction,
                                   double gap, double at_most, std::size_t count) {
    std::atomic<double> free = at_most;
    return along(direction.axis, [&]<int kAxis>() {
        return Slide<kAxis>(moving, offset, still, direction.sign, gap, at_most, free).parts(count);
    });
}

}  // namespace spectralpack
