#pragma once
/// What can be said of an output file before any work.

#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// Throws UsageError naming `option` where no file can be written to `path`: its folder is not there or read-only, or
/// it is a folder itself.
void require_writable(const std::string& path, const char* option);

/// Throws UsageError naming `option` where `path` is, by whatever name, one of the files in `inputs`, of which some may
/// not be there.
void require_no_input(const std::string& path, const char* option, const std::vector<std::string>& inputs);

/// The mesh files of the container and of what is kept free in it.
std::vector<std::string> files_of(const ContainerSource& container);

/// Throws UsageError where `path`, given with -o, is not a picture's name or cannot be written.
void require_picture(const std::string& path);

/// Throws UsageError where `path`, given with -o, ends as no file does that a packing is written to, or cannot be
/// written.
void require_output(const std::string& path);

}  // namespace spectralpack::cli
