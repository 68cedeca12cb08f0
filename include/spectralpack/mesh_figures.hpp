#pragma once
/// What a mesh is, and what is wrong with it, in figures. Nothing is changed. Lengths are in the mesh's own unit.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack {

/// How the edges of a mesh are used.
struct EdgeCount {
    std::size_t border = 0;       ///< of one triangle, or of an odd number
    std::size_t misdirected = 0;  ///< of two triangles that walk it the same way
    std::size_t crowded = 0;      ///< of more than two triangles
    bool closed = false;          ///< every edge is walked as often one way as the other
};

/// A hole: border edges that make a ring. Edges of an odd number of triangles always do.
struct BorderLoop {
    Vec3 place;  ///< one of its vertices
    double length = 0;
    std::size_t edges = 0;
};

struct SelfCrossings {
    std::int64_t pairs = 0;     ///< of triangles that cross properly: touching is not crossing
    bool complete = true;       ///< false: the search ended early, there may be more
    std::optional<Vec3> place;  ///< of one of them
};

struct MeshFigures {
    static constexpr std::size_t kMostListed = 16;

    Box box;
    double volume = 0;  ///< signed
    double area = 0;
    std::size_t triangles = 0;
    std::size_t vertices = 0;
    std::size_t shells = 0;  ///< parts that hang together by edges
    EdgeCount edges;
    std::size_t border_loops = 0;
    std::vector<BorderLoop> holes;          ///< the longest border loops, longest first
    std::optional<Vec3> crowded_place;      ///< of an edge of more than two triangles
    std::optional<Vec3> misdirected_place;  ///< of an edge that both of its triangles walk the same way
    std::size_t duplicates = 0;             ///< triangles on the same three vertices as an earlier one
    SelfCrossings crossings;

    bool watertight() const { return edges.closed; }
};

/// About O(n log n). Preconditions: indices in range, finite coordinates, equal points are one vertex.
MeshFigures inspect_mesh(const Mesh& mesh);

}  // namespace spectralpack
