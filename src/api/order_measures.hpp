#pragma once
/// What packings in different orders are compared by.

#include "api/load.hpp"
#include "api/plan.hpp"
#include "packing/packing_score.hpp"

namespace spectralpack {

/// Volumes and heights of the true meshes, mm. Refers to `loaded` and `plan`; not for several threads at once.
PackingMeasures order_measures(const LoadedJob& loaded, const Plan& plan);

}  // namespace spectralpack
