#include "search/cpu/shapes/shape_runs.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "voxel/split.hpp"

namespace spectralpack {

int overhang(const Shape& shape, int detail) {
    int most = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        for (const auto& widened : oriented.widened) {
            for (int axis = 0; axis < 3; ++axis) {
                const int last = ceil_div(widened.voxels.extent()[axis] + widened.offset[axis], detail);
                most = std::max({most, -floor_div(widened.offset[axis], detail), last - oriented.solid.extent()[axis]});
            }
        }
    }
    return most;
}

void make_missing_runs(const Shape& shape, int detail, std::vector<bool> wanted, const TrayTables& tables,
                       const Workers& workers, std::vector<OrientationRuns>& runs) {
    const std::vector<OrientedShape>& all = shape.orientations;
    const std::size_t count = all.size();
    const auto is_made = [&](std::size_t i) { return !runs[i].of_class.empty(); };
    const auto from = [&](std::size_t i) { return static_cast<std::size_t>(all[i].turned_from); };
    for (std::size_t i = count; i-- > 0;) {  // what others follow from comes before them
        wanted[i] = wanted[i] && !is_made(i);
        if (wanted[i] && all[i].is_turned()) wanted[from(i)] = true;
    }
    if (std::ranges::none_of(wanted, std::identity{})) return;  // as for nearly all copies
    // Those that follow from none, from their voxels; then those that are reversed, each with what follows from it by
    // exchanging its axes.
    std::vector<std::optional<Depths>> depths(count);  // of those that others are reversed from
    for (std::size_t i = 0; i < count; ++i) {
        if (!wanted[i] || all[i].is_exchanged()) continue;
        if (!all[i].is_turned()) {
            MadeRuns made = make_runs(all[i], detail, tables, workers);
            runs[i] = std::move(made.runs);
            depths[i] = std::move(made.depths);
        } else if (!depths[from(i)]) {
            depths[from(i)] = depths_of(all[from(i)], runs[from(i)].solid, detail);
        }
    }
    const auto turn = [&](std::size_t i) {
        runs[i] = turned(runs[from(i)], all[i].turn, all[from(i)].solid.extent(), detail, depths[from(i)], tables);
    };
    workers.for_each(static_cast<std::int64_t>(count), [&](std::int64_t i) {
        const auto first = static_cast<std::size_t>(i);
        if (all[first].is_exchanged()) return;
        if (wanted[first] && all[first].is_turned()) turn(first);
        for (std::size_t k = first + 1; k < count; ++k) {
            if (wanted[k] && all[k].is_exchanged() && from(k) == first) turn(k);
        }
    });
}

}  // namespace spectralpack
