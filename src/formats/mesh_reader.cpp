#include "formats/mesh_reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "formats/file_bytes.hpp"
#include "formats/mesh_parsers.hpp"
#include "geometry/mesh_repair.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

using Parser = std::vector<ParsedMesh> (*)(const MeshBytes&);

constexpr std::pair<std::string_view, Parser> kParsers[] = {{".stl", parse_stl}, {".obj", parse_obj},
                                                            {".3mf", parse_3mf}, {".ply", parse_ply},
                                                            {".off", parse_off}, {".binvox", parse_binvox}};

Parser parser_by_ending(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    for (const auto& [known, parser] : kParsers) {
        if (ending == known) return parser;
    }
    return nullptr;
}

/// Formats that say what they are; a wrong ending does not matter then.
Parser parser_by_content(std::string_view bytes) {
    if (bytes.starts_with("PK\x03\x04")) return parse_3mf;
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return parse_ply;
    if (bytes.starts_with("#binvox")) return parse_binvox;
    if (bytes.starts_with("OFF\n") || bytes.starts_with("OFF\r")) return parse_off;
    return nullptr;
}

void repair(ParsedMesh& parsed, const std::string& file, double default_unit, const StopToken& stop) {
    LoadedMesh& loaded = parsed.loaded;
    MeshRepair outcome = repair_mesh(loaded.mesh, parsed.welded, stop);
    if (outcome.unusable) {
        throw InputError(file, loaded.object ? "object " + *loaded.object : "", *outcome.unusable);
    }
    std::move(outcome.repairs.begin(), outcome.repairs.end(), std::back_inserter(loaded.repairs));
    std::move(outcome.warnings.begin(), outcome.warnings.end(), std::back_inserter(loaded.warnings));
    if (auto hint = size_warning(outcome.box, loaded.unit.value_or(default_unit))) {
        loaded.warnings.push_back(std::move(*hint));
    }
}

}  // namespace

std::vector<LoadedMesh> read_meshes(const std::filesystem::path& path, double default_unit, const StopToken& stop) {
    const FileBytes bytes(path, stop);
    Parser parser = parser_by_content(bytes.view());
    if (!parser) parser = parser_by_ending(path);
    if (parser && bytes.view().empty()) throw InputError(path.string(), "", "the file is empty");
    if (!parser) {
        throw InputError(path.string(), "", "is not of a format that can be read (STL, OBJ, 3MF, PLY, OFF, binvox)");
    }
    std::vector<LoadedMesh> meshes;
    for (ParsedMesh& parsed : parser({path.string(), path.stem().string(), bytes.view(), stop})) {
        if (parsed.loaded.name.empty()) parsed.loaded.name = path.stem().string();
        repair(parsed, path.string(), default_unit, stop);
        meshes.push_back(std::move(parsed.loaded));
    }
    return meshes;
}

LoadedMesh adopt_mesh(Mesh mesh, const std::string& name, double unit, const StopToken& stop) {
    if (mesh.triangles.empty()) throw InputError(name, "", "has no triangles");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3& v = mesh.vertices[i];
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
            throw InputError(name, "vertex " + std::to_string(i), "has a coordinate that is not finite");
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t vertex : mesh.triangles[i]) {
            if (vertex >= mesh.vertices.size()) {
                throw InputError(
                    name, "triangle " + std::to_string(i),
                    "names vertex " + std::to_string(vertex) + " of " + std::to_string(mesh.vertices.size()));
            }
        }
    }
    ParsedMesh parsed;
    parsed.loaded.mesh = std::move(mesh);
    parsed.loaded.name = name;
    repair(parsed, name, unit, stop);
    return std::move(parsed.loaded);
}

bool is_mesh_file(const std::filesystem::path& path) { return parser_by_ending(path) != nullptr; }

}  // namespace spectralpack
