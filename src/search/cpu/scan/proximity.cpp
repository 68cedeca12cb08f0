#include "search/cpu/scan/proximity.hpp"

#include <algorithm>

namespace spectralpack {

std::int64_t proximity_at(const TrayTables& tables, const Runs& solid, const VoxelIndex& q) {
    const DistanceGrid& phi = tables.phi();
    const Extent& n = phi.extent();
    const std::ptrdiff_t steps[3] = {1, phi.stride(), static_cast<std::ptrdiff_t>(phi.stride()) * n.y};
    const int along = solid.axis;
    std::int64_t sum = 0;
    for (const Run& run : solid.runs) {
        VoxelIndex v = q + run.start;
        const int end = std::min(v[along] + run.length, n[along]);
        v[along] = std::max(v[along], 0);
        if (v[along] >= end || !n.contains(v)) continue;
        const std::uint16_t* at = phi.row(v.y, v.z) + v.x;
        for (int i = v[along]; i < end; ++i, at += steps[along]) {
            sum += *at;
        }
    }
    return sum;
}

std::array<Cost, 6> neighbours_of(const VoxelIndex& position, const Runs& solid, int layers, const TrayTables& tables,
                                  const CostModel& model, int reference_layers) {
    std::array<Cost, 6> costs;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        VoxelIndex q = position;
        q[static_cast<int>(i / 2)] += i % 2 == 0 ? -1 : 1;
        costs[i] = cost_of(model, q.z, layers, reference_layers, proximity_at(tables, solid, q));
    }
    return costs;
}

}  // namespace spectralpack
