#pragma once
/// Comma-separated values after RFC 4180.

#include <string>
#include <string_view>
#include <vector>

namespace spectralpack {

struct CsvRow {
    std::vector<std::string> fields;
    int line = 0;  ///< where the row starts, 1-based
};

/// All rows; blank lines are left out; LF, CRLF or CR ends a row; a byte-order mark is skipped.
/// Throws InputError with the line for a quote in the wrong place.
std::vector<CsvRow> parse_csv(const std::string& file, std::string_view text, char separator = ',');

/// `field` as it stands in a row: quoted where it holds a comma, a quote, a line end or outer
/// blanks.
std::string csv_field(std::string_view field);

}  // namespace spectralpack
