#include "geometry/mesh_bodies.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/bvh.hpp"
#include "geometry/mesh_distance.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_shells.hpp"

namespace spectralpack {
namespace {

using Index = std::uint32_t;

/// The triangles of each group, with their vertices only.
std::vector<Mesh> parted(const Mesh& mesh, const std::vector<Index>& group_of_triangle, std::size_t groups) {
    constexpr Index kUnused = std::numeric_limits<Index>::max();
    std::vector<std::vector<Index>> triangles(groups);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        triangles[group_of_triangle[i]].push_back(static_cast<Index>(i));
    }
    std::vector<Index> number(mesh.vertices.size(), kUnused);
    std::vector<Mesh> parts(groups);
    for (std::size_t group = 0; group < groups; ++group) {
        Mesh& part = parts[group];
        std::vector<Index> used;
        for (const Index i : triangles[group]) {
            Triangle triangle = mesh.triangles[i];
            for (Index& vertex : triangle) {
                if (number[vertex] == kUnused) {
                    number[vertex] = static_cast<Index>(part.vertices.size());
                    part.vertices.push_back(mesh.vertices[vertex]);
                    used.push_back(vertex);
                }
                vertex = number[vertex];
            }
            part.triangles.push_back(triangle);
        }
        for (const Index vertex : used) {
            number[vertex] = kUnused;
        }
    }
    return parts;
}

bool within(const Mesh& inner, const Mesh& outer) {
    return std::abs(winding_number(outer, inner.vertices.front())) > 0.5;
}

}  // namespace

std::vector<Mesh> bodies_of(const Mesh& mesh) {
    if (mesh.triangles.empty()) return {};
    const ShellGroups groups = shell_groups(mesh, MeshEdges(mesh));
    if (groups.shells.size() == 1) return {mesh};
    const std::vector<Mesh> shells = parted(mesh, groups.shell_of_facet, groups.shells.size());
    std::vector<Bvh> trees;
    for (const Mesh& shell : shells) {
        trees.emplace_back(shell);
    }
    std::vector<Index> body(shells.size());
    std::iota(body.begin(), body.end(), Index{0});
    constexpr double kTouching = 1e-9;  // mm
    for (std::size_t a = 0; a < shells.size(); ++a) {
        for (std::size_t b = a + 1; b < shells.size(); ++b) {
            if (body[a] == body[b] || !meet(groups.shells[a].box, groups.shells[b].box)) continue;
            if (least_distance(trees[a], {}, trees[b], {}, kTouching).distance >= kTouching &&
                !within(shells[a], shells[b]) && !within(shells[b], shells[a])) {
                continue;
            }
            const Index kept = std::min(body[a], body[b]), merged = std::max(body[a], body[b]);
            for (Index& of_shell : body) {
                if (of_shell == merged) of_shell = kept;
            }
        }
    }
    std::vector<Index> number(shells.size(), 0);
    Index bodies = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        number[i] = body[i] == i ? bodies++ : number[body[i]];
    }
    std::vector<Index> body_of_triangle;
    for (const Index shell : groups.shell_of_facet) {
        body_of_triangle.push_back(number[shell]);
    }
    return parted(mesh, body_of_triangle, bodies);
}

}  // namespace spectralpack
