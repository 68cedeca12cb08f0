#include "search/cpu/sum_plan.hpp"

#include <algorithm>
#include <bit>

#include "search/cpu/lists.hpp"

namespace spectralpack {
namespace {

constexpr int kSumRange = 65535;                            // what 16 bits hold
constexpr int kLoadsPerBatch = 24;                          // between two looks at the limit
constexpr std::size_t kLoadsPerBunch = 2 * kLoadsPerBatch;  // of neighbours, which share cache lines

}  // namespace

std::vector<std::uint32_t> order_of_loads(const Runs& runs) {
    return by_level(runs.runs, 33, 1, kLoadsPerBunch,
                    [](const Run& run) { return std::bit_width(static_cast<unsigned>(run.length)); });
}

SumPlan plan_sum(const OrientationRuns& orientation, const std::vector<std::uint32_t>& order, const SumLayout& tables,
                 int range, int most) {
    const Runs& runs = orientation.solid;
    SumPlan plan;
    plan.loads.reserve(order.size());
    plan.batches.reserve(order.size() / kLoadsPerBatch + 1);
    const int longest = range / std::max(1, most);
    const int together = kSumRange / std::max(1, most);  // voxels of a batch
    SumBatch batch;
    int room = together;     // that it can still take
    std::int32_t count = 0;  // of all loads
    const auto close_batch = [&] {
        batch.end = count;
        if (batch.end == batch.begin) return;
        plan.batches.push_back(batch);
        batch = {batch.end, batch.end};
        room = together;
    };
    const auto add = [&](std::int32_t from, std::int32_t to, int length, std::uint32_t least) {
        if (length > room || count - batch.begin == kLoadsPerBatch) close_batch();
        ++count;
        const auto part = static_cast<std::uint16_t>(std::min(least, static_cast<std::uint32_t>(range)));
        plan.loads.push_back({to, from, part});
        plan.least += part;
        batch.least = static_cast<std::uint16_t>(batch.least + part);
        room -= length;
    };
    for (const std::uint32_t i : order) {
        const Run& run = runs.runs[i];
        VoxelIndex at = run.start;
        std::int32_t from = tables.offset(runs.axis, at);
        if (run.length <= longest) {
            add(from, tables.further(runs.axis, at, from, run.length), run.length, orientation.least[i]);
            continue;
        }
        for (int left = run.length; left > 0;) {
            const int length = std::min(left, longest);
            const std::int32_t to = tables.further(runs.axis, at, from, length);
            add(from, to, length, 0);  // no part is known to hold the deep voxels
            left -= length;
            at[runs.axis] += length;
            from = to;
        }
    }
    close_batch();
    return plan;
}

std::int64_t bytes_of(const SumPlan& plan) { return bytes_of(plan.loads) + bytes_of(plan.batches); }

}  // namespace spectralpack
