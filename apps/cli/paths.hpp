#pragma once
/// What can be said of an output file before any work.

#include <string>

namespace spectralpack::cli {

/// Throws UsageError naming `option` where the folder that `path` is to be written to is not there.
void require_folder(const std::string& path, const char* option);

/// Throws UsageError where `path`, given with -o, ends as no file does that a packing is written to.
void require_output_file(const std::string& path);

}  // namespace spectralpack::cli
