#pragma once
/// Shells: parts of a mesh that hang together by edges. Which way round their facets are.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh_edges.hpp"
#include "spectralpack/mesh.hpp"

namespace spectralpack {

struct Shell {
    Box box;
    double volume = 0;  ///< signed
    std::uint32_t group = 0;
};

/// Turns facets so that any two that share an edge alone agree; in each shell the fewer are turned.
/// Returns how many were; 0 and an unchanged mesh where none need be or where no choice agrees (a
/// Moebius strip).
std::size_t orient_consistently(Mesh& mesh, const MeshEdges& edges);

/// Shells whose boxes meet form a group. Groups share no space, so which way round one is says
/// nothing of another.
struct ShellGroups {
    std::vector<Shell> shells;  ///< in order of their first facets
    std::vector<std::uint32_t> shell_of_facet;
    std::vector<double> volume;  ///< signed, of each group
};

/// Volumes mean something only where the mesh is closed. Stops with the edges.
ShellGroups shell_groups(const Mesh& mesh, const MeshEdges& edges);

/// Turns the groups of negative volume. Returns the number of facets turned.
std::size_t turn_outwards(Mesh& mesh, const ShellGroups& groups);

/// Whether solid shells reach into one another, or cavities out of the matter around them, so that
/// the signed volume counts some space twice. By winding numbers at a few vertices of each shell:
/// what it finds is so, what it does not find may still be.
bool shells_overlap(const Mesh& mesh, const ShellGroups& groups);

/// How often a closed mesh winds round a point, but for rounding; a fraction on its surface. O(n).
double winding_number(const Mesh& mesh, const Vec3& point);

}  // namespace spectralpack
