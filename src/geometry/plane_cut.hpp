#pragma once
/// Cutting a closed mesh in two by a plane.

#include <optional>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct Plane {
    Vec3 normal{0, 0, 1};  ///< of length 1
    double offset = 0;     ///< of the plane's points along the normal
};

/// The offset in [low, high] next to `wanted` at which a plane keeps clear of the mesh's vertices, so that a cut there
/// leaves no slivers: `wanted` itself where no vertex is within a thousandth of a millimetre of it, else the middle of
/// the widest stretch without vertices. None where every such stretch is too narrow to be written in single precision.
std::optional<double> clear_offset(const Mesh& mesh, const Vec3& normal, double wanted, double low, double high);

struct CutMesh {
    Mesh below, above;  ///< along the normal; empty where there is nothing
    double area = 0;    ///< of the cut face, mm^2
};

/// Both sides of the plane, each closed by the same triangles in the plane. Precondition: the mesh is closed
/// (is_closed()); then both sides are, and their volumes add up to the mesh's but for rounding, also where it crosses
/// itself. What lies in the plane counts as above it: whole facets there leave a sheet. O(n) and the square of the
/// points in the plane.
CutMesh cut_mesh(const Mesh& mesh, const Plane& plane);

}  // namespace spectralpack
