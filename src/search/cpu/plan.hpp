#pragma once
/// What a shape's orientation asks of a tray's tables, worked out once.

#include <cstdint>

#include "search/cpu/lookup_plan.hpp"
#include "search/cpu/sum_plan.hpp"

namespace spectralpack {

/// All that an orientation asks of the tables of a tray. It holds until they start afresh or objects of a class come
/// in of which there were none.
struct OrientationPlan {
    CollisionPlan collision;
    SumPlan fine;    ///< of single positions and of quads
    SumPlan coarse;  ///< of blocks
};
OrientationPlan make_plan(const OrientationRuns& runs, const TrayTables& tables);

/// Of what it holds in lists, about.
std::int64_t bytes_of(const OrientationPlan& plan);

}  // namespace spectralpack
