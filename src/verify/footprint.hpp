#pragma once
/// Which part of a triangle has nothing of another surface near it. The triangle's plane is cut up: what lies near
/// a triangle of the other surface (its footprint) is taken out, and what is left is a few convex pieces.

#include <optional>
#include <vector>

#include "verify/triangle_pair.hpp"

namespace spectralpack {

struct Point2 {
    double x = 0, y = 0;
};

/// A convex polygon, counter-clockwise.
struct Polygon {
    std::vector<Point2> corners;
    Point2 low, high;  ///< its box

    bool empty() const { return corners.empty(); }
    Point2 centre() const;  ///< mean of the corners: inside
};

/// Plane coordinates on a triangle.
class PlaneFrame {
  public:
    /// Precondition: least_height(triangle) > 0.
    explicit PlaneFrame(const Corners& triangle);

    Point2 to_plane(const Vec3& point) const;
    Vec3 to_space(const Point2& point) const;
    double height(const Vec3& point) const;

  private:
    Vec3 origin_, x_axis_, y_axis_, normal_;
};

Polygon in_plane(const PlaneFrame& frame, const Corners& triangle_of_frame);

/// A convex polygon that contains every point of the plane within `reach` of the triangle, and none farther from it
/// than sqrt(3) reach. Empty where there is no such point.
Polygon footprint(const PlaneFrame& frame, const Corners& triangle, double reach);

/// `polygon` less all footprints, in convex pieces that do not overlap. Slivers narrower than about 1e-7 are left out.
std::vector<Polygon> free_pieces(const Polygon& polygon, const std::vector<Polygon>& footprints);

/// True if the segment meets none of the footprints (it may run along one).
bool clear_path(const Point2& from, const Point2& to, const std::vector<Polygon>& footprints);

}  // namespace spectralpack
