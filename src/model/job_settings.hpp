#pragma once
/// What a job file says besides its parts (docs/format.md).

#include <optional>
#include <string>
#include <vector>

#include "model/container_source.hpp"
#include "model/options.hpp"

namespace spectralpack {

/// Where the file is silent: the options' defaults, and nothing for what is the program's own.
struct JobSettings {
    std::string file;            ///< the job file, for messages
    std::optional<double> unit;  ///< mm per unit for mesh files that do not say theirs
    PackOptions options;
    bool sized = false;  ///< the file says how large the tray is, or by which printer
    ContainerSource container;
    std::vector<FixedSource> fixed;
    std::optional<std::string> onto;  ///< a packing file, usable from the working directory

    std::vector<std::string> outputs;        ///< usable from the working directory
    std::optional<std::string> report;       ///< the same
    std::optional<double> material_density;  ///< g/cm^3
    std::optional<std::string> progress;
    std::optional<bool> dry_run, json, skip_unusable, require_all;
};

}  // namespace spectralpack
