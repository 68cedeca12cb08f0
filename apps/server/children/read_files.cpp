#include <array>
#include <fstream>
#include <sstream>

#include <spectralpack/spectralpack.hpp>
#include <spectralpack/tools/inspect.hpp>
#include <spectralpack/tools/simplify.hpp>

#include "children/children.hpp"
#include "children/mesh_record.hpp"
#include "jobs/job_folder.hpp"
#include "jobs/names.hpp"
#include "jobs/text_files.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

/// How finely meshes to look at are drawn, in the order of kMeshDetails.
struct Fineness {
    std::size_t triangles;  // at most, unless the error would be larger
    double error;           // of the mesh's longest side
};
constexpr std::array<Fineness, kMeshDetails.size()> kFineness{{{120, 0.05}, {800, 0.03}, {20000, 0.002}}};
constexpr std::uint32_t kMostObjects = 1000;  // of a file

Json error_json(const InputError& error) {
    return {{"error", error.cause()}, {"place", error.place().empty() ? Json() : Json(error.place())}};
}

/// What openapi.json calls a Mesh, of what `inspect --json` says of an object.
Json mesh_json(std::uint32_t id, const std::string& file, const Json& object) {
    Json mesh{{"id", id}, {"file", file}};
    for (const char* key : {"object", "name", "instances", "unit", "unit_known", "unit_hint", "size", "box", "volume",
                            "triangles", "watertight", "shells", "repairs", "warnings"}) {
        mesh[key] = object.at(key);
    }
    return mesh;
}

void write_meshes(const fs::path& path, const std::vector<tools::InspectedObject>& objects, std::uint32_t first,
                  const Fineness& fineness) {
    std::ostringstream records;
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
        const Mesh& mesh = *objects[i].mesh;
        const auto [triangles, error] = fineness;
        const bool small = mesh.triangles.size() <= triangles;
        write_mesh_record(records, first + i, small ? mesh : tools::simplified(mesh, triangles, error));
    }
    write_text(path, records.str());
}

Json read_meshes(const JobFolder& job, const std::string& name, std::uint32_t number) {
    ExpandedInputs inputs;
    Part part;
    part.mesh = job.file(name).string();
    inputs.parts.push_back(std::move(part));
    tools::InspectOptions options;
    options.keep_meshes = true;
    std::vector<tools::InspectedFile> files = tools::inspect(inputs, options);
    tools::InspectedFile& file = files.front();
    if (file.unusable) return error_json(*file.unusable);
    if (file.objects.size() > kMostObjects) {
        return {{"error", "it holds more than 1000 objects"}, {"place", nullptr}};
    }
    const std::uint32_t first = number * kMostObjects;
    for (std::size_t i = 0; i < kMeshDetails.size(); ++i) {
        write_meshes(job.meshes(name, kMeshDetails[i]), file.objects, first, kFineness[i]);
    }
    const Json inspected = Json::parse(tools::inspection_json(files));
    Json meshes = Json::array();
    for (const Json& object : inspected.at("files").at(0).at("objects")) {
        meshes.push_back(mesh_json(first + static_cast<std::uint32_t>(meshes.size()), name, object));
    }
    return {{"meshes", meshes}};
}

/// Meshes are sent without their folders.
std::string base_name(const std::string& path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

Json rows_of(const ExpandedInputs& inputs) {
    Json rows = Json::array();
    for (const Part& part : inputs.parts) {
        rows.push_back({{"mesh", base_name(part.mesh.file())},
                        {"name", part.name},
                        {"count", part.count},
                        {"scale", part.scale},
                        {"gap", part.gap ? Json(*part.gap) : Json()},
                        {"priority", part.priority},
                        {"due", part.due.empty() ? Json() : Json(part.due)}});
    }
    return rows;
}

Json read_set(const JobFolder& job, const std::string& name) {
    const ExpandedInputs inputs = expand_inputs({job.file(name).string()}, "");
    for (const Part& part : inputs.parts) {
        if (part.mesh.file().empty() && part.problem) return error_json(*part.problem);
    }
    return {{"kind", "set"}, {"rows", rows_of(inputs)}, {"job", nullptr}};
}

void shorten_paths(Json& value) {
    if (value.is_object() && value.contains("mesh") && value["mesh"].is_string()) {
        value["mesh"] = base_name(value["mesh"].get<std::string>());
    }
    if (!value.is_structured()) return;
    for (Json& inner : value) {
        shorten_paths(inner);
    }
}

Json read_job(const JobFolder& job, const std::string& name) {
    const ExpandedInputs inputs = expand_inputs({job.file(name).string()}, "");  // throws where it is no job file
    std::optional<Json> said = read_json(job.file(name));
    if (!said) return {{"error", "it is no JSON"}, {"place", nullptr}};
    shorten_paths(*said);
    return {{"kind", "job"}, {"rows", rows_of(inputs)}, {"job", *said}};
}

Json read(const JobFolder& job, const std::string& name, std::uint32_t number) {
    try {
        switch (kind_of(name)) {
            case FileKind::mesh:
                return read_meshes(job, name, number);
            case FileKind::set:
                return read_set(job, name);
            case FileKind::job:
                return read_job(job, name);
            case FileKind::other:
                break;
        }
    } catch (const InputError& error) {
        return error_json(error);
    } catch (const Error& error) {
        return {{"error", error.what()}, {"place", nullptr}};
    }
    const std::size_t dot = name.rfind('.');
    return {{"error", dot == std::string::npos
                          ? "a file without an ending is not read: name it .stl, .3mf, .obj, .ply or .off"
                          : name.substr(dot) + " files are not read: export it as 3MF or STL"},
            {"place", nullptr}};
}

}  // namespace

int read_files(const std::vector<std::string>& arguments) {
    const JobFolder job{"."};
    for (std::size_t i = 0; i + 1 < arguments.size(); i += 2) {
        const std::string& name = arguments[i + 1];
        const Json found = read(job, name, static_cast<std::uint32_t>(std::stoul(arguments[i])));
        write_text(job.preview(name), found.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
    return 0;
}

}  // namespace spectralpack::server
