#include "spectralpack/mesh.hpp"

#include <utility>

namespace spectralpack {

Box bounding_box(const Mesh& mesh) {
    Box box;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            box.add(mesh.vertices[vertex]);
        }
    }
    return box;
}

Mesh box_surface(const Box& box) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(
            {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

void append(Mesh& mesh, const Mesh& more) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Triangle& t : more.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
}

Mesh inside_out(Mesh mesh) {
    for (Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
    return mesh;
}

double signed_volume(const Mesh& mesh) {
    // Relative to a corner of the mesh, so that a part far from the origin does not lose its digits.
    const Vec3 origin = mesh.vertices.empty() ? Vec3{} : mesh.vertices.front();
    double six_volumes = 0;
    for (const Triangle& t : mesh.triangles) {
        six_volumes +=
            dot(mesh.vertices[t[0]] - origin, cross(mesh.vertices[t[1]] - origin, mesh.vertices[t[2]] - origin));
    }
    return six_volumes / 6;
}

double surface_area(const Mesh& mesh) {
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        area += length(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a)) / 2;
    }
    return area;
}

Mesh transformed(const Mesh& mesh, const Transform& transform) {
    Mesh result = mesh;
    for (Vec3& vertex : result.vertices) {
        vertex = transform * vertex;
    }
    if (determinant(transform.linear) < 0) {
        for (Triangle& triangle : result.triangles) {
            std::swap(triangle[1], triangle[2]);
        }
    }
    return result;
}

}  // namespace spectralpack
