#include "voxel/grid_mesh.hpp"

namespace spectralpack {

GridMesh::GridMesh(const Mesh& mesh, const Vec3& box_min, double voxel_size, const Vec3& shift)
    : triangles_(mesh.triangles), vertices_(mesh.vertices.size()) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            vertices_[i][axis] = (mesh.vertices[i][axis] - box_min[axis]) / voxel_size + shift[axis];
        }
    }
}

}  // namespace spectralpack
