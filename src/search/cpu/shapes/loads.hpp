#pragma once
/// Which loads from the tables of prefix sums make up rho (eq. 4), in which order.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/cpu/shapes/orientation_runs.hpp"
#include "search/cpu/tables/sum_tables.hpp"

namespace spectralpack {

/// Sums are kept at most here, "this or more".
inline constexpr std::uint32_t kSumLimit = 0xFFFE0000u;

/// What lanes hold of `sum`.
inline std::uint32_t lane_limit(std::int64_t sum) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(sum, 0, kSumLimit));
}

/// Pairs of loads from sum tables whose differences add up to less than 65536.
struct SumBatch {
    std::int32_t begin = 0, end = 0;  ///< into the loads
    std::uint16_t least = 0;          ///< theirs together
};
struct SumLoad {
    std::int32_t plus = 0, minus = 0;  ///< element offsets from the position
    std::uint16_t least = 0;           ///< the difference at a free position, or less
};

struct LoadList {
    std::int64_t least = 0;  ///< what all loads come to at least at a free position
    std::vector<SumLoad> loads;
    std::vector<SumBatch> batches;
};

/// The runs' indices in the order in which sums take them: long ones first, since they tell most for a load; among
/// those bunches of neighbours, which share cache lines, from all over the solid.
std::vector<std::uint32_t> order_of_loads(const Runs& runs);

/// Every solid voxel exactly once, in order_of_loads(); runs are split so that no batch's sum can reach 65536 with
/// values <= most.
LoadList list_loads(const OrientationRuns& orientation, const std::vector<std::uint32_t>& order,
                    const SumLayout& tables, int range, int most);

/// Of what it holds in lists, about.
std::int64_t bytes_of(const LoadList& list);

}  // namespace spectralpack
