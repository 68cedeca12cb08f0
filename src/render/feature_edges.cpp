#include "render/feature_edges.hpp"

#include "geometry/mesh_edges.hpp"

namespace spectralpack {
namespace {

constexpr double kFlat = 0.866;  // cosine of 30 degrees

Vec3 normal(const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    const Vec3 up = cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double size = length(up);
    return size > 0 ? 1 / size * up : Vec3{};
}

}  // namespace

std::vector<std::pair<Vec3, Vec3>> feature_edges(const Mesh& mesh) {
    std::vector<std::pair<Vec3, Vec3>> edges;
    MeshEdges(mesh).for_each([&](std::uint32_t low, std::span<const MeshEdges::Use> uses) {
        const bool bend =
            uses.size() != 2 || dot(normal(mesh, uses[0].triangle()), normal(mesh, uses[1].triangle())) < kFlat;
        if (bend) edges.emplace_back(mesh.vertices[low], mesh.vertices[uses[0].high]);
    });
    return edges;
}

}  // namespace spectralpack
