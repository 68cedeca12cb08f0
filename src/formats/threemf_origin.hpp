#pragma once
/// Who wrote a 3MF.

#include <filesystem>

namespace spectralpack {

/// The file is a 3MF that write_3mf() wrote: it holds a build, not a part. False for what cannot be read.
bool is_own_build(const std::filesystem::path& path);

}  // namespace spectralpack
