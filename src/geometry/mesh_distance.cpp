#include "geometry/mesh_distance.hpp"

#include <vector>

#include "geometry/open_leaf.hpp"

namespace spectralpack {

namespace {

Box moved(const Box& box, const Vec3& by) { return {box.min + by, box.max + by}; }

double extent(const Box& box) {
    const Vec3 size = box.max - box.min;
    return size.x + size.y + size.z;
}

class Search {
  public:
    /// `offset`: of a as seen from b.
    Search(const Bvh& a, const Bvh& b, const Vec3& offset, double upper_bound) : a_(a), b_(b), offset_(offset) {
        best_.distance = upper_bound;
    }

    ClosestPoints run() {
        if (!a_.nodes().empty() && !b_.nodes().empty()) push(0, 0);
        while (!stack_.empty()) {
            const Pair pair = stack_.back();
            stack_.pop_back();
            if (pair.square < best_.distance * best_.distance) visit(pair);
        }
        return best_;
    }

  private:
    struct Pair {
        std::uint32_t a, b;
        double square;  ///< of the boxes' distance
    };

    Pair pair_of(std::uint32_t a, std::uint32_t b) const {
        return {a, b, square_distance(moved(a_.nodes()[a].box(), offset_), b_.nodes()[b].box())};
    }

    void push(std::uint32_t a, std::uint32_t b) { stack_.push_back(pair_of(a, b)); }

    void visit(const Pair& pair) {
        const Bvh::Node& a = a_.nodes()[pair.a];
        const Bvh::Node& b = b_.nodes()[pair.b];
        if (a.leaf() && b.leaf()) {
            compare(a, b);
            return;
        }
        const bool split_a = b.leaf() || (!a.leaf() && extent(a.box()) > extent(b.box()));
        Pair one = split_a ? pair_of(pair.a + 1, pair.b) : pair_of(pair.a, pair.b + 1);
        Pair two = split_a ? pair_of(a.first, pair.b) : pair_of(pair.a, b.first);
        if (one.square < two.square) std::swap(one, two);  // the nearer on top
        const double square = best_.distance * best_.distance;
        if (one.square < square) stack_.push_back(one);
        if (two.square < square) stack_.push_back(two);
    }

    /// Two leaves' triangles, those too far apart left out by their boxes.
    void compare(const Bvh::Node& a, const Bvh::Node& b) {
        const auto box_of = [](const Corners& corners) { return bounding_box(corners); };
        leaf_a_.open(a_, a, offset_, box_of);
        leaf_b_.open(b_, b, {}, box_of);
        for (std::size_t i = 0; i < a.count; ++i) {
            const Box& box = leaf_a_.outline(i);
            if (square_distance(box, b.box()) >= best_.distance * best_.distance) continue;
            for (std::size_t j = 0; j < b.count; ++j) {
                if (square_distance(box, leaf_b_.outline(j)) >= best_.distance * best_.distance) continue;
                if (plane_separation(leaf_a_.corners(i), leaf_b_.corners(j)) >= best_.distance) continue;
                const ClosestPoints found = closest_points(leaf_a_.corners(i), leaf_b_.corners(j));
                if (found.distance < best_.distance) best_ = found;
            }
        }
    }

    const Bvh& a_;
    const Bvh& b_;
    Vec3 offset_;
    ClosestPoints best_;
    std::vector<Pair> stack_;
    OpenLeaf<Box> leaf_a_, leaf_b_;
};

}  // namespace

ClosestPoints least_distance(const Bvh& a, const Vec3& offset_a, const Bvh& b, const Vec3& offset_b,
                             double upper_bound) {
    ClosestPoints found = Search(a, b, offset_a - offset_b, upper_bound).run();
    if (found.distance < upper_bound) {
        found.a = found.a + offset_b;
        found.b = found.b + offset_b;
    }
    return found;
}

}  // namespace spectralpack
