#pragma once
/// Sets of procedural parts, so that benchmarks can be run from nothing.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "generate/generate.hpp"
#include "spectralpack/events.hpp"

namespace spectralpack {

struct GenerateOptions {
    GeneratedSet set = GeneratedSet::pieces;
    std::uint64_t seed = 0;
    std::optional<int> copies;  ///< in all; none: as many as the set has (generate/generate.hpp)
};

struct GeneratedFiles {
    std::filesystem::path set_file;  ///< columns mesh,count,scale; beside the meshes
    int meshes = 0;
    int copies = 0;
    double volume = 0;      ///< of all copies, mm^3
    double box_volume = 0;  ///< of all copies' boxes as they lie, mm^3
};

/// Writes every part as a binary STL into `folder`, which is made where it is not there, and a set file that names
/// them. The same options give the same bytes on every machine. Files of the same names are replaced. Throws
/// UsageError for a number of copies that makes no sense, ResourceError where the folder cannot be written.
GeneratedFiles generate(const GenerateOptions& options, const std::filesystem::path& folder, Listener& listener);

/// "pieces", "mixtures", "locks", "tori", "polyhedra", "letters".
const char* generated_set_name(GeneratedSet set);

}  // namespace spectralpack
