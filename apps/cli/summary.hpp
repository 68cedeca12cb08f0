#pragma once
/// What a run says at its end, on standard output.

#include <optional>
#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "pack_arguments.hpp"
#include "time_probe.hpp"

namespace spectralpack::cli {

/// `written`: files, of those that were named, if any were.
/// `taken`: from the build that is topped up.
void print_summary(const PackResult& result, const std::vector<std::string>& written, bool files_named,
                   const TakenOver& taken);
void print_estimate(const Estimate& estimate, const PackOptions& options, const std::optional<ProbedTime>& time);

}  // namespace spectralpack::cli
