#include "jobs.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>

#include <spectralpack/files.hpp>
#include <spectralpack/names.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "options.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

bool is_path(const py::handle& object) { return py::isinstance<py::str>(object) || py::hasattr(object, "__fspath__"); }

std::string path_text(const py::handle& object) { return object.cast<std::filesystem::path>().string(); }

MeshInput mesh_input(const py::handle& object) {
    if (is_path(object)) return path_text(object);
    return as_mesh(object);
}

SignedAxis axis_of(const std::string& text) {
    const std::size_t axis = text.size() == 2 ? std::string("xyz").find(text[1]) : std::string::npos;
    if (axis == std::string::npos || (text[0] != '+' && text[0] != '-')) {
        throw py::value_error("an axis that points up is one of +x -x +y -y +z -z, not '" + text + "'");
    }
    return {static_cast<int>(axis), text[0] == '+'};
}

/// "any", "upright", "fixed", {"up": ["+z", "-x"], "yaw": 90}, or rotations, (k, 3, 3).
PartOrientations orientations_of(const py::handle& object) {
    PartOrientations result;
    if (py::isinstance<py::str>(object)) {
        const auto word = object.cast<std::string>();
        const auto kind = from_string<PartOrientations::Kind>(word);
        if (!kind) {
            throw py::value_error(
                "orientations are 'any', 'upright', 'fixed', a dict of 'up' and 'yaw', or rotations of "
                "the shape (k, 3, 3); not '" +
                word + "'");
        }
        result.kind = *kind;
        return result;
    }
    if (py::isinstance<py::dict>(object)) {
        const auto said = object.cast<py::dict>();
        result.kind = PartOrientations::Kind::axes;
        for (const auto& [key, value] : said) {
            const auto name = key.cast<std::string>();
            if (name == "up") {
                for (const auto& axis : value.cast<std::vector<std::string>>()) {
                    result.up.push_back(axis_of(axis));
                }
            } else if (name == "yaw") {
                if (!value.is_none()) result.yaw = value.cast<double>();
            } else {
                throw py::value_error("orientations have 'up' and 'yaw', not '" + name + "'");
            }
        }
        if (result.up.empty()) throw py::value_error("orientations need at least one axis that points up: 'up'");
        return result;
    }
    result.kind = PartOrientations::Kind::matrices;
    const std::vector<Mat3> matrices = matrices_of(py::reinterpret_borrow<py::object>(object), "orientations");
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const std::optional<Mat3> rotation = as_rotation(matrices[i]);
        if (!rotation) throw py::value_error("orientations[" + std::to_string(i) + "] is not a rotation");
        result.matrices.push_back(*rotation);
    }
    if (result.matrices.empty()) throw py::value_error("orientations are empty");
    return result;
}

double unit_of(const py::handle& object) {
    if (py::isinstance<py::str>(object)) {
        const auto word = object.cast<std::string>();
        const auto unit = from_string<LengthUnit>(word);
        if (!unit) throw py::value_error("a unit is 'mm', 'inch', 'm' or so many mm, not '" + word + "'");
        return in_mm(*unit);
    }
    const double mm = object.cast<double>();
    if (!(mm > 0)) throw py::value_error("a unit is a positive number of mm");
    return mm;
}

void add(KeptJob& kept, const py::object& mesh, int count, const std::optional<std::string>& name, double scale,
         std::optional<double> gap, const py::object& orientations, const py::object& unit, double priority,
         const std::string& due, const std::string& order, double value, const std::optional<std::string>& object) {
    if (count < 1) throw py::value_error("count must be at least 1, not " + std::to_string(count));
    if (!(scale >= kLeastScale && scale <= kMostScale))
        throw py::value_error("scale must be above 0 and not too large");
    Part part;
    part.mesh = mesh_input(mesh);
    part.object = object;
    part.count = count;
    part.scale = scale;
    part.gap = gap;
    part.orientations = orientations_of(orientations);
    if (!unit.is_none()) part.unit = unit_of(unit);
    part.priority = priority;
    part.due = due;
    part.order = order;
    part.value = value;
    if (name) {
        part.name = *name;
    } else if (part.mesh.file().empty()) {
        part.name = "part " + std::to_string(kept.job.parts.size() + 1);
    }
    part.origin = "parts[" + std::to_string(kept.job.parts.size()) + "]";
    kept.job.parts.push_back(std::move(part));
}

KeepOutSource keep_out_of(const py::handle& object) {
    if (is_path(object)) return {{}, MeshSource{path_text(object), "keep_out", std::nullopt, std::nullopt}};
    const auto corners = object.cast<std::vector<double>>();
    if (corners.size() != 6) throw py::value_error("a keep-out is a mesh file or six numbers: x0, y0, z0, x1, y1, z1");
    Box box;
    box.add(Vec3{corners[0], corners[1], corners[2]});
    box.add(Vec3{corners[3], corners[4], corners[5]});
    return {box, std::nullopt};
}

/// The tray is the topped-up build's.
void take_tray_of_onto(Job& job) {
    job.options.tray = job.onto->packing.container.size;
    job.container = container_source(job.onto->packing);
}

/// What is no option of packing, but of the job.
bool set_of_job(KeptJob& kept, const std::string& name, const py::handle& value) {
    Job& job = kept.job;
    if (name == "unit") {
        job.unit = unit_of(value);
    } else if (name == "container") {
        job.container.mesh.reset();
        if (!value.is_none())
            job.container.mesh = MeshSource{path_text(value), "container", std::nullopt, std::nullopt};
    } else if (name == "container_is") {
        job.container.is.reset();
        if (value.is_none()) return true;
        job.container.is = from_string<ContainerIs>(value.cast<std::string>());
        if (!job.container.is) throw py::value_error("container_is is 'solid' or 'vessel'");
    } else if (name == "keep_out") {
        job.container.keep_out.clear();
        for (const auto& one : value) {
            job.container.keep_out.push_back(keep_out_of(one));
        }
    } else if (name == "onto") {
        job.onto.reset();
        if (value.is_none()) return true;
        job.onto = value.cast<std::shared_ptr<KeptPacking>>()->scene;
        take_tray_of_onto(job);
    } else if (name == "keep") {
        job.keep.reset();
        if (!value.is_none()) job.keep = value.cast<std::shared_ptr<KeptPacking>>()->scene;
    } else if (name == "printer") {
        job.options.printer.reset();
        if (value.is_none()) return true;
        const auto printer = value.cast<std::string>();
        const Printer* const known = find_printer(printer, job.own_printers);
        if (!known) throw UsageError("there is no printer '" + printer + "'; spectralpack.printers() lists them");
        apply(*known, job.options);
    } else {
        return false;
    }
    return true;
}

void set(KeptJob& kept, const std::string& name, const py::handle& value) {
    if (!set_of_job(kept, name, value)) set_option(kept.job.options, name, value);
}

/// A printer and a build that is topped up say what others may override.
void set_all(KeptJob& kept, const py::kwargs& options) {
    for (const char* first : {"printer", "onto"}) {
        if (options.contains(first)) set(kept, first, options[first]);
    }
    for (const auto& [key, value] : options) {
        const auto name = key.cast<std::string>();
        if (name != "printer" && name != "onto") set(kept, name, value);
    }
}

std::shared_ptr<KeptJob> from_files(const py::args& files, const py::kwargs& said) {
    py::kwargs options = py::reinterpret_steal<py::kwargs>(PyDict_Copy(said.ptr()));
    std::filesystem::path mesh_dir;
    if (options.contains("mesh_dir")) {
        mesh_dir = options["mesh_dir"].cast<std::filesystem::path>();
        PyDict_DelItemString(options.ptr(), "mesh_dir");
    }
    std::vector<std::string> arguments;
    for (const auto& file : files) {
        arguments.push_back(path_text(file));
    }
    if (arguments.empty()) throw UsageError("from_files() needs a mesh file, a folder, a set or a job file");
    ExpandedInputs inputs;
    {
        const py::gil_scoped_release release;
        inputs = expand_inputs(arguments, mesh_dir);
    }
    auto kept = std::make_shared<KeptJob>();
    if (inputs.job) {
        const JobSettings& settings = *inputs.job;
        kept->job.options = settings.options;
        kept->job.container = settings.container;
        kept->job.fixed = settings.fixed;
        kept->job.own_printers = settings.own_printers;
        if (settings.unit) kept->job.unit = in_mm(*settings.unit);
        if (settings.onto) {
            kept->job.onto = load_scene(*settings.onto);
            if (!settings.sized) take_tray_of_onto(kept->job);
        }
        if (settings.keep) kept->job.keep = load_scene(*settings.keep);
    }
    kept->job.parts = std::move(inputs.parts);
    kept->remarks = std::move(inputs.remarks);
    set_all(*kept, options);
    return kept;
}

py::list job_parts(const KeptJob& kept) {
    py::list parts;
    for (const Part& part : kept.job.parts) {
        py::dict one;
        one["name"] = part.name;
        one["mesh"] = part.mesh.file().empty() ? py::object(py::none()) : py::str(part.mesh.file());
        one["object"] = part.object;
        one["count"] = part.count;
        one["scale"] = part.scale;
        one["gap"] = part.gap;
        one["priority"] = part.priority;
        one["due"] = part.due;
        one["order"] = part.order;
        one["value"] = part.value;
        parts.append(one);
    }
    return parts;
}

std::string job_text(const KeptJob& kept) {
    std::int64_t copies = 0;
    for (const Part& part : kept.job.parts) {
        copies += part.count;
    }
    const std::size_t parts = kept.job.parts.size();
    return "<spectralpack.Job: " + std::to_string(copies) + (copies == 1 ? " copy of " : " copies of ") +
           std::to_string(parts) + (parts == 1 ? " part>" : " parts>");
}

}  // namespace

void bind_jobs(py::module_& module) {
    py::class_<KeptJob, std::shared_ptr<KeptJob>>(module, "Job", R"(What is to be packed, and into what.

    job = Job(tray=(480, 245, 200), gap=1.0)
    job.add("bracket.stl", count=12)
    packing = pack(job)

Options are those of the command line, by name with _ for -: spectralpack.options_help() lists them. Lengths
are mm. Besides them: `unit` ('mm', 'inch', 'm' or so many mm) of files that do not say theirs, `printer` (a name of
printers()), `container` (a closed mesh file to fill), `container_is` ('solid' or 'vessel'), `keep_out` (a list of mesh
files or of six numbers x0, y0, z0, x1, y1, z1), `onto` (a Packing whose copies stay where they are, beside those asked
for) and `keep` (a Packing whose copies stay and count as asked for).)")
        .def(py::init([](const py::kwargs& options) {
            auto kept = std::make_shared<KeptJob>();
            set_all(*kept, options);
            return kept;
        }))
        .def("add", &add, py::arg("mesh"), py::arg("count") = 1, py::kw_only(), py::arg("name") = py::none(),
             py::arg("scale") = 1.0, py::arg("gap") = py::none(), py::arg("orientations") = "any",
             py::arg("unit") = py::none(), py::arg("priority") = 0.0, py::arg("due") = "", py::arg("order") = "",
             py::arg("value") = 1.0, py::arg("object") = py::none(), R"(Adds copies of a mesh.

`mesh`: a path (STL, 3MF, OBJ, PLY, OFF), a Mesh, or anything with .vertices, (n, 3), and .faces, (m, 3), such as a
trimesh. `scale` multiplies its lengths; `unit` is that of this mesh, as Job(unit=) has it. `gap`: least distance to
other copies, mm, where it is not the job's. `orientations`: 'any', 'upright', 'fixed', {'up': ['+z', '-x'], 'yaw': 90}
or rotations, (k, 3, 3). Higher `priority` and earlier `due` ('2026-12-01') go first. `order` is whose it is, for people;
`value` what a copy is worth with goal='value'. `object`: of a 3MF with several, the id of the one to pack.
Raises ValueError for a shape or value that makes no sense.)")
        .def(
            "set", [](KeptJob& kept, const py::kwargs& options) { set_all(kept, options); },
            "Sets options, as Job() does.")
        .def(
            "get", [](const KeptJob& kept, const std::string& name) { return get_option(kept.job.options, name); },
            py::arg("name"), "An option's value; None where it says nothing.")
        .def_property_readonly(
            "options", [](const KeptJob& kept) { return options_dict(kept.job.options); },
            "All options of packing, by name: a dict of its own.")
        .def_property_readonly("parts", &job_parts, "A dict for each part.")
        .def_property_readonly(
            "remarks", [](const KeptJob& kept) { return kept.remarks; },
            "How files were read that say it in an uncommon way.")
        .def_static("from_files", &from_files, R"(A job from files, as the command line takes them.

    job = Job.from_files("parts/", "bracket.stl:12", tray=(480, 245, 200))

Mesh files (also FILE:COUNT and FILE@SCALE), folders, set files (.csv; their paths start from `mesh_dir`) and one
job file (.json), which may say options of its own; those given here come before them. What cannot be used is told
by pack(). Raises UsageError, InputError for a job file that cannot be read.)")
        .def("__repr__", &job_text);
}

}  // namespace spectralpack::python
