#pragma once
/// How good a packing is beside others of the same copies, in other orders.

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

#include "packing/tray/greedy.hpp"

namespace spectralpack {

/// Less is better, lexicographically: the most solid matter placed, and where all is placed the fewest trays, then the
/// least height of the last one.
struct PackingScore {
    double left_over = 0;     ///< volume of the copies that are not placed, mm^3
    std::int64_t copies = 0;  ///< that are not placed
    std::int64_t trays = 0;
    double top = 0;  ///< of the last tray's copies

    auto operator<=>(const PackingScore&) const = default;
};

/// What scores are made of; `top` in any unit, the same for all packings that are compared.
struct PackingMeasures {
    std::function<double(int part)> volume;  ///< mm^3
    std::function<double(const PlacedCopy&)> top;
};

/// `trays` hold some of `copies`, each at most once. Packings of the same copies have the same sums to the last bit, in
/// whatever order they were placed.
PackingScore score_packing(const std::vector<Copy>& copies, const std::vector<const std::vector<PlacedCopy>*>& trays,
                           const PackingMeasures& measures);

}  // namespace spectralpack
