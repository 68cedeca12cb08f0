#include "spectralpack/inspect.hpp"

#include <algorithm>
#include <set>

#include "core/parallel.hpp"
#include "formats/json_text.hpp"
#include "formats/mesh_reader.hpp"
#include "geometry/mesh_repair.hpp"

namespace spectralpack {
namespace {

/// How the words of a repair begin that turned facets (geometry/mesh_repair.cpp).
constexpr std::string_view kTurned = "turned ";

InspectedObject inspect_object(LoadedMesh loaded, const InspectOptions& options) {
    InspectedObject object;
    object.name = std::move(loaded.name);
    object.object = std::move(loaded.object);
    object.instances = loaded.instances;
    object.unit = loaded.unit.value_or(options.unit);
    object.unit_known = loaded.unit.has_value();
    object.figures =
        inspect_mesh(object.unit == 1 ? loaded.mesh : transformed(loaded.mesh, {object.unit * Mat3{}, {}}));
    object.repairs = std::move(loaded.repairs);
    object.warnings = std::move(loaded.warnings);
    object.unit_hint = size_warning(bounding_box(loaded.mesh), object.unit);
    if (object.unit_hint) std::erase(object.warnings, *object.unit_hint);  // said once
    const bool turned = std::any_of(object.repairs.begin(), object.repairs.end(),
                                    [](const auto& repair) { return repair.starts_with(kTurned); });
    object.orientation = object.figures.edges.misdirected > 0 ? Orientation::inconsistent
                         : turned                             ? Orientation::turned
                                                              : Orientation::outward;
    if (options.keep_meshes) object.mesh = std::make_shared<const Mesh>(std::move(loaded.mesh));
    return object;
}

InspectedFile inspect_file(const std::string& name, const InspectOptions& options) {
    InspectedFile file{name, {}, {}};
    try {
        for (LoadedMesh& loaded : read_meshes(name, options.unit)) {
            file.objects.push_back(inspect_object(std::move(loaded), options));
        }
    } catch (const InputError& error) {
        file.unusable = error;
        file.objects.clear();
    }
    return file;
}

std::string flag(bool value) { return value ? "true" : "false"; }

std::string number(std::size_t value) { return std::to_string(value); }

std::string vector_json(const Vec3& v) {
    return "[" + json_number(v.x) + ", " + json_number(v.y) + ", " + json_number(v.z) + "]";
}

std::string place_json(const std::optional<Vec3>& place) { return place ? vector_json(*place) : "null"; }

/// "[a, b]" of texts that are JSON already.
template <class List, class Text>
std::string list_json(const List& list, const Text& text) {
    std::string joined;
    for (const auto& item : list) {
        joined += (joined.empty() ? "" : ", ") + text(item);
    }
    return "[" + joined + "]";
}

std::string object_json(const InspectedObject& object) {
    const MeshFigures& f = object.figures;
    const auto hole = [](const BorderLoop& loop) {
        return "{\"place\": " + vector_json(loop.place) + ", \"length\": " + json_number(loop.length) +
               ", \"edges\": " + number(loop.edges) + "}";
    };
    return "{\"name\": " + json_string(object.name) +
           ", \"object\": " + (object.object ? json_string(*object.object) : "null") +
           ", \"instances\": " + std::to_string(object.instances) + ", \"unit\": " + json_number(object.unit) +
           ", \"unit_known\": " + flag(object.unit_known) + ", \"size\": " + vector_json(f.box.size()) +
           ", \"box\": [" + vector_json(f.box.min) + ", " + vector_json(f.box.max) + "]" +
           ", \"volume\": " + json_number(f.volume) + ", \"area\": " + json_number(f.area) +
           ", \"triangles\": " + number(f.triangles) + ", \"vertices\": " + number(f.vertices) +
           ", \"shells\": " + number(f.shells) + ", \"watertight\": " + flag(f.watertight()) +
           ", \"border\": {\"edges\": " + number(f.edges.border) + ", \"loops\": " + number(f.border_loops) +
           ", \"longest\": " + list_json(f.holes, hole) +
           "}, \"orientation\": " + json_string(orientation_name(object.orientation)) +
           ", \"misdirected\": {\"edges\": " + number(f.edges.misdirected) +
           ", \"place\": " + place_json(f.misdirected_place) +
           "}, \"non_manifold\": {\"edges\": " + number(f.edges.crowded) +
           ", \"place\": " + place_json(f.crowded_place) +
           "}, \"self_intersections\": {\"pairs\": " + std::to_string(f.crossings.pairs) +
           ", \"complete\": " + flag(f.crossings.complete) + ", \"place\": " + place_json(f.crossings.place) +
           "}, \"duplicates\": " + number(f.duplicates) +
           ", \"unit_hint\": " + (object.unit_hint ? json_string(*object.unit_hint) : "null") +
           ", \"repairs\": " + list_json(object.repairs, json_string) +
           ", \"warnings\": " + list_json(object.warnings, json_string) + "}";
}

std::string file_json(const InspectedFile& file) {
    std::string text = "{\"file\": " + json_string(file.file) + ", \"usable\": " + flag(!file.unusable);
    if (file.unusable) {
        return text + ", \"place\": " + json_string(file.unusable->place()) +
               ", \"cause\": " + json_string(file.unusable->cause()) + "}";
    }
    return text + ", \"objects\": " + list_json(file.objects, object_json) + "}";
}

}  // namespace

std::vector<InspectedFile> inspect(const ExpandedInputs& inputs, const InspectOptions& options, Listener& listener) {
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const Part& part : inputs.parts) {
        if (known.insert(part.mesh.file()).second) names.push_back(part.mesh.file());
    }
    std::vector<InspectedFile> files(names.size());
    const Workers workers(options.threads);
    const auto batch = static_cast<std::size_t>(4 * workers.threads());
    for (std::size_t begin = 0; begin < files.size(); begin += batch) {
        const std::size_t end = std::min(files.size(), begin + batch);
        workers.for_each(static_cast<std::int64_t>(end - begin), [&](std::int64_t i) {
            const std::size_t at = begin + static_cast<std::size_t>(i);
            files[at] = inspect_file(names[at], options);
        });
        listener.on_progress({Phase::load, static_cast<std::int64_t>(end), static_cast<std::int64_t>(files.size()), 0,
                              static_cast<double>(end) / static_cast<double>(files.size())});
    }
    for (const InputError& error : inputs.unusable) {
        files.push_back({error.file(), error, {}});
    }
    return files;
}

std::string inspection_json(const std::vector<InspectedFile>& files) {
    std::size_t unusable = 0;
    std::string text;
    for (const InspectedFile& file : files) {
        unusable += file.unusable ? 1 : 0;
        text += (text.empty() ? "\n" : ",\n") + file_json(file);
    }
    return "{\"usable\": " + number(files.size() - unusable) + ", \"unusable\": " + number(unusable) +
           ", \"files\": [" + text + "\n]}";
}

Scene inspection_scene(const std::vector<InspectedFile>& files) {
    Scene scene;
    std::vector<Box> boxes;
    for (const InspectedFile& file : files) {
        for (const InspectedObject& object : file.objects) {
            if (!object.mesh) continue;
            PackedPart part;
            part.id = static_cast<int>(scene.meshes.size());
            part.name = object.name;
            part.mesh = file.file;
            part.unit = object.unit;
            scene.packing.parts.push_back(std::move(part));
            scene.meshes.push_back(object.mesh);
            boxes.push_back(object.figures.box);
            scene.packing.container.size = max(scene.packing.container.size, boxes.back().size());
        }
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Vec3 corner = 0.5 * (scene.packing.container.size - boxes[i].size());
        corner.z = 0;
        TrayPacking tray;
        tray.placements.push_back(
            {static_cast<int>(i), 0, 0, false, {scene.packing.parts[i].unit * Mat3{}, corner - boxes[i].min}});
        scene.packing.trays.push_back(std::move(tray));
    }
    return scene;
}

const char* orientation_name(Orientation orientation) {
    switch (orientation) {
        case Orientation::outward:
            return "outward";
        case Orientation::turned:
            return "turned";
        case Orientation::inconsistent:
            return "inconsistent";
    }
    return "";
}

}  // namespace spectralpack
