#pragma once
/// What can be said of output files before any work.

#include <cstdint>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// A file that is to be written, and the option that names it.
struct NamedOutput {
    const char* option;
    std::string path;
};

/// Throws naming `option` where no file can be written to `path`.
void require_writable(const std::string& path, const char* option);

/// Throws UsageError naming `option` where `path` is, by whatever name, one of the files in `inputs`, of which some may
/// not be there.
void require_no_input(const std::string& path, const char* option, const std::vector<std::string>& inputs);

/// Throws UsageError where two of them are one file: the second would replace the first.
void require_apart(const std::vector<NamedOutput>& outputs);

/// Of an output that becomes a file for each of up to `trays` trays: throws where one of these cannot be written, is
/// another output, or one of `inputs`.
void require_tray_files(const NamedOutput& output, std::int64_t trays, const std::vector<NamedOutput>& outputs,
                        const std::vector<std::string>& inputs);

/// Throws UsageError where `path`, given with -o, is not a picture's name or cannot be written.
void require_picture(const std::string& path);

/// Throws UsageError where `path`, given with -o, ends as no file does that a packing is written to, or cannot be
/// written.
void require_output(const std::string& path);

}  // namespace spectralpack::cli
