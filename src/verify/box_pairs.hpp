#pragma once
/// Which boxes are near each other.

#include <cstdint>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

struct BoxPair {
    std::int32_t a = 0, b = 0;  ///< indices of the boxes, a < b
    double distance = 0;
};

/// All pairs of boxes whose distance is above `from` and at most `to` (from < 0: from touching on), nearest first,
/// then by index. Sweeps along the axis in which the boxes spread most: n log n and the pairs that overlap along it.
std::vector<BoxPair> near_pairs(const std::vector<Box>& boxes, double from, double to);

}  // namespace spectralpack
