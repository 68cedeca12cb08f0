#include "spectralpack/tools/generate.hpp"

#include <fmt/format.h>

#include <system_error>

#include "formats/mesh_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "geometry/mesh_weld.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/mesh_figures.hpp"
#include "tools/generate/segments.hpp"

namespace spectralpack::tools {
namespace {

GeneratedFiles write_parts(const std::vector<GeneratedPart>& parts, GeneratedSet set,
                           const std::filesystem::path& folder, const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw ResourceError("cannot make the folder " + folder.string() + ": " + failure.message());

    GeneratedFiles files;
    files.set_file = folder / (std::string(to_string(set)) + ".csv");
    std::vector<SetRow> rows;
    for (const GeneratedPart& part : parts) {
        rows.push_back({part.name + ".stl", part.count, 1, 0});
        write_stl(part.mesh, folder / rows.back().mesh);
        files.copies += part.count;
        files.volume += part.count * signed_volume(part.mesh);
        files.box_volume += part.count * bounding_box(part.mesh).volume();
        listener.on_progress({Phase::write, static_cast<std::int64_t>(rows.size()),
                              static_cast<std::int64_t>(parts.size()), 0,
                              static_cast<double>(rows.size()) / static_cast<double>(parts.size())});
    }
    files.meshes = static_cast<int>(parts.size());
    write_set(rows, files.set_file);
    return files;
}

/// A set file of the body's pieces alone.
void write_body_set(const std::vector<GeneratedPart>& parts, const std::string& body,
                    const std::filesystem::path& folder) {
    std::vector<SetRow> rows;
    for (const GeneratedPart& part : parts) {
        if (part.name.starts_with(body + "-")) rows.push_back({part.name + ".stl", part.count, 1, 0});
    }
    write_set(rows, folder / (body + ".csv"));
}

/// Where a mesh is open, in its file's coordinates.
void require_closed(const LoadedMesh& loaded, const std::filesystem::path& file) {
    const MeshFigures figures = inspect_mesh(loaded.mesh);
    if (figures.watertight()) return;
    std::string cause = "cannot be cut into closed pieces: the mesh is not closed";
    const auto add = [&](const Vec3& place, const std::string& what) {
        cause += fmt::format("; at ({:.6g}, {:.6g}, {:.6g}) {}", place.x, place.y, place.z, what);
    };
    if (!figures.holes.empty()) {
        add(figures.holes.front().place, fmt::format("{} edges border a hole", figures.holes.front().edges));
    } else if (figures.misdirected_place) {
        add(*figures.misdirected_place, "neighbouring facets face opposite ways");
    }
    throw InputError(file.string(), loaded.object ? "object " + *loaded.object : "", cause);
}

/// As its file will say it: in single precision, without the facets that have no area there.
Mesh written(Mesh mesh) {
    for (Vec3& v : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            v[axis] = static_cast<double>(static_cast<float>(v[axis]));
        }
    }
    weld_equal_vertices(mesh);
    std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return mesh;
}

}  // namespace

GeneratedFiles generate(const GenerateOptions& options, const std::filesystem::path& folder, const Control& control) {
    const std::vector<GeneratedPart> parts = generate_parts(options);
    const GeneratedFiles files = write_parts(parts, options.set, folder, control);
    if (options.set == GeneratedSet::segments) {
        for (const char* body : {kBunny, kMolecule}) {
            write_body_set(parts, body, folder);
        }
    }
    return files;
}

GeneratedFiles generate_segments(const std::filesystem::path& file, const SegmentOptions& options,
                                 const std::filesystem::path& folder, const Control& control) {
    std::vector<GeneratedPart> parts;
    for (const LoadedMesh& loaded : read_meshes(file, options.unit)) {
        require_closed(loaded, file);
        for (const Remark& remark : loaded.warnings) {
            if (control.listener) control.listener->on_warning(file.string() + " " + remark.one);
        }
        const Mesh whole = transformed(loaded.mesh, {loaded.unit.value_or(options.unit) * Mat3{}, {}});
        for (Mesh& piece : cut_into_segments(whole, {options.tray, options.pieces, options.seed})) {
            parts.push_back(
                {segment_name(file.stem().string(), parts.size() + 1), written(std::move(piece)), loaded.instances});
        }
    }
    return write_parts(parts, GeneratedSet::segments, folder, control);
}

}  // namespace spectralpack::tools
