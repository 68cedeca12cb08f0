#pragma once
/// Files of defaults for all jobs, and of printers (docs/settings.md).

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "spectralpack/job_settings.hpp"

namespace spectralpack {

/// Sets what the files say over `settings`: first what holds without a profile, in the order of the files, then their
/// profiles of that name, likewise; notes what was taken from where. Printers come from printers.json beside each file;
/// a later one of the same name takes an earlier one's place. Throws InputError naming file and key path, UsageError
/// for a profile that none of the files has.
void read_settings(std::span<const std::filesystem::path> files, const std::string& profile, JobSettings& settings);

/// The printers of such a file.
std::vector<Printer> read_printers(const std::filesystem::path& path);

/// The file's text for these.
std::string printers_to_json(std::span<const Printer> printers);

}  // namespace spectralpack
