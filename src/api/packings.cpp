#include "spectralpack/files.hpp"

#include <filesystem>
#include <map>
#include <system_error>

#include "api/load_container.hpp"
#include "api/sheet_pictures.hpp"
#include "core/atomic_file.hpp"
#include "core/stopped.hpp"
#include "formats/mesh_reader.hpp"
#include "formats/packing_file.hpp"
#include "formats/report/report.hpp"
#include "render/render.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/printers.hpp"
#include "spectralpack/typed_text.hpp"
#include "verify/check.hpp"

namespace spectralpack {
namespace {

/// The object of a mesh file that a part names.
LoadedMesh* find_object(std::vector<LoadedMesh>& meshes, const PackedPart& part) {
    for (LoadedMesh& loaded : meshes) {
        if (loaded.object == part.object && loaded.item_transform == part.item_transform) return &loaded;
    }
    return nullptr;
}

/// Who loads the vessel adds it again.
bool is_vessel_itself(const Container& container, const KeepOut& keep_out) {
    return container.is == ContainerIs::vessel && keep_out.mesh && keep_out.mesh->file == container.mesh->file &&
           keep_out.mesh->transform == container.mesh->transform;
}

}  // namespace

Scene load_scene(const std::filesystem::path& packing_file) {
    Scene scene{read_packing(packing_file), {}};
    scene.meshes.resize(scene.packing.parts.size());
    std::vector<bool> placed(scene.packing.parts.size(), false);
    for (const TrayPacking& tray : scene.packing.trays) {
        for (const Placement& placement : tray.placements) {
            placed[static_cast<std::size_t>(placement.part)] = true;
        }
    }
    struct File {
        std::vector<LoadedMesh> loaded;
        std::map<const LoadedMesh*, std::shared_ptr<const Mesh>> shared;
    };
    std::map<std::string, File> files;
    for (std::size_t i = 0; i < scene.packing.parts.size(); ++i) {
        if (!placed[i]) continue;
        const PackedPart& part = scene.packing.parts[i];
        const auto [file, fresh] = files.try_emplace(part.mesh);
        std::error_code failure;
        if (fresh && !std::filesystem::exists(part.mesh, failure)) {
            throw InputError(part.mesh, "",
                             "is not there: " + packing_file.string() +
                                 " names its meshes relative to itself, so they move together");
        }
        if (fresh) file->second.loaded = read_meshes(part.mesh);
        LoadedMesh* object = find_object(file->second.loaded, part);
        if (!object) {
            throw InputError(part.mesh, "object " + part.object.value_or("?"),
                             "the packing " + packing_file.string() +
                                 " places it, but the file does not "
                                 "hold it in this form");
        }
        auto& mesh = file->second.shared[object];
        if (!mesh) mesh = std::make_shared<const Mesh>(std::move(object->mesh));
        scene.meshes[i] = mesh;
    }
    load_surfaces(scene.packing.container);
    return scene;
}

ContainerSource container_source(const Packing& packing) {
    const auto source_of = [](const StandingMesh& mesh) { return MeshSource{mesh.file, "", mesh.transform}; };
    ContainerSource source;
    const Container& container = packing.container;
    if (container.mesh) {
        source.mesh = source_of(*container.mesh);
        source.is = container.is;
    }
    for (const KeepOut& keep_out : container.keep_out) {
        if (is_vessel_itself(container, keep_out)) continue;
        source.keep_out.push_back({keep_out.box});
        if (keep_out.mesh) source.keep_out.back().mesh = source_of(*keep_out.mesh);
    }
    source.physical = container.physical;
    return source;
}

CheckReport check(const Scene& scene, int threads, const Control& control) {
    Listener quiet;
    return check_packing(scene.packing, scene.meshes, Workers(threads), control.listener ? *control.listener : quiet,
                         control.stop);
}

const char* output_endings() { return ".json .3mf .stl .csv .png"; }

bool is_output_file(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".json" || ending == ".3mf" || ending == ".stl" || ending == ".csv" || ending == ".png";
}

namespace {

/// `first`: the number of its first tray.
void write_one(const Scene& scene, const std::filesystem::path& path, std::size_t first, int threads,
               const DrawingTime& time) {
    const std::string ending = ending_of(path);
    if (ending == ".json") {
        write_packing(scene.packing, path);
    } else if (ending == ".3mf") {
        write_3mf(scene.packing, scene.meshes, path);
    } else if (ending == ".stl") {
        write_stl(scene.packing, scene.meshes, path);
    } else if (ending == ".csv") {
        write_transforms_csv(scene.packing, path, first);
    } else if (ending == ".png") {
        write_png(render(scene.packing, scene.meshes, {}, Workers(threads), time), path);
    } else {
        throw UsageError("cannot tell the kind of " + path.string() + " by its ending: use one of " + output_endings());
    }
}

/// `single` is for scenes of one tray of `scene`.
std::filesystem::path write_tray_file(const Scene& scene, std::size_t tray, const std::filesystem::path& path,
                                      int threads, const DrawingTime& time, Scene& single) {
    single.packing.trays = {scene.packing.trays[tray]};
    std::filesystem::path file = tray_file(path, static_cast<std::int64_t>(tray) + 1);
    write_one(single, file, tray + 1, threads, time);
    return file;
}

}  // namespace

std::filesystem::path write_tray(const Scene& scene, std::size_t tray, const std::filesystem::path& path, int threads) {
    if (ending_of(path) == ".json") {
        write_one(scene, path, 1, threads, {});
        return path;
    }
    Scene single = scene;
    return write_tray_file(scene, tray, path, threads, {}, single);
}

std::vector<std::filesystem::path> write_output(const Scene& scene, const std::filesystem::path& path, int threads,
                                                const DrawingTime& time) {
    std::vector<std::filesystem::path> written;
    const std::size_t trays = scene.packing.trays.size();
    try {
        write_one(scene, path, 1, threads, time);
        written.push_back(path);
        if (trays < 2 || !has_tray_files(path)) return written;
        Scene single = scene;
        for (std::size_t tray = 0; tray < trays; ++tray) {
            written.push_back(write_tray_file(scene, tray, path, threads, time, single));
        }
    } catch (const Stopped&) {  // a picture
    }
    return written;
}

bool is_report_file(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".html" || ending == ".csv";
}

int write_report(const Scene& scene, const std::filesystem::path& path, const ReportDetails& details, int threads,
                 const DrawingTime& time) {
    if (!is_report_file(path)) {
        throw UsageError("cannot tell the kind of report " + path.string() + " by its ending: use .html or .csv");
    }
    if (ending_of(path) == ".csv") {
        replace_file(path, report_csv(scene.packing, details.material_density));
        return 0;
    }
    ReportContents contents;
    contents.job_name = details.job_name.empty() ? path.stem().string() : details.job_name;
    contents.date = details.date;
    contents.material = details.material;
    contents.material_density = details.material_density;
    if (const Printer* printer = find_printer(scene.packing.options.printer.value_or("")))
        contents.printer = printer->title;
    const int left_out = add_pictures(scene, contents, Workers(threads), time);
    replace_file(path, report_html(scene.packing, contents));
    return left_out;
}

Image render(const Scene& scene, const RenderOptions& options, int threads) {
    return render(scene.packing, scene.meshes, options, Workers(threads));
}

void write_picture(const Scene& scene, const std::filesystem::path& path, const RenderOptions& options, int threads) {
    write_png(render(scene.packing, scene.meshes, options, Workers(threads)), path);
}

}  // namespace spectralpack
