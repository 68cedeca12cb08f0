#pragma once
/// What can be said of an output file before any work.

#include <string>

namespace spectralpack::cli {

/// Throws UsageError naming `option` where the folder that `path` is to be written to is not there.
void require_folder(const std::string& path, const char* option);

}  // namespace spectralpack::cli
