#include "paths.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <map>
#include <system_error>

namespace spectralpack::cli {

namespace fs = std::filesystem;

namespace {

/// The same for all ways to name a file; a link that it is itself is not followed, for it is what would be replaced.
fs::path place_of(const fs::path& path) {
    std::error_code unknown;
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : fs::path("."), unknown);
    return folder / path.filename();
}

/// Which tray's file of `output` it is, from 1 on; 0 for none.
std::int64_t tray_of(const fs::path& output, const fs::path& file) {
    const std::string stem = output.stem().string() + "-", name = file.stem().string();
    if (output.parent_path() != file.parent_path() || output.extension() != file.extension()) return 0;
    if (!name.starts_with(stem)) return 0;
    std::int64_t tray = 0;
    std::from_chars(name.data() + stem.size(), name.data() + name.size(), tray);
    return tray > 0 && tray_file(output, tray) == file ? tray : 0;
}

}  // namespace

void require_writable(const std::string& path, const char* option) {
    spectralpack::require_writable(path, fmt::format("{} {}", option, path));
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

void require_apart(const std::vector<NamedOutput>& outputs) {
    std::map<fs::path, const NamedOutput*> first;
    for (const NamedOutput& output : outputs) {
        const auto [other, fresh] = first.try_emplace(place_of(output.path), &output);
        if (fresh) continue;
        throw UsageError(fmt::format("{} {}: that file is written already, for {} {}; give another name", output.option,
                                     output.path, other->second->option, other->second->path));
    }
}

void require_tray_files(const NamedOutput& output, std::int64_t trays, const std::vector<NamedOutput>& outputs,
                        const std::vector<std::string>& inputs) {
    if (trays < 2 || !has_tray_files(output.path)) return;
    const auto refuse = [&](const std::string& file, const std::string& why) {
        throw UsageError(fmt::format("{} {}: {}, which is the name of a tray's own file, {}", output.option,
                                     output.path, file, why));
    };
    const fs::path place = place_of(output.path);
    for (const NamedOutput& other : outputs) {
        const std::int64_t tray = tray_of(place, place_of(other.path));
        if (tray > 0 && tray <= trays) refuse(other.path, fmt::format("is written for {}, too", other.option));
    }
    for (const std::string& input : inputs) {
        std::error_code unknown;
        const fs::path real = fs::canonical(input, unknown);
        for (const fs::path& named : {place_of(input), unknown ? fs::path() : real}) {
            const std::int64_t tray = tray_of(place, named);
            if (tray > 0 && tray <= trays) refuse(input, "is read and would be lost");
        }
    }
    require_writable(tray_file(output.path, trays).string(), output.option);  // whose name is the longest
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
