#pragma once
/// Files in and out: what a user names as input, packings on disk, reports. Everything else works in memory.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/job.hpp"
#include "spectralpack/job_settings.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/render.hpp"

namespace spectralpack {

struct ExpandedInputs {
    std::vector<Part> parts;               ///< also those that cannot be used, with their problem
    std::optional<JobSettings> job;        ///< what a job file among them says besides its parts
    std::vector<std::string> passed_over;  ///< files in folders that are no meshes; hidden ones are not told
    std::vector<std::string> remarks;      ///< how files were read that say it in an uncommon way
    std::vector<std::string> own_builds;   ///< 3MF files in folders that this program wrote: builds, no parts
};

/// Each argument is a mesh file, `FILE:COUNT`, `FILE@SCALE`, `FILE:COUNT@SCALE`, a folder of meshes (searched through,
/// sorted bytewise), a set file (.csv; its paths are relative to `mesh_dir`, or to the set file when that is empty) or
/// a job file (.json, one at most). A file whose name really ends in ":3" is taken as named. Throws UsageError for a
/// count or scale that is not positive and for what a job file asks for and is not built, InputError for a job
/// file that cannot be read: what it says of the others is not known then. A job file says what it says over
/// `defaults`.
ExpandedInputs expand_inputs(const std::vector<std::string>& arguments, const std::filesystem::path& mesh_dir,
                             const JobSettings& defaults = {});

/// What files of defaults say over the options' own defaults: options, those of a profile (empty: of none), own
/// printers beside each file (docs/settings.md). A later file comes before an earlier one, profiles before all else.
/// Throws InputError naming file and key path, UsageError for a profile that is not there.
JobSettings read_defaults(const std::vector<std::filesystem::path>& files, const std::string& profile);

/// The text of a file of printers that says these.
std::string printers_json(std::span<const Printer> printers);

/// Reads a packing file and the meshes it names. Throws InputError naming what is missing or wrong.
Scene load_scene(const std::filesystem::path& packing_file);

/// The container of a packing, to pack into again.
ContainerSource container_source(const Packing& packing);

/// The packing file's text, with mesh paths as they are.
std::string packing_json(const Scene& scene);

/// `text` as a string of JSON; bytes that are not UTF-8 become U+FFFD.
std::string json_string(const std::string& text);

/// The mesh files of parts, fixed copies, the build that is topped up, the container and its keep-outs, each once.
std::set<std::string> mesh_files(const Job& job);
std::set<std::string> mesh_files(const Packing& packing);

/// Endings that write_output() knows, for messages: ".json .3mf .stl .csv .png".
bool is_output_file(const std::filesystem::path& path);
const char* output_endings();

/// Writes the packing as its ending says: .json .3mf .stl .csv .png. Each file whole or not at all. Of several trays,
/// a .json holds all; the others are one file for each tray ("build-1.3mf" for "build.3mf", counted from 1) and the one
/// named, which shows all side by side. Returns what was written: less than that, or nothing, where pictures are left
/// out for time.
std::vector<std::filesystem::path> write_output(const Scene& scene, const std::filesystem::path& path, int threads,
                                                const DrawingTime& time = {});

/// The file of one tray (from 0) of several, as write_output() names it; a .json holds all trays of the scene. For
/// trays that are finished while others are still packed. Returns what was written.
std::filesystem::path write_tray(const Scene& scene, std::size_t tray, const std::filesystem::path& path, int threads);

/// Whether several trays get a file each besides the one named, and the name of a tray's, which count from 1:
/// "build-2.3mf" for "build.3mf".
bool has_tray_files(const std::filesystem::path& path);
std::filesystem::path tray_file(std::filesystem::path path, std::int64_t tray);

/// Throws where no file can be written to `path`, as far as that can be known before it is: its folder is not there or
/// read-only, it is a folder itself or a file that cannot be replaced, the name is too long (UsageError), the disk is
/// full (ResourceError). `what` stands before the reason: "-o build.json". Makes a file beside it and removes it.
void require_writable(const std::filesystem::path& path, const std::string& what);

/// Throws UsageError where a packing of this job cannot be written to `path` because of the names of its mesh files,
/// which a .json holds in UTF-8.
void require_nameable(const Job& job, const std::filesystem::path& path);

/// Endings that write_report() knows: .html .csv.
bool is_report_file(const std::filesystem::path& path);

/// What a report says besides the packing. What is not known is left out of it.
struct ReportDetails {
    std::string job_name = {};                    ///< the heading; empty: the report's file name
    std::string date = {};                        ///< as it is to be printed: "28 Nov 2026"
    std::string material = {};                    ///< "PA 12"
    std::optional<double> material_density = {};  ///< g/cm^3: adds masses
};

/// A report for people: the operator's sheet, A4 pages with pictures, part list, top views and the order of removal
/// (.html, all in one file), or a table of the parts (.csv). Whole or not at all. Returns how many of its pictures are
/// left out for time.
int write_report(const Scene& scene, const std::filesystem::path& path, const ReportDetails& details, int threads,
                 const DrawingTime& time = {});

}  // namespace spectralpack
