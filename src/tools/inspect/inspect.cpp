#include "spectralpack/tools/inspect.hpp"

#include <algorithm>
#include <set>

#include "core/parallel.hpp"
#include "formats/mesh_reader.hpp"
#include "geometry/mesh_repair.hpp"

namespace spectralpack::tools {
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
    const auto unit_hint = size_warning(bounding_box(loaded.mesh), object.unit);
    if (unit_hint) object.unit_hint = unit_hint->one;
    for (const Remark& warning : loaded.warnings) {
        if (warning != unit_hint) object.warnings.push_back(warning.one);  // said once
    }
    const bool turned = std::any_of(object.repairs.begin(), object.repairs.end(),
                                    [](const auto& repair) { return repair.starts_with(kTurned); });
    object.facing = object.figures.edges.misdirected > 0 ? Facing::inconsistent
                    : turned                             ? Facing::turned
                                                         : Facing::outward;
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

}  // namespace

std::vector<InspectedFile> inspect(const ExpandedInputs& inputs, const InspectOptions& options,
                                   const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const Part& part : inputs.parts) {
        if (!part.problem && known.insert(part.mesh.file()).second) names.push_back(part.mesh.file());
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
    for (const Part& part : inputs.parts) {
        if (part.problem) files.push_back({part.problem->file(), part.problem, {}});
    }
    return files;
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

}  // namespace spectralpack::tools
