#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include <spectralpack/option_table.hpp>
#include <spectralpack/printers.hpp>
#include <spectralpack/tools/generate.hpp>
#include <spectralpack/tools/inspect.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "packings.hpp"
#include "words.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

py::list generate(const std::string& set, std::uint64_t seed, std::optional<int> copies) {
    const tools::GenerateOptions options{word<tools::GeneratedSet>("set", set), seed, copies};
    std::vector<tools::GeneratedPart> parts;
    {
        const py::gil_scoped_release release;
        parts = tools::generate_parts(options);
    }
    py::list list;
    for (tools::GeneratedPart& part : parts) {
        list.append(py::make_tuple(part.name, std::make_shared<Mesh>(std::move(part.mesh)), part.count));
    }
    return list;
}

py::dict object_of(const tools::InspectedObject& object) {
    py::dict result;
    result["name"] = object.name;
    result["instances"] = object.instances;
    result["unit"] = object.unit;
    result["unit_known"] = object.unit_known;
    result["unit_hint"] = object.unit_hint;
    result["watertight"] = object.figures.watertight();
    result["volume"] = object.figures.volume;
    result["area"] = object.figures.area;
    result["size"] = tuple_of(object.figures.box.size());
    result["vertices"] = object.figures.vertices;
    result["faces"] = object.figures.triangles;
    result["shells"] = object.figures.shells;
    result["repairs"] = object.repairs;
    result["warnings"] = object.warnings;
    result["mesh"] = std::const_pointer_cast<Mesh>(object.mesh);
    return result;
}

py::list inspect_files(const std::vector<std::string>& files, double unit, int threads) {
    std::vector<tools::InspectedFile> inspected;
    {
        const py::gil_scoped_release release;
        inspected = tools::inspect(expand_inputs(files, {}), {unit, threads, true});
    }
    py::list list;
    for (const tools::InspectedFile& file : inspected) {
        py::dict one;
        one["file"] = file.file;
        one["unusable"] = file.unusable ? exception_of(*file.unusable) : py::object(py::none());
        py::list objects;
        for (const tools::InspectedObject& object : file.objects) {
            objects.append(object_of(object));
        }
        one["objects"] = objects;
        list.append(one);
    }
    return list;
}

py::list printer_list() {
    py::list list;
    for (const Printer& printer : printers()) {
        py::dict one;
        one["name"] = printer.name;
        one["title"] = printer.title;
        one["size"] = tuple_of(printer.size);
        one["gap"] = printer.gap;
        one["wall_gap"] = printer.wall_gap();
        list.append(one);
    }
    return list;
}

std::string option_help() {
    std::string text;
    for (const Option& option : option_table()) {
        if (!option.in_pack.set) continue;
        text += python_name(option.name) + ": " + std::string(option.line) + ". Takes " + values_of(option) + ".";
        const std::string by_default = default_text(option);
        text += (by_default.empty() ? "" : " Default: " + by_default + ".") + "\n";
    }
    return text;
}

}  // namespace

void bind_tools(py::module_& module) {
    module.def("generate", &generate, py::arg("set"), py::arg("seed") = 0, py::arg("copies") = py::none(),
               R"(Parts of a generated set: a list of (name, Mesh, count), the same on every machine for the same seed.

`set`: pieces, mixtures, locks, tori, polyhedra, letters or segments, as `spectralpack generate` has them.)");
    module.def("_inspect", &inspect_files, py::arg("files"), py::arg("unit"), py::arg("threads"));
    module.def("printers", &printer_list, "A dict for each known printer: name, title, size, gap, wall_gap; mm.");
    module.def("options_help", &option_help, "A line for each option of Job: what it does, takes and is by default.");
}

}  // namespace spectralpack::python
