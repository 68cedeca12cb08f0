#pragma once
/// Set files: CSV with a line for each part (docs/format.md).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spectralpack/orientations.hpp"

namespace spectralpack {

struct SetRow {
    std::string mesh;  ///< as written; relative to the set file or to --mesh-dir
    int count = 1;
    double scale = 1;
    int line = 0;                     ///< 1-based, for messages
    std::string name = {};            ///< empty: as the mesh says
    std::optional<double> unit = {};  ///< mm per unit of a mesh that does not say; none: the job's
    std::optional<double> gap = {};   ///< mm; none: the job's
    double priority = 0;
    std::string due = {};  ///< "2026-12-01"; empty: none
    double value = 1;
    PartOrientations orientations = {};
};

/// Columns by header name, in any order and case, separated by commas or, where the header has semicolons, by those;
/// numbers may then have a decimal comma. All but the mesh may be missing, and all but the count may be left empty in a
/// row. RFC 4180 quoting, CRLF, a BOM and blank lines are fine. Throws InputError with the line for anything else.
std::vector<SetRow> read_set(const std::filesystem::path& path);

/// The same for text at hand; `file` is for messages.
std::vector<SetRow> parse_set(const std::string& file, std::string_view text);

/// Writes mesh, count and scale of the rows as a set file, whole or not at all.
void write_set(const std::vector<SetRow>& rows, const std::filesystem::path& path);

}  // namespace spectralpack
