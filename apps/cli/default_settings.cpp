#include "default_settings.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

namespace spectralpack::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProjectFile = "spectralpack.json";

/// Where the user's own file is, or would be; empty where there is no home.
fs::path user_file() {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        return fs::path(value ? value : "");
    };
    fs::path config = folder("XDG_CONFIG_HOME");
    if (!config.is_absolute()) {  // as the XDG base directory specification has it
        const fs::path home = folder("HOME");
        if (home.empty()) return {};
        config = home / ".config";
    }
    return config / "spectralpack" / "config.json";
}

}  // namespace

std::vector<fs::path> settings_files(const PackArguments& arguments) {
    if (arguments.has("no-config")) {
        if (arguments.has("config")) throw UsageError("--config and --no-config do not go together");
        return {};
    }
    if (arguments.has("config")) {
        const std::string file = arguments.text("config");
        if (!fs::is_regular_file(file)) throw UsageError(fmt::format("--config {}: there is no such file", file));
        return {file};
    }
    std::vector<fs::path> files;
    for (const fs::path& file : {user_file(), fs::path(kProjectFile)}) {
        std::error_code unknown;
        if (!file.empty() && fs::is_regular_file(file, unknown)) files.push_back(file);
    }
    return files;
}

JobSettings default_settings(const PackArguments& arguments) {
    return read_defaults(settings_files(arguments), arguments.text("profile"));
}

std::string origin_text(const std::vector<SettingsSource>& defaults) {
    std::string text;
    for (const SettingsSource& source : defaults) {
        text += fmt::format("{}{} from {}{}", text.empty() ? "" : "; ", fmt::join(source.options, ", "), source.file,
                            source.profile.empty() ? "" : fmt::format(", profile {}", source.profile));
    }
    return text;
}

}  // namespace spectralpack::cli
