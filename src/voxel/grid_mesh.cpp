#include "voxel/grid_mesh.hpp"

namespace spectralpack {

GridMesh::GridMesh(const Mesh& mesh, const Box& box, const Signs& reversed, double voxel_size,
                   const Vec3& shift)
    : triangles_(mesh.triangles), vertices_(mesh.vertices.size()) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double v = mesh.vertices[i][axis];
            const double distance =
                reversed[static_cast<std::size_t>(axis)] ? box.max[axis] - v : v - box.min[axis];
            vertices_[i][axis] = distance / voxel_size + shift[axis];
        }
    }
}

}  // namespace spectralpack
