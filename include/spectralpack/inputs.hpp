#pragma once
/// What a user names as input, made into a list of mesh files with counts and scales.

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace spectralpack {

/// One mesh file as asked for. Its objects (a 3MF may hold several) become parts of their own.
struct PartSource {
    std::string mesh;
    int count = 1;
    double scale = 1;
    std::string origin;  ///< where it was named, for messages ("set.csv line 7"); empty: as an argument
};

struct ExpandedInputs {
    std::vector<PartSource> parts;
    std::vector<InputError> unusable;  ///< named inputs that are missing or unreadable
};

/// Each argument is a mesh file, FILE:COUNT, FILE:COUNT@SCALE, a folder of meshes (searched through, sorted
/// bytewise) or a set file (.csv; its paths are relative to `mesh_dir`, or to the set file when that is empty).
/// A file whose name really ends in ":3" is taken as named. Throws UsageError for a count or scale that is not
/// positive.
ExpandedInputs expand_inputs(const std::vector<std::string>& arguments,
                             const std::filesystem::path& mesh_dir);

}  // namespace spectralpack
