#pragma once
/// What this machine has: memory only; the clock stays with the callers.

#include <cstdint>
#include <filesystem>

namespace spectralpack {

/// Bytes that limits on the process leave it: control groups (version 1 or 2, at any level above it), addresses and
/// data (ulimit -v, -d). `root`: of the system's files.
std::int64_t memory_within_limits(const std::filesystem::path& root = "/");

/// Bytes the process may still take: free memory, or less where limits leave less.
std::int64_t available_memory(const std::filesystem::path& root = "/");

/// Whether addresses are limited (ulimit -v): then what is asked for and never touched counts as well, like the stacks
/// of threads.
bool limits_addresses();

/// The most bytes this process has held so far.
std::int64_t peak_memory();

}  // namespace spectralpack
