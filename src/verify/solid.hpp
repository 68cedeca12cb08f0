#pragma once
/// One mesh in millimetres, prepared for questions: FCL's hierarchy over its triangles, its shells, and
/// what is inside it. Made once per mesh and scale, shared by all copies; constant and safe to ask from any thread.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/RSS.h>

#include <optional>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "verify/triangle_pair.hpp"

namespace spectralpack {

/// Rectangles swept by spheres: half the memory of FCL's OBBRSS, of which distances use only this half.
using Hierarchy = fcl::BVHModel<fcl::RSS<double>>;

class Solid {
  public:
    /// What hangs together by vertices.
    struct Shell {
        Vec3 corner;                     ///< one of its vertices
        std::optional<Vec3> deep_point;  ///< a point at least `depth` inside the material; none in open meshes
    };

    /// Applies `transform` to the mesh; `depth` as in Shell, mm. Precondition: the mesh has triangles.
    Solid(const Mesh& mesh, const Transform& transform, double depth);

    const Mesh& mesh() const { return mesh_; }  ///< welded by equal coordinates
    const Box& box() const { return box_; }
    /// Encloses material: points of non-zero winding number. An open mesh has no inside.
    bool closed() const { return closed_; }
    const std::vector<Shell>& shells() const { return shells_; }
    std::size_t shell_of(std::size_t triangle) const { return shell_of_[triangle]; }
    Corners corners(std::size_t triangle) const;

    /// How often the surface goes round the point: signed crossings of a ray, in a direction that comes nowhere near
    /// an edge. Exact for points at least 1e-6 off the surface of a closed mesh. 0 outside the box.
    int winding(const Vec3& point) const;

    /// Distance from a point to the surface.
    double surface_distance(const Vec3& point) const;

    /// Half way from the triangle's back to what lies behind it, somewhere near its middle; none for needles, and
    /// where nothing does.
    std::optional<Vec3> middle_behind(std::size_t triangle) const;

    /// Over the triangles that are no needles; none if all are. All points of a needle are next to its longest
    /// edge, which a neighbour has too.
    const Hierarchy* hierarchy() const { return hierarchy_ ? &*hierarchy_ : nullptr; }
    /// A triangle's index in mesh(), by its index in the hierarchy.
    std::size_t triangle(int primitive) const { return kept_[static_cast<std::size_t>(primitive)]; }

  private:
    void find_shells();
    void find_deep_points(double depth);

    Mesh mesh_;
    Box box_;
    bool closed_ = false;
    std::vector<Shell> shells_;
    std::vector<std::size_t> shell_of_;  ///< by triangle
    std::vector<std::size_t> kept_;      ///< triangles in the hierarchy
    std::optional<Hierarchy> hierarchy_;
};

}  // namespace spectralpack
