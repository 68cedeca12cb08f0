#include <fstream>
#include <map>

#include <spectralpack/spectralpack.hpp>

#include "children/children.hpp"
#include "jobs/job_folder.hpp"
#include "jobs/text_files.hpp"

namespace spectralpack::server {
namespace {

namespace fs = std::filesystem;

/// Copies mesh files into the job's folder, each once, under names that differ.
class Meshes {
  public:
    explicit Meshes(JobFolder job) : job_(std::move(job)) {}

    /// The name it has here.
    std::string take(const std::string& file) {
        const auto known = names_.find(file);
        if (known != names_.end()) return known->second;
        const fs::path path(file);
        std::string name = path.filename().string();
        for (int i = 2; fs::exists(job_.file(name)); ++i) {
            name = path.stem().string() + "-" + std::to_string(i) + path.extension().string();
        }
        fs::copy_file(path, job_.file(name));
        names_.emplace(file, name);
        return name;
    }

  private:
    JobFolder job_;
    std::map<std::string, std::string> names_;
};

/// The packing's parts as a job would ask for them. `file`: the packing file, which has orientations as job files do.
Json job_of(const Packing& packing, const std::vector<std::string>& meshes, const Json& file) {
    Json parts = Json::array();
    for (std::size_t i = 0; i < packing.parts.size(); ++i) {
        const PackedPart& part = packing.parts[i];
        Json one{
            {"name", part.name}, {"mesh", meshes[i]}, {"count", part.count}, {"scale", part.scale}, {"gap", part.gap}};
        const Json& orientations = file.at("parts").at(i).value("orientations", Json());
        if (!orientations.is_null()) one["orientations"] = orientations;
        if (part.object) one["object"] = *part.object;
        if (part.unit == 25.4) one["unit"] = "inch";
        if (part.unit == 1000) one["unit"] = "m";
        if (part.priority != 0) one["priority"] = part.priority;
        if (!part.due.empty()) one["due"] = part.due;
        parts.push_back(std::move(one));
    }
    const Vec3& size = packing.container.size;
    return {{"format", "spectralpack/job"},
            {"version", 1},
            {"container", {{"size", {size.x, size.y, size.z}}}},
            {"open_height", packing.container.open_height},
            {"trays", packing.options.trays == 0 ? Json("all") : Json(packing.options.trays)},
            {"gap", packing.options.gap},
            {"wall_gap", packing.options.wall_gap},
            {"parts", parts}};
}

}  // namespace

int import_packing(const std::vector<std::string>& arguments) {
    const JobFolder job{fs::current_path()};
    Scene scene = load_scene(arguments.at(0));
    Meshes meshes(job);
    std::vector<std::string> names;
    for (PackedPart& part : scene.packing.parts) {
        const std::size_t at = static_cast<std::size_t>(&part - scene.packing.parts.data());
        const bool there = at < scene.meshes.size() && scene.meshes[at];
        names.push_back(there ? meshes.take(part.mesh) : fs::path(part.mesh).filename().string());
        part.mesh = "files/" + names.back();
    }
    Container& container = scene.packing.container;
    if (container.mesh) container.mesh->file = "files/" + meshes.take(container.mesh->file);
    for (KeepOut& keep_out : container.keep_out) {
        if (keep_out.mesh) keep_out.mesh->file = "files/" + meshes.take(keep_out.mesh->file);
    }
    write_text(job.job_file(), job_of(scene.packing, names, read_json(arguments.at(0)).value()).dump(1));
    write_text(job.packing("json"), packing_json(scene));
    return 0;
}

}  // namespace spectralpack::server
