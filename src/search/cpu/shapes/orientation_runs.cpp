#include "search/cpu/shapes/orientation_runs.hpp"

#include <algorithm>
#include <utility>

#include "search/cpu/shapes/orders.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

/// The runs of a solid with these extents, and what is known of their least sums, once it is turned.
void turn_runs(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, OrientationRuns& result) {
    const Runs& before = runs.solid;
    const auto axis = static_cast<std::size_t>(std::ranges::find(turn.order, before.axis) - turn.order.begin());
    result.solid.axis = static_cast<int>(axis);
    result.solid.voxels = before.voxels;
    const TurnedCorners turned(turn, solid, {1, 1, 1});
    std::vector<VoxelIndex> starts;
    starts.reserve(before.runs.size());
    for (const Run& run : before.runs) {
        VoxelIndex& start = starts.emplace_back(turned(run.start));
        if (turn.reversed[axis]) start[result.solid.axis] -= run.length - 1;
    }
    result.solid.runs.reserve(before.runs.size());
    result.least.reserve(before.runs.size());
    const int first = turn.reverses() ? 0 : turn.order[0] > turn.order[1] ? 1 : 2;
    for (const std::uint32_t i : by_place(starts, first)) {
        result.solid.runs.push_back({starts[i], before.runs[i].length});
        result.least.push_back(runs.least[i]);
    }
}

/// Cells of the solid whose runs these are, of extents `solid`; `depths`: from before it was turned.
void add_cells(OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, const Depths& depths,
               const TrayTables& tables) {
    if (!tables.large() && tables.phi().most() <= tuning::kMostPhiOfCrowds) return;
    const TurnedDepths here(depths, turn, solid);
    const auto cells = [&](int edge, std::size_t most) {
        return list_cells(runs.solid, solid, tables.minima(), tables.phi().most_ever(), edge, most, here);
    };
    runs.cells = cells(2 * TrayTables::kBlock, tuning::kMostCells);
    if (tables.large() && runs.solid.runs.size() >= tuning::kRunsWorthSmallCells) {
        runs.small_cells = cells(TrayTables::kBlock, tuning::kMostSmallCells);
    }
}

}  // namespace

MadeRuns make_runs(const OrientedShape& shape, int detail, const TrayTables& tables, const Workers& workers) {
    OrientationRuns result;
    std::optional<Depths> depths;
    std::vector<std::size_t> distinct;  // classes
    for (std::size_t c = 0; c < shape.widened.size(); ++c) {
        std::size_t same = 0;
        while (shape.widened[same] != shape.widened[c])
            ++same;
        result.of_class.push_back(same < c ? result.of_class[same] : static_cast<int>(distinct.size()));
        if (same == c) distinct.push_back(c);
    }
    result.widened.resize(distinct.size());
    const auto add_solid = [&] {
        result.solid = fewest_runs(*shape.solid);
        depths = depths_of(shape, result.solid, detail);
        result.least = depths->sums(result.solid);
        add_cells(result, {}, shape.solid.extent(), *depths, tables);
    };
    // What rho asks for takes about as long as one of the covers that a collision does.
    workers.for_each(std::ssize(distinct) + 2, [&](std::int64_t i) {
        if (i == 0) {
            add_solid();
        } else if (i == 1) {
            if (tables.walls()) result.walled = cover(*shape.solid, *shape.solid, BitTables::kForms);
        } else {
            const auto k = static_cast<std::size_t>(i - 2);
            result.widened[k] = cover(shape.widened[distinct[k]], detail, workers);
        }
    });
    return {std::move(result), std::move(*depths)};
}

OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables& tables) {
    OrientationRuns result;
    turn_runs(runs, turn, solid, result);
    const Extent fine{detail * solid.x, detail * solid.y, detail * solid.z};  // exact where it is asked for
    for (const CoveredVoxels& wide : runs.widened) {
        result.widened.push_back({turned(wide.pieces, turn, fine), turned(wide.core, turn, solid)});
    }
    result.of_class = runs.of_class;
    result.walled = turned(runs.walled, turn, solid);
    if (turn.reverses()) {
        add_cells(result, turn, turned(solid, turn), *depths, tables);
        return result;
    }
    result.cells = runs.cells;
    result.small_cells = runs.small_cells;
    for (CellList* list : {&result.cells, &result.small_cells}) {
        for (SolidCell& cell : list->cells) {
            cell.block = {cell.block[turn.order[0]], cell.block[turn.order[1]], cell.block[turn.order[2]]};
            cell.offset = tables.minima().offset(cell.block);
        }
    }
    return result;
}

std::int64_t bytes_of(const OrientationRuns& runs) {
    const auto pieces = [](const Pieces& of) { return bytes_of(of.forms) + bytes_of(of.corners); };
    std::int64_t bytes = bytes_of(runs.solid.runs) + bytes_of(runs.least) + pieces(runs.walled) +
                         bytes_of(runs.cells.cells) + bytes_of(runs.small_cells.cells);
    for (const CoveredVoxels& wide : runs.widened) {
        bytes += pieces(wide.pieces) + pieces(wide.core);
    }
    return bytes;
}

}  // namespace spectralpack
