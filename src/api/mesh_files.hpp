#pragma once
/// The mesh files of a job.

#include <set>
#include <string>

#include "spectralpack/job.hpp"

namespace spectralpack {

/// Those of parts, fixed copies, the build that is topped up, the container and its keep-outs, each once.
std::set<std::string> mesh_files_of(const Job& job);

}  // namespace spectralpack
