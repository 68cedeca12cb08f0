#pragma once
/// Faces with any number of corners, as OBJ, PLY and OFF have them, and their triangles.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// Triangles of the polygon `loop` (vertex indices), keeping its direction. A convex one becomes a
/// fan; others lose ears one by one, so that a concave face is not filled beyond its outline: O(n *
/// reflex corners). The polygon may be slightly out of plane, and may touch itself, as one with a
/// hole does that is joined to the outline by a cut. Returns false for a concave polygon of more
/// than kMostConcaveCorners corners.
bool triangulate(const std::vector<Vec3>& vertices, std::span<const std::uint32_t> loop,
                 std::vector<Triangle>& triangles);

inline constexpr std::size_t kMostConcaveCorners = 4096;

/// Collects faces; indices are checked when all vertices are known.
class PolygonFaces {
  public:
    void reserve(std::size_t faces);

    /// `place` tells where in the file the face is (a line or a number), for messages.
    void add(std::span<const std::int64_t> corners, std::uint32_t place);

    /// Triangles of all faces over `vertices`. Calls fail(place, cause), which must throw, for an
    /// index out of range and for a face of fewer than three corners. Throws Stopped once `stop` is requested.
    std::vector<Triangle> triangles(const std::vector<Vec3>& vertices,
                                    const std::function<void(std::uint32_t, const std::string&)>& fail,
                                    const StopToken& stop = {}) const;

  private:
    struct Face {
        std::size_t end;  ///< of its corners in corners_
        std::uint32_t place;
    };
    std::vector<std::int64_t> corners_;
    std::vector<Face> faces_;
};

}  // namespace spectralpack
