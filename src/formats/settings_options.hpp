#pragma once
/// The object of options in job files and files of defaults.

#include <filesystem>
#include <string>
#include <vector>

#include "formats/json_node.hpp"
#include "spectralpack/job_settings.hpp"

namespace spectralpack {

/// Sets what the object names, by the options' names on the command line; paths in it are relative to `folder`. A
/// printer (also one of the settings' own) is applied first, so that what stands beside it overrides its values.
/// Returns the names of all that was set, a printer's tray and gaps among them. Complains of keys that are no option
/// that files may hold.
std::vector<std::string> read_settings_options(const Node& node, const std::filesystem::path& folder,
                                               JobSettings& settings);

}  // namespace spectralpack
