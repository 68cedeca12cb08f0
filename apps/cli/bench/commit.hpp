#pragma once
/// Which commit the program was built from.

namespace spectralpack::cli {

extern const char* const kCommit;  ///< "73fd193", "73fd193-changed"; "unknown" outside a repository

}  // namespace spectralpack::cli
