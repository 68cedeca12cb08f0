#pragma once
/// Job files: parts, container and options of one run (docs/format.md, docs/job.schema.json).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spectralpack/job_settings.hpp"

namespace spectralpack {

struct JobFile {
    JobSettings settings;
    std::vector<Part> parts;  ///< `origin`: where each stands in the file ("parts[3]")
};

/// Reads a job file; its paths are relative to itself. Throws InputError naming the key's path
/// ("parts[3].count") for unknown keys and for whatever is missing, of the wrong type or out of
/// range; UsageError ("... is not built yet") with the key's path for what the format foresees and
/// this version cannot do. What it does not say is as in `defaults`.
JobFile read_job(const std::filesystem::path& path, const JobSettings& defaults = {});

/// The same for text at hand.
JobFile parse_job(const std::filesystem::path& path, std::string_view text, const JobSettings& defaults = {});

}  // namespace spectralpack
