#pragma once
/// Which commit the program was built from.

namespace spectralpack::tools {

extern const char* const kCommit;  ///< "73fd193", "73fd193-changed"; "unknown" outside a repository

}  // namespace spectralpack::tools
