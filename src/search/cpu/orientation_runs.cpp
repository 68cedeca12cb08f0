#include "search/cpu/orientation_runs.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
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

VoxelBox box_of(const Piece& piece) {
    const Form& form = piece.form;
    return {piece.corner, piece.corner + VoxelIndex{form.size(0), form.size(1), form.size(2)}};
}

/// Calls visit(i, corner) for items that were by z, y, x, in that order again once the grid with these extents in which
/// `box_of` them lie is turned.
template <class T, class BoxOf, class Visit>
void for_each_turned(const std::vector<T>& items, const AxisTurn& turn, const Extent& grid, const BoxOf& box_of,
                     const Visit& visit) {
    std::vector<VoxelIndex> corners;
    corners.reserve(items.size());
    for (const T& item : items) {
        corners.push_back(turned(box_of(item), turn, grid).lo);
    }
    const int first = turn.reverses() ? 0 : turn.order[0] > turn.order[1] ? 1 : 2;
    for (const std::uint32_t i : by_place(corners, first, std::identity{})) {
        visit(i, corners[i]);
    }
}

/// Pieces of a grid with these extents once it is turned.
std::vector<Piece> turned(const std::vector<Piece>& pieces, const AxisTurn& turn, const Extent& grid) {
    std::vector<Piece> result;
    result.reserve(pieces.size());
    const auto box = [](const Piece& piece) { return box_of(piece); };
    for_each_turned(pieces, turn, grid, box, [&](std::size_t i, const VoxelIndex& corner) {
        int axes = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            axes |= (pieces[i].form.axes >> turn.order[axis] & 1) << axis;
        }
        result.push_back({{axes, pieces[i].form.level}, corner});
    });
    return result;
}

/// Pieces at an offset in a grid with these extents once that is turned, and their offset then.
std::pair<std::vector<Piece>, VoxelIndex> turned(const std::vector<Piece>& pieces, const VoxelIndex& offset,
                                                 const AxisTurn& turn, const Extent& grid) {
    VoxelBox all;
    for (const Piece& piece : pieces) {
        all = hull(all, box_of(piece));
    }
    const VoxelBox box{offset, offset + all.hi};
    return {turned(pieces, turn, {all.hi.x, all.hi.y, all.hi.z}), turned(box, turn, grid).lo};
}

/// cover() by z, y, x of the corners, of voxels that are `detail` to one of dx.
std::vector<Piece> ordered_cover(const BitGrid& solid, BitGrid wanted, int detail = 1) {
    const std::vector<Piece> pieces = cover(solid, std::move(wanted), BitTables::forms_for(detail));
    return in_order(pieces, by_place(pieces, 0, [](const Piece& piece) { return piece.corner; }));
}

OrientationRuns::Widened pieces_of(const WidenedVoxels& wide, int detail) {
    OrientationRuns::Widened result;
    result.offset = wide.offset;
    if (detail == 1) {
        result.pieces = ordered_cover(wide.voxels, wide.voxels);
        return result;
    }
    const CoarseVoxels core = filled_voxels(wide.voxels, wide.offset, detail);
    result.core = ordered_cover(core.voxels, core.voxels);
    result.core_offset = core.offset;
    BitGrid skin = wide.voxels;
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
    result.pieces = ordered_cover(wide.voxels, std::move(skin), detail);
    return result;
}

/// Cells of the solid whose runs these are, of extents `solid`; `depths`: from before it was turned.
void add_cells(OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, const std::optional<Depths>& depths,
               const TrayTables::Frame& frame) {
    if (!frame.large && frame.most <= kCrowd) return;
    std::optional<TurnedDepths> here;
    if (depths) here.emplace(*depths, turn, solid);
    const auto cells = [&](int edge, std::size_t most) {
        return plan_cells(runs.solid, solid, frame.blocks, frame.most, edge, most, here ? &*here : nullptr);
    };
    runs.cells = cells(2 * TrayTables::kBlock, kMostCells);
    if (frame.large && runs.solid.runs.size() >= kRunsWorthCells) {
        runs.fine_cells = cells(TrayTables::kBlock, kMostFineCells);
    }
}

}  // namespace

std::optional<Depths> depths_of(const OrientedShape& shape, const Runs& solid, int detail, bool covers) {
    if (!covers) return std::nullopt;
    if (detail == 1) return Depths(*shape.solid, solid);
    const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
    return Depths(core, runs_along(core, solid.axis));
}

OrientationRuns make_runs(const OrientedShape& shape, int detail, bool covers, const TrayTables::Frame& frame,
                          const Workers& workers, std::optional<Depths>* keep) {
    OrientationRuns result;
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
        std::optional<Depths> depths = depths_of(shape, result.solid, detail, covers);
        if (depths) {
            result.least = depths->sums(result.solid);
        } else {
            result.least.assign(result.solid.runs.size(), 0);
        }
        add_cells(result, {}, shape.solid->extent(), depths, frame);
        if (keep) *keep = std::move(depths);
    };
    // What rho asks for takes about as long as one of the covers that a collision does.
    workers.for_each(std::ssize(distinct) + 2, [&](std::int64_t i) {
        if (i == 0) {
            add_solid();
        } else if (i == 1) {
            if (frame.walls) result.walled = ordered_cover(*shape.solid, *shape.solid);
        } else {
            const auto k = static_cast<std::size_t>(i - 2);
            result.widened[k] = pieces_of(*shape.widened[distinct[k]], detail);
        }
    });
    return result;
}

OrientationRuns turned(const OrientationRuns& runs, const AxisTurn& turn, const Extent& solid, int detail,
                       const std::optional<Depths>& depths, const TrayTables::Frame& frame) {
    OrientationRuns result;
    result.solid.axis = static_cast<int>(std::ranges::find(turn.order, runs.solid.axis) - turn.order.begin());
    result.solid.voxels = runs.solid.voxels;
    result.solid.runs.reserve(runs.solid.runs.size());
    result.least.reserve(runs.solid.runs.size());
    const auto box = [&](const Run& run) { return box_of(run, runs.solid.axis); };
    for_each_turned(runs.solid.runs, turn, solid, box, [&](std::size_t i, const VoxelIndex& start) {
        result.solid.runs.push_back({start, runs.solid.runs[i].length});
        result.least.push_back(runs.least[i]);
    });
    const Extent fine{detail * solid.x, detail * solid.y, detail * solid.z};  // exact where it is asked for
    for (const OrientationRuns::Widened& wide : runs.widened) {
        OrientationRuns::Widened& to = result.widened.emplace_back();
        std::tie(to.pieces, to.offset) = turned(wide.pieces, wide.offset, turn, fine);
        std::tie(to.core, to.core_offset) = turned(wide.core, wide.core_offset, turn, solid);
    }
    result.of_class = runs.of_class;
    result.walled = turned(runs.walled, turn, solid);
    if (turn.reverses()) {
        const Extent& n = solid;
        add_cells(result, turn, {n[turn.order[0]], n[turn.order[1]], n[turn.order[2]]}, depths, frame);
        return result;
    }
    result.cells = runs.cells;
    result.fine_cells = runs.fine_cells;
    for (CellPlan* plan : {&result.cells, &result.fine_cells}) {
        for (SolidCell& cell : plan->cells) {
            cell.block = {cell.block[turn.order[0]], cell.block[turn.order[1]], cell.block[turn.order[2]]};
            cell.offset = frame.blocks.offset(cell.block);
        }
    }
    return result;
}

bool covers_solid(const Shape& shape) {
    for (const OrientedShape& oriented : shape.orientations) {
        for (std::size_t c = 0; c < oriented.widened.size(); ++c) {
            if (c > 0 && oriented.widened[c] == oriented.widened[c - 1]) continue;
            const WidenedVoxels& widened = *oriented.widened[c];
            const BitGrid& fine = oriented.fine ? *oriented.fine : *oriented.solid;
            if (widened.offset == VoxelIndex{} && widened.voxels == fine) continue;
            BitGrid bare = fine;
            subtract(bare, widened.voxels, widened.offset);
            if (!bare.none()) return false;
        }
    }
    return true;
}

int overhang(const Shape& shape, int detail) {
    int most = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        for (const auto& widened : oriented.widened) {
            for (int axis = 0; axis < 3; ++axis) {
                const int last = ceil_div(widened->voxels.extent()[axis] + widened->offset[axis], detail);
                most =
                    std::max({most, -floor_div(widened->offset[axis], detail), last - oriented.solid->extent()[axis]});
            }
        }
    }
    return most;
}

std::int64_t bytes_of(const OrientationRuns& runs) {
    std::int64_t bytes = bytes_of(runs.solid.runs) + bytes_of(runs.least) + bytes_of(runs.walled) +
                         bytes_of(runs.cells.cells) + bytes_of(runs.fine_cells.cells);
    for (const OrientationRuns::Widened& wide : runs.widened) {
        bytes += bytes_of(wide.pieces) + bytes_of(wide.core);
    }
    return bytes;
}

}  // namespace spectralpack
