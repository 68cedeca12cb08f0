#include "paths.hpp"

#include <fmt/format.h>

#include <filesystem>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

void require_folder(const std::string& path, const char* option) {
    const auto folder = std::filesystem::path(path).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder)) {
        throw UsageError(fmt::format("{} {}: there is no folder {}", option, path, folder.string()));
    }
}

void require_output_file(const std::string& path) {
    if (is_output_file(path)) return;
    throw UsageError(
        fmt::format("-o {}: cannot tell the kind of file by its ending; use one of {}", path, output_endings()));
}

}  // namespace spectralpack::cli
