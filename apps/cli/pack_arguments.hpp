#pragma once
/// The words of `pack` on the command line, and what they say over the job file.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// Defaults that stand in PackOptions are not repeated: an option that is not given leaves what the job file says, or
/// the default.
struct PackArguments {
    std::vector<std::string> parts;
    std::string mesh_dir;
    std::optional<std::string> unit, tray, trays, container, printer, onto, rotations, interlock, links, take_out,
        height_penalty, height_at, order, engine, memory, verify_with, progress, report;
    std::optional<std::string> minimise;
    std::optional<double> max_density, max_layer_fill;
    bool open_height = false, fill = false;
    std::optional<double> gap, wall_gap, voxel, ray_spacing, time_limit, material_density;
    std::optional<std::uint64_t> seed;
    std::optional<int> threads, try_per_tray, detail, restarts, beam;
    std::vector<std::string> keep_out;
    bool physical = false;
    std::vector<std::string> outputs;
    bool refine = false, no_refine = false;
    bool dry_run = false, json = false, skip_unusable = false, require_all = false;
};

/// Has the command line read into `arguments`, which must outlive `app`; with the help for each option.
void add_pack_options(CLI::App& app, PackArguments& arguments);

/// `options` with what the command line says over it. Throws UsageError for words that no option takes.
PackOptions override_options(PackOptions options, const PackArguments& arguments);

/// The container: what the command line says, else the job file, else that of the build to be topped up. Throws as
/// load_scene() does, and UsageError.
void settle_container(const PackArguments& arguments, const JobSettings& file, Job& job);

}  // namespace spectralpack::cli
