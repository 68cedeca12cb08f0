#pragma once
/// How far a triangle is from a voxel.

#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// The cubes that are nearer to a triangle than `distance` > 0: of many, what does not depend on the cube is worked out
/// once.
class NearCubes {
  public:
    NearCubes(const GridTriangle& triangle, double distance);

    /// Whether some point of the triangle is nearer than that to the closed unit cube around `centre`. Exact but for
    /// rounding; cheap where the triangle is clearly near or far.
    bool contain(const Vec3& centre) const;

  private:
    Vec3 nearest_from(const Vec3& point) const;

    GridTriangle triangle_;
    double distance_;
    Vec3 ab_, ac_;  // edges
    double ab_ab_, ab_ac_, ac_ac_;
};

/// Square of the Euclidean distance between the closed unit cube around the origin and the
/// triangle, 0 where they meet.
double squared_box_distance(const GridTriangle& triangle);

}  // namespace spectralpack
