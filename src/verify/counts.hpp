#pragma once
/// Is every copy placed once, or listed as left over?

#include <vector>

#include "verify/check.hpp"

namespace spectralpack {

/// Findings of kind count: copies placed twice, placed and left over, missing, or of no part or number there is.
std::vector<Finding> count_findings(const Packing& packing);

}  // namespace spectralpack
