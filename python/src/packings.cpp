#include "packings.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include <spectralpack/files.hpp>
#include <spectralpack/names.hpp>
#include <spectralpack/render.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "options.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

/// A row of Packing.placements.
struct PlacementRow {
    std::int32_t part, copy, tray, number, orientation;
    bool fixed;
    double transform[4][4];
};

PlacementRow row_of(const Placement& placement, int tray, const CopyNumbers& numbers) {
    PlacementRow row{placement.part,        placement.copy,  tray, numbers.of(placement),
                     placement.orientation, placement.fixed, {}};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            row.transform[i][j] = placement.transform.linear.rows[static_cast<std::size_t>(i)][j];
        }
        row.transform[i][3] = placement.transform.translation[i];
    }
    row.transform[3][3] = 1;
    return row;
}

py::array placements_of(const Packing& packing) {
    std::vector<PlacementRow> rows;
    const CopyNumbers numbers(packing.parts);
    for (std::size_t tray = 0; tray < packing.trays.size(); ++tray) {
        for (const Placement& placement : packing.trays[tray].placements) {
            rows.push_back(row_of(placement, static_cast<int>(tray), numbers));
        }
    }
    return py::array_t<PlacementRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

py::dict part_of(const PackedPart& part) {
    py::dict result;
    result["name"] = part.name;
    result["mesh"] = part.mesh.empty() ? py::object(py::none()) : py::str(part.mesh);
    result["count"] = part.count;
    result["scale"] = part.scale;
    result["unit"] = part.unit;
    result["gap"] = part.gap;
    result["volume"] = part.volume;
    result["priority"] = part.priority;
    result["due"] = part.due;
    result["order"] = part.order;
    result["value"] = part.value;
    result["repairs"] = part.repairs;
    return result;
}

py::list packing_parts(const Packing& packing) {
    py::list parts;
    for (const PackedPart& part : packing.parts) {
        parts.append(part_of(part));
    }
    return parts;
}

py::dict tray_of(const TrayPacking& tray) {
    py::dict result;
    result["copies"] = tray.placements.size();
    result["density"] = tray.density;
    result["density_bounding_box"] = tray.density_bounding_box;
    result["height"] = tray.height;
    result["bounds"] = box_of(tray.bounding_box);
    result["layer_thickness"] = tray.layers.thickness;
    result["layer_areas"] =
        py::array_t<double>(static_cast<py::ssize_t>(tray.layers.area.size()), tray.layers.area.data());
    return result;
}

py::list trays_of(const Packing& packing) {
    py::list trays;
    for (const TrayPacking& tray : packing.trays) {
        trays.append(tray_of(tray));
    }
    return trays;
}

py::list left_over_of(const Packing& packing) {
    py::list list;
    for (const Unplaced& unplaced : packing.unplaced) {
        py::dict one;
        one["part"] = unplaced.part;
        one["copy"] = unplaced.copy;
        one["reason"] = std::string(to_string(unplaced.reason));
        one["detail"] = unplaced.detail.empty() ? std::string(in_words(unplaced.reason)) : unplaced.detail;
        list.append(one);
    }
    return list;
}

py::object improvement_of(const std::optional<Improved>& improved) {
    if (!improved) return py::none();
    py::dict result;
    result["what"] = std::string(to_string(improved->what));
    result["before"] = improved->before;
    result["now"] = improved->now;
    result["steps"] = improved->steps;
    result["starts"] = improved->starts;
    result["seconds"] = improved->seconds;
    return result;
}

py::dict metrics_of(const Metrics& metrics) {
    py::dict seconds;
    seconds["total"] = metrics.seconds.total;
    seconds["load"] = metrics.seconds.load;
    seconds["voxelize"] = metrics.seconds.voxelize;
    seconds["search"] = metrics.seconds.search;
    seconds["refine"] = metrics.seconds.refine;
    seconds["disassemble"] = metrics.seconds.disassemble;
    seconds["reinsert"] = metrics.seconds.reinsert;
    py::dict result;
    result["copies"] = metrics.copies;
    result["placed"] = metrics.placed;
    result["density"] = metrics.density;
    result["min_gap"] = metrics.min_gap;
    result["seconds"] = seconds;
    result["searches"] = metrics.searches;
    result["orders"] = metrics.orders;
    result["improvement"] = improvement_of(metrics.improvement);
    result["peak_memory"] = metrics.peak_memory;
    result["engine"] = metrics.engine;
    result["threads"] = metrics.threads;
    return result;
}

const std::shared_ptr<const Mesh>& mesh_of(const KeptPacking& kept, int part) {
    if (part < 0 || static_cast<std::size_t>(part) >= kept.scene.meshes.size()) {
        throw py::index_error("there is no part " + std::to_string(part));
    }
    return kept.scene.meshes[static_cast<std::size_t>(part)];
}

/// All placed copies of a tray as one mesh, each where it stands.
std::shared_ptr<Mesh> tray_mesh(const KeptPacking& kept, int tray) {
    auto all = std::make_shared<Mesh>();
    const auto& trays = kept.scene.packing.trays;
    if (tray < 0 || static_cast<std::size_t>(tray) >= trays.size()) {
        throw py::index_error("there is no tray " + std::to_string(tray));
    }
    for (const Placement& placement : trays[static_cast<std::size_t>(tray)].placements) {
        append(*all, transformed(*mesh_of(kept, placement.part), placement.transform));
    }
    return all;
}

std::optional<Section> section_of(const std::optional<std::pair<std::string, double>>& section) {
    if (!section) return std::nullopt;
    const std::size_t axis = std::string("xyz").find(section->first);
    if (section->first.size() != 1 || axis == std::string::npos) {
        throw py::value_error("a section is ('x', mm), ('y', mm) or ('z', mm)");
    }
    return Section{static_cast<int>(axis), section->second};
}

Image picture(const KeptPacking& kept, const RenderOptions& options, int threads) {
    const py::gil_scoped_release release;
    return render(kept.scene, options, threads);
}

py::array pixels(Image image) {
    auto* bytes = new std::vector<std::uint8_t>(std::move(image.rgb));
    const py::capsule owner(bytes, [](void* pointer) { delete static_cast<std::vector<std::uint8_t>*>(pointer); });
    return py::array(py::dtype::of<std::uint8_t>(), {image.height, image.width, 3}, bytes->data(), owner);
}

/// Every coordinate as it is.
void write_off(const Mesh& mesh, const std::filesystem::path& path) {
    std::ofstream file(path);
    file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n" << std::setprecision(17);
    for (const Vec3& vertex : mesh.vertices) {
        file << vertex.x << ' ' << vertex.y << ' ' << vertex.z << '\n';
    }
    for (const Triangle& triangle : mesh.triangles) {
        file << "3 " << triangle[0] << ' ' << triangle[1] << ' ' << triangle[2] << '\n';
    }
    file.close();
    if (!file) throw ResourceError(path.string() + " cannot be written");
}

/// A packing file names its meshes, so those from memory get files: build_meshes/1.off beside build.json.
Scene with_mesh_files(Scene scene, std::filesystem::path packing_file) {
    const std::filesystem::path folder = packing_file.replace_extension().concat("_meshes");
    for (std::size_t i = 0; i < scene.packing.parts.size(); ++i) {
        PackedPart& part = scene.packing.parts[i];
        if (!part.mesh.empty() || !scene.meshes[i]) continue;
        std::error_code failure;
        std::filesystem::create_directories(folder, failure);
        const std::filesystem::path file = folder / (std::to_string(i + 1) + ".off");
        write_off(*scene.meshes[i], file);
        part.mesh = file.string();
    }
    return scene;
}

std::vector<std::filesystem::path> save(const KeptPacking& kept, const std::filesystem::path& path, int threads) {
    const py::gil_scoped_release release;
    if (path.extension() == ".json") return write_output(with_mesh_files(kept.scene, path), path, threads);
    if (path.extension() == ".html") {
        write_report(kept.scene, path, {}, threads);
        return {path};
    }
    if (!is_output_file(path)) {
        throw UsageError("a packing is saved as one of " + std::string(output_endings()) +
                         " or as a report, .html; not '" + path.string() + "'");
    }
    return write_output(kept.scene, path, threads);
}

std::string packing_text(const KeptPacking& kept) {
    const Metrics& metrics = kept.scene.packing.metrics;
    char density[32];
    std::snprintf(density, sizeof density, "%.1f %%", 100 * metrics.density);
    const std::size_t trays = kept.scene.packing.trays.size();
    return "<spectralpack.Packing: " + std::to_string(metrics.placed) + " of " + std::to_string(metrics.copies) +
           " copies placed in " + std::to_string(trays) + (trays == 1 ? " tray" : " trays") +
           (kept.scene.packing.container.open_height ? "" : std::string(", ") + density + " filled") + ">";
}

}  // namespace

std::string python_name(std::string_view option) {
    std::string name(option);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

void bind_packings(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(PlacementRow, part, copy, tray, number, orientation, fixed, transform);
    py::class_<KeptPacking, std::shared_ptr<KeptPacking>> packing(module, "Packing",
                                                                  "What pack() made of a job, or a packing file.");
    const auto property = [&](const char* name, auto get, const char* doc) {
        packing.def_property_readonly(name, get, doc);
    };
    property(
        "density", [](const KeptPacking& kept) { return kept.scene.packing.metrics.density; },
        "Share of the trays' volume that is filled, 0 to 1.");
    property(
        "height",
        [](const KeptPacking& kept) {
            const auto& trays = kept.scene.packing.trays;
            return trays.empty() ? 0.0 : trays.back().height;
        },
        "Of the last tray's copies, mm.");
    property(
        "placed", [](const KeptPacking& kept) { return kept.scene.packing.metrics.placed; },
        "Copies that have a place.");
    property(
        "placements", [](const KeptPacking& kept) { return placements_of(kept.scene.packing); },
        "A structured array, a row for each copy: part, copy, tray, number (as files and pictures say it), orientation, "
        "fixed, and transform, (4, 4), from the mesh's own coordinates to the tray's, mm.");
    property(
        "parts", [](const KeptPacking& kept) { return packing_parts(kept.scene.packing); }, "A dict for each part.");
    property(
        "trays", [](const KeptPacking& kept) { return trays_of(kept.scene.packing); }, "A dict for each tray.");
    property(
        "left_over", [](const KeptPacking& kept) { return left_over_of(kept.scene.packing); },
        "A dict for each copy that has no place: part, copy, reason (a word) and detail.");
    property(
        "metrics", [](const KeptPacking& kept) { return metrics_of(kept.scene.packing.metrics); },
        "What the run took and came to, as a packing file has it.");
    property(
        "options", [](const KeptPacking& kept) { return options_dict(kept.scene.packing.options); },
        "The options it was made with, by name.");
    property(
        "size", [](const KeptPacking& kept) { return tuple_of(kept.scene.packing.container.size); },
        "Of a tray, mm; without a ceiling the height that was reached.");
    property(
        "input_hash", [](const KeptPacking& kept) { return kept.scene.packing.input_hash; },
        "Equal for equal inputs, which give equal placements.");
    property(
        "stopped",
        [](const KeptPacking& kept) -> py::object {
            if (kept.stopped == StopReason::none) return py::none();
            return py::str(std::string(to_string(kept.stopped)));
        },
        "'cancelled' or 'time_limit' where it is the best that there was by then; else None.");
    property(
        "unusable",
        [](const KeptPacking& kept) {
            py::list list;
            for (const InputError& error : kept.unusable) {
                list.append(exception_of(error));
            }
            return list;
        },
        "An InputError for each input that could not be used; the others are packed.");
    packing
        .def(
            "mesh",
            [](const KeptPacking& kept, int part) { return std::const_pointer_cast<Mesh>(mesh_of(kept, part)); },
            py::arg("part"), "The part's mesh in its own coordinates; None where no copy of it is placed.")
        .def("tray_mesh", &tray_mesh, py::arg("tray") = 0, "All copies of a tray as one mesh, each where it stands.")
        .def("save", &save, py::arg("path"), py::arg("threads") = 0,
             R"(Writes it as the path's ending says: .3mf .stl .json .csv .png, or .html for the operator's report.

Whole or not at all. A .json names its meshes: those that came from memory are written beside it, into a folder
("build_meshes"). Of several trays, a .json holds all; the others are one file for each tray ("build-1.3mf") and the
one named, which shows all side by side. Returns the paths that were written.)")
        .def(
            "json", [](const KeptPacking& kept) { return packing_json(kept.scene); },
            "The text of a packing file (docs/format.md).")
        .def(
            "render",
            [](const KeptPacking& kept, int width, int height, double azimuth, double elevation, int tray,
               std::optional<int> step, std::optional<std::pair<std::string, double>> section,
               std::optional<double> explode, bool marks, bool numbers, int threads) {
                RenderOptions options;
                options.width = width;
                options.height = height;
                options.azimuth = azimuth;
                options.elevation = elevation;
                options.tray = tray;
                options.step = step;
                options.section = section_of(section);
                options.explode = explode;
                options.marks = marks;
                options.numbers = numbers;
                return pixels(picture(kept, options, threads));
            },
            py::arg("width") = 1600, py::arg("height") = 1200, py::kw_only(), py::arg("azimuth") = 35.0,
            py::arg("elevation") = 28.0, py::arg("tray") = -1, py::arg("step") = py::none(),
            py::arg("section") = py::none(), py::arg("explode") = py::none(), py::arg("marks") = true,
            py::arg("numbers") = true, py::arg("threads") = 0,
            R"(A ray-traced picture: (height, width, 3) uint8, the same for any number of threads.

`azimuth` and `elevation`: where the camera stands, degrees. `tray`: from 0; -1: all, side by side. `step`: of the plan,
from 1 on, half way; 0: the whole tray. `section`: ('z', 40.0) cuts away what lies between the camera and that plane, mm.
`explode`: the tray in layers, one above the other. `marks`: scale bar and arrow; `numbers`: those of the copies.)")
        .def(
            "_png",
            [](const KeptPacking& kept, int width, int height, double azimuth, double elevation) {
                RenderOptions options;
                options.width = width;
                options.height = height;
                options.azimuth = azimuth;
                options.elevation = elevation;
                return py::bytes(encode_png(picture(kept, options, 0)));
            },
            py::arg("width"), py::arg("height"), py::arg("azimuth"), py::arg("elevation"))
        .def_static(
            "load",
            [](const std::filesystem::path& path) {
                const py::gil_scoped_release release;
                return std::make_shared<KeptPacking>(KeptPacking{load_scene(path)});
            },
            py::arg("path"), "Reads a packing file (.json) and the meshes that it names. Raises InputError.")
        .def("__repr__", &packing_text);
}

}  // namespace spectralpack::python
