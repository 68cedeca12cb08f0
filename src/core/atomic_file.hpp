#pragma once
/// Output files are written whole or not at all: bytes go to a temporary name in the same folder, which is
/// renamed when complete. An existing file is replaced only then. Temporary files that killed processes left of the
/// same file are removed first.

#include <filesystem>
#include <functional>
#include <string_view>

#include "spectralpack/error.hpp"

namespace spectralpack {

/// What to throw where writing `path` has just failed: names it and the system's reason, errno.
ResourceError write_failure(const std::filesystem::path& path);

/// Where the bytes for `path` go first. The name is no longer than a file system takes, however long that of `path` is.
std::filesystem::path temporary_file(const std::filesystem::path& path);

/// Calls write(temporary path), with errno 0; renames on return, deletes the temporary and rethrows on an exception.
/// Throws ResourceError naming `path` when the folder cannot be written.
void replace_file(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

/// The same for bytes at hand.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace spectralpack
