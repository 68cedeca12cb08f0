#pragma once
/// How the time limit of a run is spent.

#include <filesystem>

#include "interrupts.hpp"

namespace spectralpack::cli {

/// Of an output: what takes longest to write.
inline bool is_picture(const std::filesystem::path& file) { return ending_of(file) == ".png"; }

/// By what the run is to write, and whether it plans.
TimeShares time_shares(const JobSettings& settings);

}  // namespace spectralpack::cli
