#include "search/cpu/orientation_runs.hpp"

#include <algorithm>
#include <utility>

#include "search/cpu/lists.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kMostCells = 1600;  // asked of nearly all blocks
constexpr int kCrowd = 21;                // where no phi is above it, little lies in the open
constexpr std::size_t kMostFineCells = std::size_t{1} << 20;
constexpr std::size_t kRunsWorthCells = 200;  // with fewer, sums cost little more than fine cells

/// Clears bits [begin, end) of a row.
void clear_stretch(BitGrid::Word* row, int begin, int end) {
    using Word = BitGrid::Word;
    const Word from = ~Word{0} << (begin % 64), to = ~Word{0} >> (63 - (end - 1) % 64);
    const int first = begin / 64, last = (end - 1) / 64;
    if (first == last) {
        row[first] &= ~(from & to);
        return;
    }
    row[first] &= ~from;
    std::fill(row + first + 1, row + last, Word{0});
    row[last] &= ~to;
}

/// A form once it is turned.
Form turned(const Form& form, const AxisTurn& turn) {
    int axes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        axes |= (form.axes >> turn.order[axis] & 1) << axis;
    }
    return {axes, form.level};
}

/// Pieces in and around a grid with these extents once that is turned.
Pieces turned(const Pieces& pieces, const AxisTurn& turn, const Extent& grid) {
    Pieces result;
    result.forms.reserve(pieces.forms.size());
    result.corners.reserve(pieces.corners.size());
    for (const Pieces::OfForm& of : pieces.forms) {
        result.forms.push_back({turned(of.form, turn), of.begin, of.end});
        const TurnedCorners there(turn, grid, {of.form.size(0), of.form.size(1), of.form.size(2)});
        for (const VoxelIndex& corner : pieces.corners_of(of)) {
            result.corners.push_back(there(corner));
        }
    }
    return result;
}

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

/// cover() of voxels that are `detail` to one of dx, in a grid that lies at `offset` from a position.
Pieces cover_at(const VoxelIndex& offset, const BitGrid& solid, BitGrid wanted, int detail = 1) {
    Pieces pieces = cover(solid, std::move(wanted), BitTables::forms_for(detail));
    for (VoxelIndex& corner : pieces.corners) {
        corner = corner + offset;
    }
    return pieces;
}

OrientationRuns::Widened pieces_of(const WidenedVoxels& wide, int detail, const Workers& workers) {
    if (detail == 1) return {cover_at(wide.offset, *wide.voxels, *wide.voxels), {}};
    const CoarseVoxels core = filled_voxels(*wide.voxels, wide.offset, detail);
    BitGrid skin = *wide.voxels;
    for (const Run& run : runs_along(core.voxels, 0).runs) {
        VoxelIndex first;
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = detail * (run.start[axis] + core.offset[axis]) - wide.offset[axis];
        }
        for (int row = 0; row < detail * detail; ++row) {
            clear_stretch(skin.row(first.y + row % detail, first.z + row / detail), first.x,
                          first.x + detail * run.length);
        }
    }
    OrientationRuns::Widened result;
    workers.for_each(2, [&](std::int64_t i) {
        if (i == 0) result.pieces = cover_at(wide.offset, *wide.voxels, std::move(skin), detail);
        if (i == 1) result.core = cover_at(core.offset, core.voxels, core.voxels);
    });
    return result;
}

/// Cells of the solid whose runs these are, of extents `solid`; `depths`: from before it was turned.
void add_cells(OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, const Depths& depths,
               const TrayTables& tables) {
    const int most_phi = tables.phi().most();
    if (!tables.large() && most_phi <= kCrowd) return;
    const TurnedDepths here(depths, turn, solid);
    const auto cells = [&](int edge, std::size_t most) {
        return plan_cells(runs.solid, solid, tables.minima(), most_phi, edge, most, here);
    };
    runs.cells = cells(2 * TrayTables::kBlock, kMostCells);
    if (tables.large() && runs.solid.runs.size() >= kRunsWorthCells) {
        runs.fine_cells = cells(TrayTables::kBlock, kMostFineCells);
    }
}

}  // namespace

Depths depths_of(const OrientedShape& shape, const Runs& solid, int detail) {
    if (detail == 1) return Depths(*shape.solid, solid);
    const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
    return Depths(core, runs_along(core, solid.axis));
}

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
            if (tables.walls()) result.walled = cover_at({}, *shape.solid, *shape.solid);
        } else {
            const auto k = static_cast<std::size_t>(i - 2);
            result.widened[k] = pieces_of(shape.widened[distinct[k]], detail, workers);
        }
    });
    return {std::move(result), std::move(*depths)};
}

OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables& tables) {
    OrientationRuns result;
    turn_runs(runs, turn, solid, result);
    const Extent fine{detail * solid.x, detail * solid.y, detail * solid.z};  // exact where it is asked for
    for (const OrientationRuns::Widened& wide : runs.widened) {
        result.widened.push_back({turned(wide.pieces, turn, fine), turned(wide.core, turn, solid)});
    }
    result.of_class = runs.of_class;
    result.walled = turned(runs.walled, turn, solid);
    if (turn.reverses()) {
        add_cells(result, turn, turned(solid, turn), *depths, tables);
        return result;
    }
    result.cells = runs.cells;
    result.fine_cells = runs.fine_cells;
    for (CellPlan* plan : {&result.cells, &result.fine_cells}) {
        for (SolidCell& cell : plan->cells) {
            cell.block = {cell.block[turn.order[0]], cell.block[turn.order[1]], cell.block[turn.order[2]]};
            cell.offset = tables.minima().offset(cell.block);
        }
    }
    return result;
}

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

std::int64_t bytes_of(const OrientationRuns& runs) {
    const auto pieces = [](const Pieces& of) { return bytes_of(of.forms) + bytes_of(of.corners); };
    std::int64_t bytes = bytes_of(runs.solid.runs) + bytes_of(runs.least) + pieces(runs.walled) +
                         bytes_of(runs.cells.cells) + bytes_of(runs.fine_cells.cells);
    for (const OrientationRuns::Widened& wide : runs.widened) {
        bytes += pieces(wide.pieces) + pieces(wide.core);
    }
    return bytes;
}

}  // namespace spectralpack
