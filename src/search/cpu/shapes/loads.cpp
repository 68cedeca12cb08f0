#include "search/cpu/shapes/loads.hpp"

#include <algorithm>
#include <bit>

#include "search/cpu/shapes/orders.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

constexpr int kSumRange = 65535;  // what 16 bits hold

}  // namespace

std::vector<std::uint32_t> order_of_loads(const Runs& runs) {
    return by_level(runs.runs, 33, 1, tuning::kLoadsPerBunch,
                    [](const Run& run) { return std::bit_width(static_cast<unsigned>(run.length)); });
}

LoadList list_loads(const OrientationRuns& orientation, const std::vector<std::uint32_t>& order,
                    const SumLayout& tables, int range, int most) {
    const Runs& runs = orientation.solid;
    LoadList list;
    list.loads.reserve(order.size());
    list.batches.reserve(order.size() / tuning::kLoadsPerBatch + 1);
    const int longest = range / std::max(1, most);
    const int together = kSumRange / std::max(1, most);  // voxels of a batch
    SumBatch batch;
    int left_in_batch = together;  // that it can still take
    std::int32_t count = 0;        // of all loads
    const auto close_batch = [&] {
        batch.end = count;
        if (batch.end == batch.begin) return;
        list.batches.push_back(batch);
        batch = {batch.end, batch.end};
        left_in_batch = together;
    };
    const auto add = [&](std::int32_t from, std::int32_t to, int length, std::uint32_t least) {
        if (length > left_in_batch || count - batch.begin == tuning::kLoadsPerBatch) close_batch();
        ++count;
        const auto part = static_cast<std::uint16_t>(std::min(least, static_cast<std::uint32_t>(range)));
        list.loads.push_back({to, from, part});
        list.least += part;
        batch.least = static_cast<std::uint16_t>(batch.least + part);
        left_in_batch -= length;
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
    return list;
}

std::int64_t bytes_of(const LoadList& list) { return bytes_of(list.loads) + bytes_of(list.batches); }

}  // namespace spectralpack
