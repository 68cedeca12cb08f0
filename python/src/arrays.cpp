#include "arrays.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace py = pybind11;

namespace spectralpack::python {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")).cast<std::string>(); }

/// An array of that many dimensions, the last ones of length 3; -1 stands for any length.
py::array_t<double, py::array::c_style | py::array::forcecast> numbers(const py::object& object,
                                                                       const std::string& what,
                                                                       const std::vector<py::ssize_t>& shape,
                                                                       const char* shape_in_words) {
    const py::array any = py::array::ensure(object);
    if (!any || std::string("biuf").find(any.dtype().kind()) == std::string::npos) {
        PyErr_Clear();
        throw py::type_error(what + " must be an array of numbers");
    }
    bool fits = any.ndim() == static_cast<py::ssize_t>(shape.size());
    for (std::size_t i = 0; fits && i < shape.size(); ++i) {
        fits = shape[i] < 0 || any.shape(static_cast<py::ssize_t>(i)) == shape[i];
    }
    if (!fits) throw py::value_error(what + " must have the shape " + shape_in_words + ", not " + shape_text(any));
    return py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(any);
}

std::vector<Triangle> triangles_of(const py::object& faces, std::size_t vertices) {
    const py::array any = py::array::ensure(faces);
    if (!any || std::string("iu").find(any.dtype().kind()) == std::string::npos) {
        // An empty list is an array of floats.
        if (any && any.size() == 0) return {};
        PyErr_Clear();
        throw py::type_error("faces must be an array of whole numbers");
    }
    if (any.ndim() != 2 || any.shape(1) != 3) {
        throw py::value_error("faces must have the shape (m, 3), not " + shape_text(any));
    }
    const auto indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(any);
    const std::int64_t* const from = indices.data();
    std::vector<Triangle> triangles(static_cast<std::size_t>(any.shape(0)));
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
        if (from[i] < 0 || from[i] >= static_cast<std::int64_t>(vertices)) {
            throw py::value_error("faces[" + std::to_string(i / 3) + "] names vertex " + std::to_string(from[i]) +
                                  ", and there are " + std::to_string(vertices));
        }
        triangles[i / 3][i % 3] = static_cast<std::uint32_t>(from[i]);
    }
    return triangles;
}

}  // namespace

std::shared_ptr<Mesh> mesh_from_arrays(const py::object& vertices, const py::object& faces) {
    const auto points = numbers(vertices, "vertices", {-1, 3}, "(n, 3)");
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices.resize(static_cast<std::size_t>(points.shape(0)));
    if (mesh->vertices.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw py::value_error("a mesh has at most 4294967295 vertices");
    }
    const double* const from = points.data();
    for (std::size_t i = 0; i < 3 * mesh->vertices.size(); ++i) {
        if (!std::isfinite(from[i])) throw py::value_error("vertices[" + std::to_string(i / 3) + "] is not finite");
    }
    if (!mesh->vertices.empty())
        std::memcpy(static_cast<void*>(mesh->vertices.data()), from, mesh->vertices.size() * sizeof(Vec3));
    mesh->triangles = triangles_of(faces, mesh->vertices.size());
    return mesh;
}

std::shared_ptr<const Mesh> as_mesh(const py::handle& object) {
    if (py::isinstance<Mesh>(object)) return object.cast<std::shared_ptr<Mesh>>();
    if (py::hasattr(object, "vertices") && py::hasattr(object, "faces")) {
        return mesh_from_arrays(object.attr("vertices"), object.attr("faces"));
    }
    throw py::type_error("a mesh is a spectralpack.Mesh or has .vertices and .faces, and " +
                         py::str(py::type::of(object).attr("__name__")).cast<std::string>() + " has not");
}

py::array read_only(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

py::array vertices_view(const Mesh& mesh, const py::object& owner) {
    const auto n = static_cast<py::ssize_t>(mesh.vertices.size());
    return read_only(py::array(py::dtype::of<double>(), {n, py::ssize_t{3}}, mesh.vertices.data(), owner));
}

py::array faces_view(const Mesh& mesh, const py::object& owner) {
    const auto m = static_cast<py::ssize_t>(mesh.triangles.size());
    return read_only(py::array(py::dtype::of<std::uint32_t>(), {m, py::ssize_t{3}}, mesh.triangles.data(), owner));
}

py::array matrix_of(const Transform& transform) {
    py::array_t<double> matrix({4, 4});
    auto at = matrix.mutable_unchecked<2>();
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            at(row, column) = row == 3      ? (column == 3 ? 1 : 0)
                              : column == 3 ? transform.translation[row]
                                            : transform.linear.rows[static_cast<std::size_t>(row)][column];
        }
    }
    return matrix;
}

Transform transform_of(const py::object& matrix, const std::string& what) {
    const auto values = numbers(matrix, what, {4, 4}, "(4, 4)");
    const auto at = values.unchecked<2>();
    Transform transform;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            transform.linear.rows[static_cast<std::size_t>(row)][column] = at(row, column);
        }
        transform.translation[row] = at(row, 3);
    }
    return transform;
}

Vec3 vector_of(const py::handle& object, const std::string& what) {
    if (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr())) {
        const double side = object.cast<double>();
        return {side, side, side};
    }
    const auto values = numbers(py::reinterpret_borrow<py::object>(object), what, {3}, "(3,)");
    return {values.at(0), values.at(1), values.at(2)};
}

py::tuple tuple_of(const Vec3& vector) { return py::make_tuple(vector.x, vector.y, vector.z); }

py::object box_of(const Box& box) {
    if (box.empty()) return py::none();
    return py::make_tuple(tuple_of(box.min), tuple_of(box.max));
}

std::vector<Mat3> matrices_of(const py::object& matrices, const std::string& what) {
    const auto values = numbers(matrices, what, {-1, 3, 3}, "(k, 3, 3)");
    const auto at = values.unchecked<3>();
    std::vector<Mat3> result(static_cast<std::size_t>(values.shape(0)));
    for (std::size_t k = 0; k < result.size(); ++k) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                result[k].rows[static_cast<std::size_t>(row)][column] = at(static_cast<py::ssize_t>(k), row, column);
            }
        }
    }
    return result;
}

}  // namespace spectralpack::python
