#pragma once
/// What lies in folders that were named and is not taken.

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// Tells which files were passed over, and why.
void report_passed_over(const ExpandedInputs& inputs, Listener& display);

}  // namespace spectralpack::cli
