#include <pybind11/stl.h>

#include <spectralpack/lab/search.hpp>
#include <spectralpack/orientations.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interrupting.hpp"
#include "words.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

/// "90", "icosahedron:1", a number of degrees, or rotations, (k, 3, 3).
std::vector<Mat3> rotations_in(const py::object& rotations) {
    if (py::isinstance<py::str>(rotations) || PyFloat_Check(rotations.ptr()) || PyLong_Check(rotations.ptr())) {
        return orientation_set(py::str(rotations).cast<std::string>());
    }
    return matrices_of(rotations, "rotations");
}

std::unique_ptr<lab::Tray> make_tray(const py::object& size, double voxel, int detail, const std::vector<double>& gaps,
                                     const std::string& engine, int threads) {
    return std::make_unique<lab::Tray>(
        lab::TrayOptions{vector_of(size, "size"), voxel, detail, gaps, word<EngineKind>("engine", engine), threads});
}

VoxelIndex index_of(const py::object& position) {
    const auto at = position.cast<std::vector<int>>();
    if (at.size() != 3) throw py::value_error("a position is three whole numbers: x, y, z");
    return {at[0], at[1], at[2]};
}

py::tuple tuple_of(const VoxelIndex& index) { return py::make_tuple(index.x, index.y, index.z); }

std::optional<lab::BestPlacement> best(lab::Tray& tray, const lab::Shape& shape, double height_penalty,
                                       const std::string& height_at) {
    const lab::CostOptions cost{height_penalty, word<HeightReference>("height_at", height_at)};
    std::optional<lab::BestPlacement> found;
    interruptible([&](const StopToken& stop) { found = tray.best_placement(shape, cost, stop); });
    return found;
}

py::tuple fields(const lab::Tray& tray, const lab::Shape& shape, int orientation) {
    lab::MetricFields fields;
    {
        const py::gil_scoped_release release;
        fields = tray.metric_fields(shape, orientation);
    }
    return py::make_tuple(array_of<std::int64_t>(std::move(fields.collision)),
                          array_of<std::int64_t>(std::move(fields.proximity)));
}

py::object as_bool(py::array array) { return array.attr("view")("bool"); }

}  // namespace

void bind_laboratory(py::module_& module) {
    py::class_<lab::Shape>(module, "Shape", "A mesh's voxels in every orientation. Made by Tray.shape().")
        .def_property_readonly("orientations", &lab::Shape::orientations,
                               "Distinct ones, as indices into the set it was made from, ascending.")
        .def(
            "voxels",
            [](const lab::Shape& shape, std::size_t index) {
                if (index >= shape.orientations().size()) throw py::index_error("there is no such orientation");
                return as_bool(array_of<std::uint8_t>(shape.voxels(index)));
            },
            py::arg("index"), "Solid voxels of orientations[index]: bool, indexed [x, y, z].");
    py::class_<lab::BestPlacement>(module, "Placement", "Where best_placement() would put a shape.")
        .def_readonly("orientation", &lab::BestPlacement::orientation, "Index in the set that the shape was made from.")
        .def_property_readonly(
            "position", [](const lab::BestPlacement& placement) { return tuple_of(placement.position); },
            "q: the voxel where the lower corner of the orientation's voxels lies.")
        .def_readonly("proximity", &lab::BestPlacement::proximity, "rho(q), equation 4 of the paper.")
        .def_readonly("cost", &lab::BestPlacement::cost,
                      "sigma(q), equation 5; with height at the top, the layer that the copy reaches up to.")
        .def_property_readonly(
            "transform", [](const lab::BestPlacement& placement) { return matrix_of(placement.transform); },
            "(4, 4), from the mesh's coordinates to the tray's, mm.")
        .def("__repr__", [](const lab::BestPlacement& placement) {
            return "<spectralpack.Placement: orientation " + std::to_string(placement.orientation) + " at " +
                   py::str(tuple_of(placement.position)).cast<std::string>() + ">";
        });
    py::class_<lab::Tray>(module, "Tray", R"(The placement search by itself, for strategies of one's own.

    tray = Tray((100, 100, 80), voxel=2)
    shape = tray.shape(mesh, "90")
    best = tray.best_placement(shape)
    if best: tray.add(shape, best)

`size`: mm. `voxel`: dx, mm. Collisions are decided on voxels of dx / `detail`. `gaps`: all gaps that shapes will have.
Arrays are indexed [x, y, z]. A voxel position q is where the lower corner of an orientation's voxels lies.)")
        .def(py::init(&make_tray), py::arg("size"), py::arg("voxel") = 2.0, py::kw_only(), py::arg("detail") = 1,
             py::arg("gaps") = std::vector<double>{0}, py::arg("engine") = "auto", py::arg("threads") = 0)
        .def_property_readonly(
            "extent",
            [](const lab::Tray& tray) { return py::make_tuple(tray.extent().x, tray.extent().y, tray.extent().z); },
            "n: voxels along x, y and z.")
        .def(
            "shape",
            [](const lab::Tray& tray, const py::object& object, const py::object& rotations, double gap) {
                const std::shared_ptr<const Mesh> mesh = as_mesh(object);
                const std::vector<Mat3> orientations = rotations_in(rotations);
                const py::gil_scoped_release release;
                return tray.shape(*mesh, orientations, gap);
            },
            py::arg("mesh"), py::arg("rotations") = "90", py::arg("gap") = 0.0,
            "Voxels of a mesh, mm, in each orientation: '90', 'icosahedron:1', degrees, or rotations, (k, 3, 3).")
        .def("best_placement", &best, py::arg("shape"), py::kw_only(), py::arg("height_penalty") = 4.0,
             py::arg("height_at") = "bottom",
             R"(The free position of least cost over all orientations; None where there is none.

The cost is sigma = rho + p (q_z / n_z)^3 (equations 4 to 6 of the paper, p = `height_penalty`), or, with
height_at='top', height before proximity. Ties go to the least orientation, then z, y, x.)")
        .def("metric_fields", &fields, py::arg("shape"), py::arg("orientation"), R"(zeta and rho at every position.

Two int64 arrays, indexed by q as [x, y, z]: collision (equation 2: 0 where the copy is free) and proximity (equation
4). Computed as the paper does: slow, exact. Raises UsageError where this build has no reference engine.)")
        .def(
            "add",
            [](lab::Tray& tray, const lab::Shape& shape, const lab::BestPlacement& placement) {
                return tray.add(shape, placement);
            },
            py::arg("shape"), py::arg("placement"), "Returns the copy's number.")
        .def(
            "add_at",
            [](lab::Tray& tray, const lab::Shape& shape, int orientation, const py::object& position) {
                return tray.add(shape, orientation, index_of(position));
            },
            py::arg("shape"), py::arg("orientation"), py::arg("position"),
            "The same anywhere; collisions are not looked at.")
        .def("remove", &lab::Tray::remove, py::arg("copy"), "Voxels that other copies hold stay.")
        .def(
            "occupied", [](const lab::Tray& tray) { return as_bool(array_of<std::uint8_t>(tray.occupied())); },
            "Voxels that copies reach into: bool, indexed [x, y, z].");
    module.def(
        "orientation_set",
        [](const py::object& rotations) {
            const std::vector<Mat3> set = orientation_set(py::str(rotations).cast<std::string>());
            py::array_t<double> matrices({static_cast<py::ssize_t>(set.size()), py::ssize_t{3}, py::ssize_t{3}});
            auto at = matrices.mutable_unchecked<3>();
            for (std::size_t k = 0; k < set.size(); ++k) {
                for (int i = 0; i < 9; ++i) {
                    at(static_cast<py::ssize_t>(k), i / 3, i % 3) = set[k].rows[static_cast<std::size_t>(i / 3)][i % 3];
                }
            }
            return matrices;
        },
        py::arg("rotations"), "Rotations, (k, 3, 3), as `rotations` of a job asks for: '90', 'icosahedron:1', 45.");
}

}  // namespace spectralpack::python
