#include "verify/nearness.hpp"

#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/traversal_recurse.h>

#include <algorithm>

namespace spectralpack {
namespace {

/// FCL's bounds of the distance of two volumes may be too large by their rounding, which for almost parallel ones
/// is about 1e-7 of their size.
constexpr double kRoom = 1e-4;  ///< mm

/// Triangles nearer than this may cross.
constexpr double kMeeting = 1e-9;  ///< mm

class Search : public fcl::detail::MeshDistanceTraversalNodeRSS<double> {
  public:
    Search(const Solid& a, const Solid& b, const Transform& b_to_a, double reach, double bound, double tolerance)
        : a_(a), b_(b), b_to_a_(b_to_a), reach_(reach), tolerance_(tolerance) {
        model1 = a.hierarchy();
        model2 = b.hierarchy();
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                tf.linear()(row, column) = b_to_a.linear.rows[row][column];
            }
            tf.translation()[row] = b_to_a.translation[row];
        }
        found_.distance = bound;
    }

    Nearness run() {
        fcl::detail::distanceRecurse<double>(this, 0, 0, nullptr);
        return std::move(found_);
    }

  private:
    bool canStop(double lower_bound) const override {
        return found_.crossing > tolerance_ || lower_bound - kRoom > std::max(found_.distance, reach_);
    }

    void leafTesting(int node_a, int node_b) const override {
        const Contact contact{a_.triangle(model1->getBV(node_a).primitiveId()),
                              b_.triangle(model2->getBV(node_b).primitiveId())};
        const Corners on_a = a_.corners(contact.a);
        Corners on_b = b_.corners(contact.b);
        for (Vec3& corner : on_b) {
            corner = b_to_a_ * corner;
        }
        const double distance = triangle_distance(on_a, on_b, std::max(found_.distance, reach_));
        found_.distance = std::min(found_.distance, distance);
        if (distance > reach_) return;
        found_.contacts.push_back(contact);
        if (distance < kMeeting) {
            found_.crossing = std::max(found_.crossing, crossing_depth(on_a, on_b));
        }
    }

    const Solid& a_;
    const Solid& b_;
    const Transform b_to_a_;
    const double reach_, tolerance_;
    mutable Nearness found_;  // FCL's tests are const
};

}  // namespace

Nearness find_nearness(const Solid& a, const Solid& b, const Transform& b_to_a, double reach, double bound,
                       double tolerance) {
    if (!a.hierarchy() || !b.hierarchy()) return {bound, 0, {}};
    return Search(a, b, b_to_a, reach, bound, tolerance).run();
}

}  // namespace spectralpack
