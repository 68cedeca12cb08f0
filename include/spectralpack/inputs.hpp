#pragma once
/// What a user names as input, made into a list of mesh files with counts and scales.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/job.hpp"
#include "spectralpack/orientations.hpp"

namespace spectralpack {

struct ExpandedInputs {
    std::vector<Part> parts;
    std::vector<InputError> unusable;  ///< named inputs that are missing or unreadable
    std::optional<JobSettings> job;    ///< what a job file among them says besides its parts
};

/// Each argument is a mesh file, FILE:COUNT, FILE:COUNT@SCALE, a folder of meshes (searched through, sorted
/// bytewise), a set file (.csv; its paths are relative to `mesh_dir`, or to the set file when that is empty) or a
/// job file (.json, one at most). A file whose name really ends in ":3" is taken as named. Throws UsageError for a
/// count or scale that is not positive and for what a job file asks for and is not built, InputError for a job
/// file that cannot be read: what it says of the others is not known then.
ExpandedInputs expand_inputs(const std::vector<std::string>& arguments, const std::filesystem::path& mesh_dir);

}  // namespace spectralpack
