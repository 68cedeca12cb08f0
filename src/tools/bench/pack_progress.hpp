#pragma once
/// What `pack --progress json` says while it runs.

#include <optional>
#include <string>

#include "spectralpack/tools/bench.hpp"

namespace spectralpack::tools {

/// A line of it; none for lines that say something else.
std::optional<BenchProgress> parse_progress(const std::string& line);

}  // namespace spectralpack::tools
