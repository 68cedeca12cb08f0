#include "paths.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace spectralpack::cli {

namespace fs = std::filesystem;

void require_writable(const std::string& path, const char* option) {
    std::error_code unknown;
    const auto folder = fs::path(path).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, unknown)) {
        throw UsageError(fmt::format("{} {}: there is no folder {}", option, path, folder.string()));
    }
    if (fs::is_directory(path, unknown)) throw UsageError(fmt::format("{} {}: that is a folder", option, path));
    if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0) {
        throw UsageError(fmt::format("{} {}: its folder is read-only", option, path));
    }
}

void require_no_input(const std::string& path, const char* option, const std::vector<std::string>& inputs) {
    std::error_code unknown;
    if (!fs::exists(path, unknown)) return;
    for (const std::string& input : inputs) {
        if (fs::equivalent(path, input, unknown)) {
            throw UsageError(
                fmt::format("{} {}: that file is read, too, and would be lost; give another name", option, path));
        }
    }
}

std::vector<std::string> files_of(const ContainerSource& container) {
    std::vector<std::string> files;
    if (container.mesh) files.push_back(container.mesh->file);
    for (const KeepOutSource& keep_out : container.keep_out) {
        if (keep_out.mesh) files.push_back(keep_out.mesh->file);
    }
    return files;
}

void require_picture(const std::string& path) {
    if (ending_of(path) != ".png") {
        throw UsageError(fmt::format("-o {}: a picture's name ends in .png", path));
    }
    require_writable(path, "-o");
}

void require_output(const std::string& path) {
    if (!is_output_file(path)) {
        const std::string ending = fs::path(path).extension().string();
        throw UsageError(
            ending.empty()
                ? fmt::format("-o {}: its name must end in the kind of file: one of {}", path, output_endings())
                : fmt::format("-o {}: no such kind of file. There are {}; {} cannot be written.", path,
                              output_endings(), ending));
    }
    require_writable(path, "-o");
}

}  // namespace spectralpack::cli
