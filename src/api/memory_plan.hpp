#pragma once
/// How much memory a run takes, told before it starts, and what that leaves for caches.

#include <cstdint>

#include "api/plan.hpp"

namespace spectralpack {

/// Settles what `plan` says of memory, from all else in it: the bytes the run takes, the limit, what may be kept, and
/// with open height how high the grid starts and may grow, but at least `fixed_layers`.
void plan_memory(const LoadedJob& loaded, const PackOptions& options, int fixed_layers, const Workers& workers,
                 Plan& plan);

/// Bytes that recording and writing so many copies takes, about.
std::int64_t record_memory(const LoadedJob& loaded);

/// Throws ResourceError, with the bytes needed and the finest voxel size that would fit, when plan.memory is
/// beyond plan.memory_limit.
void require_memory(const Plan& plan, const LoadedJob& loaded, const PackOptions& options, const Workers& workers);

}  // namespace spectralpack
