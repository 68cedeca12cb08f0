#include "geometry/slides_past.hpp"

#include <utility>
#include <vector>

#include "geometry/meeting_interval.hpp"

namespace spectralpack {
namespace {

constexpr double kBehind = 1e-7;  // mm by which a meeting must be over to count as that

/// A box in the move's axes.
struct SeenBox {
    double low, high, u0, u1, v0, v1;
};

class Passage {
  public:
    Passage(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double graze, double way)
        : moving_(moving),
          still_(still),
          offset_(offset),
          direction_(direction),
          graze_(graze),
          end_(way - kSlideSlack),
          faces_known_(moving.faces_outwards() && still.faces_outwards()) {}

    bool free() {
        if (moving_.nodes().empty() || still_.nodes().empty() || !(end_ > 0)) return true;
        push(0, 0);
        while (!stack_.empty()) {
            const auto [i, j] = stack_.back();
            stack_.pop_back();
            const Bvh::Node &a = moving_.nodes()[i], &b = still_.nodes()[j];
            if (a.leaf() && b.leaf()) {
                if (leaves_meet(a, b)) return false;
            } else if (b.leaf() || (!a.leaf() && extent(a.box()) > extent(b.box()))) {
                push(i + 1, j);
                push(a.first, j);
            } else {
                push(i, j + 1);
                push(i, b.first);
            }
        }
        return true;
    }

  private:
    static double extent(const Box& box) {
        const Vec3 size = box.max - box.min;
        return size.x + size.y + size.z;
    }

    SeenBox seen(const Box& box, const Vec3& offset) const {
        const int axis = direction_.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double low = box.min[axis] + offset[axis], high = box.max[axis] + offset[axis];
        return {direction_.sign > 0 ? low : -high,
                direction_.sign > 0 ? high : -low,
                box.min[u] + offset[u],
                box.max[u] + offset[u],
                box.min[v] + offset[v],
                box.max[v] + offset[v]};
    }

    /// Nothing of a meets anything of b on the way, by their boxes.
    template <class A, class B>
    bool apart(const A& a, const B& b) const {
        return b.u1 - a.u0 <= graze_ || a.u1 - b.u0 <= graze_ || b.v1 - a.v0 <= graze_ || a.v1 - b.v0 <= graze_ ||
               b.high - a.low < -kRecovery || b.low - a.high >= end_;
    }

    void push(std::uint32_t i, std::uint32_t j) {
        if (!apart(seen(moving_.nodes()[i].box(), offset_), seen(still_.nodes()[j].box(), {})))
            stack_.emplace_back(i, j);
    }

    bool leaves_meet(const Bvh::Node& a, const Bvh::Node& b) const {
        const SeenBox box = seen(b.box(), {});
        std::array<SeenTriangle, Bvh::kLeafTriangles> ahead;
        std::size_t made = 0;
        for (std::size_t i = a.first; i < a.first + a.count; ++i) {
            const SeenTriangle one(moving_.corners(i), offset_, direction_);
            if (apart(one, box)) continue;
            for (std::size_t j = 0; j < b.count; ++j) {
                if (j == made) ahead[made++].see(still_.corners(b.first + j), {}, direction_);
                if (!apart(one, ahead[j]) && meet(one, ahead[j])) return true;
            }
        }
        return false;
    }

    bool meet(const SeenTriangle& a, const SeenTriangle& b) const {
        if (!shadows_overlap(a, b, graze_)) return false;
        if (b.low - a.high > kRecovery && b.high - a.low < end_) return true;
        const auto [enter, leave] = meeting_interval(a, b);
        if (enter >= end_) return false;
        const bool flat = enter >= -kRecovery && leave <= kRecovery;
        if (flat && faces_known_) {
            // Two faces on each other. If a trails with its face and b's looks after it, they part. If they look at
            // each other and have passed, the solids overlap a little already.
            if (a.facing() < 0 && b.facing() > 0) return false;
            if (a.facing() > 0 && b.facing() < 0) return true;
        }
        const bool leaving = !flat && leave <= kRecovery;
        return leave >= -kBehind && !leaving;
    }

    const Bvh& moving_;
    const Bvh& still_;
    Vec3 offset_;
    AxisDirection direction_;
    double graze_;
    double end_;  ///< meetings from here on are beyond the way
    bool faces_known_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack_;
};

}  // namespace

bool slides_past(const Bvh& moving, const Vec3& offset, const Bvh& still, AxisDirection direction, double graze,
                 double way) {
    return Passage(moving, offset, still, direction, graze, way).free();
}

}  // namespace spectralpack
