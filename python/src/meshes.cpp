#include <pybind11/stl.h>

#include <spectralpack/lab/distance.hpp>
#include <spectralpack/lab/voxels.hpp>
#include <spectralpack/mesh_figures.hpp>

#include "arrays.hpp"
#include "bindings.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

std::string mesh_text(const Mesh& mesh) {
    return "<spectralpack.Mesh: " + std::to_string(mesh.vertices.size()) + " vertices, " +
           std::to_string(mesh.triangles.size()) + " faces>";
}

py::dict figures_of(const Mesh& mesh) {
    MeshFigures figures;
    {
        const py::gil_scoped_release release;
        figures = inspect_mesh(mesh);
    }
    py::dict result;
    result["watertight"] = figures.watertight();
    result["volume"] = figures.volume;
    result["area"] = figures.area;
    result["bounds"] = box_of(figures.box);
    result["vertices"] = figures.vertices;
    result["faces"] = figures.triangles;
    result["shells"] = figures.shells;
    result["border_edges"] = figures.edges.border;
    result["holes"] = figures.border_loops;
    result["misdirected_edges"] = figures.edges.misdirected;
    result["crowded_edges"] = figures.edges.crowded;
    result["duplicate_faces"] = figures.duplicates;
    result["self_crossings"] = figures.crossings.pairs;
    return result;
}

}  // namespace

void bind_meshes(py::module_& module) {
    py::class_<Mesh, std::shared_ptr<Mesh>>(module, "Mesh", "Triangles, in millimetres unless a job says otherwise.")
        .def(py::init(&mesh_from_arrays), py::arg("vertices"), py::arg("faces"))
        .def_property_readonly(
            "vertices", [](const py::object& self) { return vertices_view(self.cast<const Mesh&>(), self); },
            "(n, 3) float64, read-only: a view of the mesh's own memory.")
        .def_property_readonly(
            "faces", [](const py::object& self) { return faces_view(self.cast<const Mesh&>(), self); },
            "(m, 3) uint32, read-only, likewise; counter-clockwise from outside.")
        .def_property_readonly("volume", &signed_volume, "Signed; exact for closed meshes, negative when inside-out.")
        .def_property_readonly("area", &surface_area)
        .def_property_readonly(
            "bounds", [](const Mesh& mesh) { return box_of(bounding_box(mesh)); },
            "((x, y, z), (x, y, z)): lower and upper corner; None without faces.")
        .def(
            "transformed",
            [](const Mesh& mesh, const py::object& matrix) {
                return std::make_shared<Mesh>(transformed(mesh, transform_of(matrix, "matrix")));
            },
            py::arg("matrix"), "Moved by a (4, 4) matrix. A mirror turns the faces round, so that they face outwards.")
        .def("inspect", &figures_of, "What is wrong with it, in figures: a dict.")
        .def("__repr__", &mesh_text);
    module.def(
        "voxelize",
        [](const py::object& object, double voxel, bool return_corner, int threads) -> py::object {
            const std::shared_ptr<const Mesh> mesh = as_mesh(object);
            lab::Voxels voxels;
            {
                const py::gil_scoped_release release;
                voxels = lab::voxelize(*mesh, voxel, threads);
            }
            const Vec3 corner = voxels.corner;
            py::object solid = array_of<std::uint8_t>(std::move(voxels.solid)).attr("view")("bool");
            if (!return_corner) return solid;
            return py::make_tuple(solid, tuple_of(corner));
        },
        py::arg("mesh"), py::arg("voxel"), py::kw_only(), py::arg("return_corner") = false, py::arg("threads") = 0,
        R"(Solid voxels of a mesh: a bool array, indexed [x, y, z] (paper, section 3.1; docs/conventions.md).

`voxel`: their size, mm. The mesh stands in the middle of its voxels; `return_corner` asks for the lower corner of voxel
[0, 0, 0], too, in the mesh's coordinates. Closed hollows are filled; a mesh that is not closed has its surface only.)");
    module.def(
        "distance",
        [](const py::object& a, const py::object& b, const std::optional<py::object>& pose_a,
           const std::optional<py::object>& pose_b) {
            const auto first = as_mesh(a), second = as_mesh(b);
            const Transform of_first = pose_a ? transform_of(*pose_a, "pose_a") : Transform{};
            const Transform of_second = pose_b ? transform_of(*pose_b, "pose_b") : Transform{};
            lab::Distance distance;
            {
                const py::gil_scoped_release release;
                distance = lab::distance(*first, of_first, *second, of_second);
            }
            return py::make_tuple(distance.value, tuple_of(distance.point_a), tuple_of(distance.point_b));
        },
        py::arg("a"), py::arg("b"), py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(),
        R"(Least distance between the surfaces of two meshes, each moved by its pose, (4, 4): (mm, nearest point on a,
nearest point on b). Exact but for rounding; 0 where they meet. A mesh inside another has the distance of the surfaces.)");
}

}  // namespace spectralpack::python
