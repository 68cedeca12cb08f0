#pragma once
/// Set files: CSV with the columns mesh,count,scale (contract: PART may be a .csv).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace spectralpack {

struct SetRow {
    std::string mesh;  ///< as written; relative to the set file or to --mesh-dir
    int count = 1;
    double scale = 1;
    int line = 0;  ///< 1-based, for messages
};

/// Columns by header name, in any order; count and scale may be missing (1). RFC 4180 quoting,
/// CRLF, a BOM and blank lines are fine. Throws InputError with the line for anything else.
std::vector<SetRow> read_set(const std::filesystem::path& path);

/// The same for text at hand; `file` is for messages.
std::vector<SetRow> parse_set(const std::string& file, std::string_view text);

/// Writes rows as a set file, whole or not at all.
void write_set(const std::vector<SetRow>& rows, const std::filesystem::path& path);

}  // namespace spectralpack
