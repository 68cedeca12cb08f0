#pragma once
/// Scraps of JSON for writers outside this room that need no document.

#include <string>

namespace spectralpack {

/// `text` quoted and escaped; bytes that are not UTF-8 become U+FFFD.
std::string json_string(const std::string& text);

/// Shortest text that reads back as the same double; null where it is not finite.
std::string json_number(double value);

}  // namespace spectralpack
