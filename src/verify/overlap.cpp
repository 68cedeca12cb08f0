#include "verify/overlap.hpp"

#include <algorithm>
#include <optional>

#include "verify/footprint.hpp"
#include "verify/nearness.hpp"

namespace spectralpack {
namespace {

/// Footprints reach as far as sqrt(3) tolerances: what is beyond this contact reach has none.
constexpr double kReach = 1.8;
/// With more footprints than this on a triangle a ray is cheaper than looking for a clear path.
constexpr std::size_t kManyFootprints = 24;
constexpr std::size_t kDepthSamples = 256;

Transform inverse(const Transform& rotation) {
    const Mat3 back = transposed(rotation.linear);
    return {back, -(back * rotation.translation)};
}

Corners moved(const Corners& corners, const Transform& transform) {
    return {transform * corners[0], transform * corners[1], transform * corners[2]};
}

/// One solid's surface seen from another: asks whether any of it lies in the other's material.
class SurfaceInside {
  public:
    SurfaceInside(const Solid& inner, const Solid& outer, const Transform& to_outer, double tolerance)
        : inner_(inner),
          outer_(outer),
          to_outer_(to_outer),
          tolerance_(tolerance),
          clear_(inner.mesh().vertices.size(), false) {}

    bool point_inside(const Vec3& of_inner) const {
        return outer_.closed() && outer_.winding(to_outer_ * of_inner) != 0;
    }

    bool any_deep_point() const {
        return std::any_of(inner_.shells().begin(), inner_.shells().end(),
                           [&](const auto& shell) { return shell.deep_point && point_inside(*shell.deep_point); });
    }

    /// How many of the shells of which no triangle is in contact lie inside.
    std::size_t shells_inside(const std::vector<bool>& in_contact) const {
        std::size_t inside = 0;
        for (std::size_t i = 0; i < inner_.shells().size(); ++i) {
            if (!in_contact[i] && point_inside(inner_.shells()[i].corner)) ++inside;
        }
        return inside;
    }

    /// `near`: the outer solid's triangles near this one. Looks at every piece of it that has none near it.
    bool any_piece_inside(std::size_t triangle, const std::vector<std::size_t>& near) {
        const Corners corners = moved(inner_.corners(triangle), to_outer_);
        if (!outer_.closed() || !reaches_in(corners)) return false;
        const PlaneFrame frame(corners);
        std::vector<Polygon> footprints;
        for (const std::size_t other : near) {
            Polygon print = footprint(frame, outer_.corners(other), tolerance_);
            if (!print.empty()) footprints.push_back(std::move(print));
        }
        // Points of this triangle that are known to lie outside decide for all that are in their sight.
        std::vector<Point2> outside;
        const auto sees_outside = [&](const Point2& point) {
            return footprints.size() <= kManyFootprints &&
                   std::any_of(outside.begin(), outside.end(),
                               [&](const Point2& known) { return clear_path(point, known, footprints); });
        };
        const Triangle& vertices = inner_.mesh().triangles[triangle];
        for (int i = 0; i < 3; ++i) {
            if (clear_[vertices[i]]) outside.push_back(frame.to_plane(corners[i]));
        }
        for (const Polygon& piece : free_pieces(in_plane(frame, corners), footprints)) {
            const Point2 centre = piece.centre();
            if (sees_outside(centre)) continue;
            if (outer_.winding(frame.to_space(centre)) != 0) return true;
            outside.push_back(centre);
        }
        for (int i = 0; i < 3; ++i) {
            if (!clear_[vertices[i]]) clear_[vertices[i]] = sees_outside(frame.to_plane(corners[i]));
        }
        return false;
    }

    /// The greatest depth among a sample of shared points: corners and middles of triangles, and middles of the
    /// material behind them.
    double deepest() const {
        if (!outer_.closed()) return 0;
        double depth = 0;
        const auto look = [&](const Vec3& of_inner, bool on_surface) {
            const Vec3 point = to_outer_ * of_inner;
            if (outer_.winding(point) == 0) return;
            depth = std::max(depth, outer_.surface_distance(point));
            if (!on_surface) depth = std::max(depth, inner_.surface_distance(of_inner));
        };
        const auto& vertices = inner_.mesh().vertices;
        for (std::size_t i = 0; i < vertices.size(); i += 1 + vertices.size() / kDepthSamples) {
            look(vertices[i], true);
        }
        const std::size_t count = inner_.mesh().triangles.size();
        for (std::size_t i = 0; i < count; i += 1 + count / kDepthSamples) {
            const Corners c = inner_.corners(i);
            look((1 / 3.0) * (c[0] + c[1] + c[2]), true);
            const std::optional<Vec3> behind = inner_.middle_behind(i);
            if (behind && inner_.winding(*behind) != 0) look(*behind, false);
        }
        for (const Solid::Shell& shell : inner_.shells()) {
            if (shell.deep_point) look(*shell.deep_point, false);
        }
        return depth;
    }

  private:
    /// Some of the triangle may lie deeper than the tolerance in the outer solid's box.
    bool reaches_in(const Corners& corners) const {
        Box box;
        for (const Vec3& corner : corners) {
            box.add(corner);
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (box.max[axis] <= outer_.box().min[axis] + tolerance_ ||
                box.min[axis] >= outer_.box().max[axis] - tolerance_) {
                return false;
            }
        }
        return true;
    }

    const Solid& inner_;
    const Solid& outer_;
    const Transform to_outer_;
    const double tolerance_;
    std::vector<bool> clear_;  ///< by vertex: farther than the tolerance from the other surface, and outside
};

/// `contacts` sorted by `self`: calls visit(triangle, its near ones) until that returns true.
template <class Visit>
bool any_in_contact(std::vector<Contact> contacts, std::size_t Contact::*self, std::size_t Contact::*other,
                    Visit visit) {
    std::sort(contacts.begin(), contacts.end(), [&](const Contact& x, const Contact& y) {
        return x.*self != y.*self ? x.*self < y.*self : x.*other < y.*other;
    });
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        near.push_back(contacts[i].*other);
        if (i + 1 < contacts.size() && contacts[i + 1].*self == contacts[i].*self) continue;
        if (visit(contacts[i].*self, near)) return true;
        near.clear();
    }
    return false;
}

std::vector<bool> shells_in_contact(const Solid& solid, const std::vector<Contact>& contacts,
                                    std::size_t Contact::*self) {
    std::vector<bool> touched(solid.shells().size(), false);
    for (const Contact& contact : contacts) {
        touched[solid.shell_of(contact.*self)] = true;
    }
    return touched;
}

}  // namespace

Relation compare(const PosedSolid& posed_a, const PosedSolid& posed_b, double tolerance, double bound) {
    using Kind = Relation::Kind;
    const Solid& a = *posed_a.solid;
    const Solid& b = *posed_b.solid;
    const Transform b_to_a = inverse(posed_a.pose) * posed_b.pose;
    const Nearness near = find_nearness(a, b, b_to_a, kReach * tolerance, bound, tolerance);
    SurfaceInside a_in_b(a, b, inverse(b_to_a), tolerance), b_in_a(b, a, b_to_a, tolerance);

    const auto shared = [&](Kind kind) {
        // The search may have ended at its first crossing; how bad it is takes all of them.
        const Nearness all = find_nearness(a, b, b_to_a, 0, 0, Box::kInfinity);
        return Relation{kind, 0, std::max({all.crossing, a_in_b.deepest(), b_in_a.deepest()})};
    };
    if (near.crossing > tolerance) return shared(Kind::overlap);

    const std::size_t a_shells = a_in_b.shells_inside(shells_in_contact(a, near.contacts, &Contact::a));
    const std::size_t b_shells = b_in_a.shells_inside(shells_in_contact(b, near.contacts, &Contact::b));
    if (near.contacts.empty()) {
        if (a_shells == a.shells().size()) return shared(Kind::a_within_b);
        if (b_shells == b.shells().size()) return shared(Kind::b_within_a);
    }
    if (a_shells + b_shells > 0) return shared(Kind::overlap);
    if (near.contacts.empty()) return {Kind::apart, near.distance, 0};

    if (a_in_b.any_deep_point() || b_in_a.any_deep_point()) return shared(Kind::overlap);
    const bool inside = any_in_contact(near.contacts, &Contact::a, &Contact::b,
                                       [&](std::size_t triangle, const std::vector<std::size_t>& others) {
                                           return a_in_b.any_piece_inside(triangle, others);
                                       }) ||
                        any_in_contact(near.contacts, &Contact::b, &Contact::a,
                                       [&](std::size_t triangle, const std::vector<std::size_t>& others) {
                                           return b_in_a.any_piece_inside(triangle, others);
                                       });
    if (inside) return shared(Kind::overlap);
    return {Kind::apart, near.distance, 0};
}

}  // namespace spectralpack
