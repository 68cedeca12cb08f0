#include "api/folder_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "formats/mesh_reader.hpp"
#include "formats/threemf_origin.hpp"

namespace spectralpack {

namespace fs = std::filesystem;

namespace {

/// How the names begin of files that macOS puts beside those of its own: they hold no mesh, whatever their ending.
constexpr const char* kOfMacOs = "._";

}  // namespace

FolderInputs inputs_in(const std::string& folder) {
    FolderInputs inputs;
    std::error_code failure;
    for (auto entry = fs::recursive_directory_iterator(folder, failure);
         !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
        const fs::path& path = entry->path();
        std::error_code broken;
        const bool is_folder = fs::is_directory(fs::status(path, broken));
        const std::string name = path.filename().string();
        if (is_folder && name.starts_with('.')) {
            entry.disable_recursion_pending();
        } else if (!is_mesh_file(path) || name.starts_with(kOfMacOs)) {
            if (!is_folder && !name.starts_with('.')) inputs.passed_over.push_back(path.string());
        } else if (broken) {  // a symbolic link that leads nowhere or in circles
            inputs.unusable.emplace_back(path.string(), "", broken.message());
        } else if (is_folder) {
            inputs.unusable.emplace_back(path.string(), "", "is a folder with the name of a mesh file");
        } else if (is_own_build(path)) {
            inputs.own_builds.push_back(path.string());
        } else {
            inputs.meshes.push_back(path.string());
        }
    }
    if (failure) {
        inputs.unusable.emplace_back(folder, "", failure.message());
    } else if (inputs.meshes.empty()) {
        inputs.unusable.emplace_back(folder, "", "the folder holds no mesh files");
    }
    for (std::vector<std::string>* list : {&inputs.meshes, &inputs.passed_over, &inputs.own_builds}) {
        std::ranges::sort(*list);
    }
    return inputs;
}

}  // namespace spectralpack
