#pragma once
/// Defaults from the user's and the project's files.

#include <filesystem>
#include <string>
#include <vector>

#include "pack_arguments.hpp"

namespace spectralpack::cli {

/// The files of settings that count for this run (docs/settings.md): the user's and the project's, those of them that
/// are there, or the one that --config names, or none with --no-config. Throws UsageError where a file that was named
/// is not there.
std::vector<std::filesystem::path> settings_files(const PackArguments& arguments);

/// What they say, with --profile. Throws as read_defaults() does, too.
JobSettings default_settings(const PackArguments& arguments);

/// "gap, voxel from spectralpack.json; printer from its profile pa12"; empty where nothing came from files.
std::string origin_text(const std::vector<SettingsSource>& defaults);

}  // namespace spectralpack::cli
