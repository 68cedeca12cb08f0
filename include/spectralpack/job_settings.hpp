#pragma once
/// What a job file, or the command line of `pack`, says besides the parts.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/job.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/printers.hpp"

namespace spectralpack {

enum class LengthUnit { mm, inch, m };

constexpr double in_mm(LengthUnit unit) { return unit == LengthUnit::m ? 1000 : unit == LengthUnit::inch ? 25.4 : 1; }

/// How the program tells of a run's progress. automatic: a bar on a terminal, nothing elsewhere.
enum class ProgressStyle { automatic, bar, json, none };

/// What a job file says besides its parts (docs/format.md). Where the file is silent: the options' defaults, and
/// nothing for what is the program's own.
struct JobSettings {
    std::string file;                ///< the job file, for messages
    std::optional<LengthUnit> unit;  ///< of mesh files that do not say theirs
    PackOptions options;
    bool sized = false;                            ///< the file says how large the tray is, or by which printer
    bool says_gap = false, says_wall_gap = false;  ///< the same of the gaps
    ContainerSource container;
    std::vector<FixedSource> fixed;
    std::optional<std::string> onto;  ///< a packing file, usable from the working directory
    std::optional<std::string> keep;  ///< likewise

    std::vector<std::string> outputs;        ///< usable from the working directory
    std::vector<std::string> reports;        ///< the same
    std::optional<double> material_density;  ///< g/cm^3
    std::optional<std::string> material;     ///< its name, for the report
    std::optional<std::string> job_name;     ///< the report's heading
    std::optional<ProgressStyle> progress;
    std::optional<bool> dry_run, json, details, skip_unusable, require_all;

    std::vector<Printer> own_printers;     ///< known besides printers(), from the user's files
    std::vector<SettingsSource> defaults;  ///< files of defaults, and what was taken from each
};

/// The options come from elsewhere now, not from files of defaults.
inline void forget_defaults(const std::vector<std::string>& options, JobSettings& settings) {
    for (SettingsSource& source : settings.defaults) {
        std::erase_if(source.options, [&](const std::string& option) {
            return std::find(options.begin(), options.end(), option) != options.end();
        });
    }
    std::erase_if(settings.defaults, [](const SettingsSource& source) { return source.options.empty(); });
}

}  // namespace spectralpack
