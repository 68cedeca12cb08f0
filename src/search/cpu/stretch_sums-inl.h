/// Sums of many stretches, two at a time; for each instruction set, as kernels-inl.h.

#if defined(SPECTRALPACK_CPU_STRETCH_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPECTRALPACK_CPU_STRETCH_SUMS_INL_H
#undef SPECTRALPACK_CPU_STRETCH_SUMS_INL_H
#else
#define SPECTRALPACK_CPU_STRETCH_SUMS_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <span>

#include "search/cpu/kernels-inl.h"
#include "search/cpu/stretches.hpp"
#include "search/cpu/sum_plan.hpp"

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

/// SumLanes() of a plan for all of some stretches, two at a time: calls each(stretch, its sums). from(stretch) is
/// the element of its table that the plan's offsets count from.
template <bool kOfEach, class AnyStretch, class From, class Each>
void SumUp(const SumPlan& plan, std::span<const AnyStretch> stretches, const From& from, std::uint32_t stop_above,
           const Each& each) {
    alignas(64) std::uint32_t sums[kLanes];
    for (std::size_t i = 0; i < stretches.size(); i += 2) {
        const bool both = i + 1 < stretches.size();
        const AnyStretch& low = stretches[i];
        const AnyStretch& high = stretches[both ? i + 1 : i];
        SumLanes<kOfEach>(from(low), from(high), plan.loads.data(), plan.batches.data(), plan.batches.size(),
                          stop_above, low.lanes | (both ? high.lanes << kStretch : 0), lane_limit(plan.least), sums);
        each(low, sums);
        if (both) each(high, sums + kStretch);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#endif
