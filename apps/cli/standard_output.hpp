#pragma once
/// Standard output, of which nothing may be lost in silence.

#include <optional>
#include <string>

namespace spectralpack::cli {

/// Where a standard stream is closed, opens it on nothing, so that no file the program writes takes its place; what is
/// then written to standard output is lost, and said to be.
void hold_standard_streams();

/// Writes out what is still buffered. Why some of what was printed is lost; none where all is written.
std::optional<std::string> lost_output();

}  // namespace spectralpack::cli
