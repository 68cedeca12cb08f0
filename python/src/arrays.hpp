#pragma once
/// Between numpy arrays and the library's values. Views share memory and keep its owner alive; they are read-only.

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <spectralpack/geometry.hpp>
#include <spectralpack/grid.hpp>
#include <spectralpack/mesh.hpp>

namespace spectralpack::python {

/// `vertices`: (n, 3), numbers; `faces`: (m, 3), whole numbers from 0 to n - 1, counter-clockwise from outside. Copied
/// once; float64 in C order is not converted before. Throws ValueError naming the shape, or the first entry that is
/// wrong.
std::shared_ptr<Mesh> mesh_from_arrays(const pybind11::object& vertices, const pybind11::object& faces);

/// A Mesh as it is; anything else with `vertices` and `faces` (a trimesh). Throws TypeError for other things.
std::shared_ptr<const Mesh> as_mesh(const pybind11::handle& object);

/// (n, 3) float64 of vertices, (m, 3) uint32 of triangles. `owner` holds the mesh.
pybind11::array vertices_view(const Mesh& mesh, const pybind11::object& owner);
pybind11::array faces_view(const Mesh& mesh, const pybind11::object& owner);

/// (4, 4) float64: columns are where x, y and z go, and the translation.
pybind11::array matrix_of(const Transform& transform);
Transform transform_of(const pybind11::object& matrix, const std::string& what);

/// Three numbers, or a number alone for all three.
Vec3 vector_of(const pybind11::handle& object, const std::string& what);
pybind11::tuple tuple_of(const Vec3& vector);
/// ((x, y, z), (x, y, z)): lower and upper corner; None of an empty box.
pybind11::object box_of(const Box& box);

/// (k, 3, 3): rotations as they stand, one after the other.
std::vector<Mat3> matrices_of(const pybind11::object& matrices, const std::string& what);

/// (nx, ny, nz), indexed [x, y, z]; in memory x is fastest. Takes the grid over.
template <class Value, class Grid>
pybind11::array array_of(Grid&& grid) {
    namespace py = pybind11;
    auto* kept = new std::decay_t<Grid>(std::forward<Grid>(grid));
    const py::capsule owner(kept, [](void* pointer) { delete static_cast<std::decay_t<Grid>*>(pointer); });
    const Extent& n = kept->extent();
    const auto size = static_cast<py::ssize_t>(sizeof(Value));
    return py::array(py::dtype::of<Value>(), {n.x, n.y, n.z}, {size, size * n.x, size * n.x * n.y}, kept->data(),
                     owner);
}

/// An array that nobody may write to.
pybind11::array read_only(pybind11::array array);

}  // namespace spectralpack::python
