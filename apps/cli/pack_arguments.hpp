#pragma once
/// The words of `pack` on the command line, and what they say over the job file.

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

struct PackArguments {
    std::vector<std::string> parts;
    /// By the names of options, those that were given; a flag's text is "true" or "false".
    std::map<std::string_view, std::vector<std::string>> given;

    bool has(std::string_view name) const { return given.contains(name); }
    /// Empty where it was not given.
    std::string text(std::string_view name) const { return has(name) ? given.at(name).front() : ""; }
};

/// Has the command line read into `arguments`, which must outlive `app`; with a line of help for each option.
void add_pack_options(CLI::App& app, PackArguments& arguments);

/// `settings`, those of a job file or the defaults, with what the command line says over them. Throws UsageError for
/// words that no option takes.
JobSettings override_settings(JobSettings settings, const PackArguments& arguments);

/// What a job has from the build that it tops up.
struct TakenOver {
    std::string file;  ///< the build's; empty where there is none
    bool container = false, gap = false, wall_gap = false;
    std::vector<std::string> remarks;  ///< on what is said otherwise than the build has it
};

/// The container and the gaps: what the command line says, else the job file, else those of the build to be topped up.
/// `settings` are the job file's, overridden. Throws as load_scene() does, and UsageError.
TakenOver settle_container(const PackArguments& arguments, const JobSettings& settings, Job& job);

}  // namespace spectralpack::cli
