#pragma once
/// Options that do not go together.

#include "spectralpack/pack.hpp"

namespace spectralpack {

/// Throws UsageError for what the options, each right by itself, cannot do together, with the reason.
void check_together(const Job& job);

}  // namespace spectralpack
