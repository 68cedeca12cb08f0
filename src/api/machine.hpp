#pragma once
/// What this machine has: memory only; the clock stays with the callers.

#include <cstdint>

namespace spectralpack {

/// Bytes the process may still take: free memory, or less where a control group limits it.
std::int64_t available_memory();

/// The most bytes this process has held so far.
std::int64_t peak_memory();

}  // namespace spectralpack
