#pragma once
/// Numbers as people write and read them.

#include <cstdint>
#include <string>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// "480x245x200" into a size in mm. Throws UsageError naming `option`.
Vec3 parse_size(const std::string& text, const char* option);

/// "mm", "inch" or "m" into mm. Throws UsageError naming --unit.
double parse_unit(const std::string& text);

/// "1600x1200" into the size of a picture. Throws UsageError naming --size.
void parse_picture_size(const std::string& text, RenderOptions& options);

/// "500M", "2G", "2GiB", "1000000" into bytes (K, M, G, T: powers of 1000; Ki, Mi, Gi, Ti: of 1024).
std::int64_t parse_bytes(const std::string& text, const char* option);

/// Text from files as it can go to a terminal: control characters as '?'.
std::string printable(std::string text);

std::string duration_text(double seconds);   ///< "0.42 s", "12.3 s", "4 min 05 s", "2 h 07 min"
std::string bytes_text(std::int64_t bytes);  ///< "812 MB", "3.1 GB"
std::string percent_text(double share);      ///< "43.9 %"
std::string length_text(double mm);          ///< at most three decimals, none that are zero

}  // namespace spectralpack::cli
