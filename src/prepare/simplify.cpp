#include "prepare/simplify.hpp"

#include <meshoptimizer.h>

#include "geometry/mesh_weld.hpp"

namespace spectralpack {

Mesh simplified(const Mesh& mesh, std::size_t triangles, double error) {
    const Vec3 corner = bounding_box(mesh).min;  // single precision counts from here
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            positions.push_back(static_cast<float>(v[axis] - corner[axis]));
        }
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        indices.insert(indices.end(), t.begin(), t.end());
    }
    std::vector<std::uint32_t> left(indices.size());
    left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), positions.data(), mesh.vertices.size(),
                                 3 * sizeof(float), 3 * triangles, static_cast<float>(error), 0, nullptr));
    Mesh result;
    result.vertices = mesh.vertices;
    for (std::size_t i = 0; i < left.size(); i += 3) {
        result.triangles.push_back({left[i], left[i + 1], left[i + 2]});
    }
    weld_equal_vertices(result);  // drops the vertices that are no longer used
    return result;
}

}  // namespace spectralpack
