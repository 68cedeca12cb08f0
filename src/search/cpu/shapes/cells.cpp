#include "search/cpu/shapes/cells.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

namespace spectralpack {
namespace {

/// The voxels of one cell: how many, where on average, how far from c and how deep, all together.
struct Cell {
    std::int64_t voxels = 0;
    std::int64_t sum[3] = {};
    VoxelIndex centre;
    std::int64_t distance = 0;
    std::int64_t depth = 0;
};

/// Cubes of edge^3 voxels whose middles are corners of blocks.
struct CellGrid {
    CellGrid(const Extent& solid, int edge, int block)
        : shift(std::countr_zero(static_cast<unsigned>(edge))), before(edge / 2 % block) {
        for (int axis = 0; axis < 3; ++axis) {
            count[axis] = along(solid[axis] + edge - 1);
        }
    }
    std::size_t index(const VoxelIndex& v) const {
        return static_cast<std::size_t>((static_cast<std::int64_t>(along(v.z)) * count.y + along(v.y)) * count.x +
                                        along(v.x));
    }
    int along(int voxel) const { return (voxel + before) >> shift; }
    /// The first voxel of the next cell along an axis.
    int end(int voxel) const { return ((along(voxel) + 1) << shift) - before; }

    int shift;   ///< an edge has 2^shift voxels
    int before;  ///< of the first cell's voxels, how many lie before the solid's grid
    Extent count;
};

/// 0 + 1 + ... + n.
std::int64_t triangle(std::int64_t n) { return n > 0 ? n * (n + 1) / 2 : 0; }

/// Calls visit(cell, stretch) for the stretches of all runs within cells.
template <class Visit>
void for_each_stretch(const Runs& solid, const CellGrid& grid, const Visit& visit) {
    const std::size_t steps[3] = {1, static_cast<std::size_t>(grid.count.x),
                                  static_cast<std::size_t>(grid.count.x) * static_cast<std::size_t>(grid.count.y)};
    const int along = solid.axis;
    for (const Run& run : solid.runs) {
        const int end = run.start[along] + run.length;
        Run stretch = run;
        int& first = stretch.start[along];
        for (std::size_t cell = grid.index(run.start); first < end; cell += steps[along]) {
            const int border = std::min(end, grid.end(first));
            stretch.length = border - first;
            visit(cell, stretch);
            first = border;
        }
    }
}

/// The solid's cells of edge^3 voxels, c in a block's corner.
std::vector<Cell> cells_of(const Runs& solid, const Extent& extent, int edge, int block, const TurnedDepths& depths) {
    const CellGrid grid(extent, edge, block);
    std::vector<Cell> cells(static_cast<std::size_t>(grid.count.count()));
    const int along = solid.axis;
    for_each_stretch(solid, grid, [&](std::size_t i, const Run& run) {
        Cell& cell = cells[i];
        cell.voxels += run.length;
        cell.depth += depths.sum(run, along);
        for (int axis = 0; axis < 3; ++axis) {
            cell.sum[axis] += static_cast<std::int64_t>(run.start[axis]) * run.length;
        }
        cell.sum[along] += triangle(run.length - 1);
    });
    for (Cell& cell : cells) {
        if (cell.voxels == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
            const auto mean = static_cast<int>((cell.sum[axis] + cell.voxels / 2) / cell.voxels);
            // The nearest corner of a block, no further than the solid reaches.
            const int last = (extent[axis] - 1) / block;
            cell.centre[axis] = std::min((mean + block / 2) / block, last) * block;
        }
    }
    for_each_stretch(solid, grid, [&](std::size_t i, const Run& run) {
        Cell& cell = cells[i];
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t first = run.start[axis] - cell.centre[axis];
            if (axis != along) {
                cell.distance += std::abs(first) * run.length;
                continue;
            }
            const std::int64_t last = first + run.length - 1;
            cell.distance += first >= 0  ? triangle(last) - triangle(first - 1)
                             : last <= 0 ? triangle(-first) - triangle(-last - 1)
                                         : triangle(-first) + triangle(last);
        }
    });
    std::erase_if(cells, [](const Cell& cell) { return cell.voxels == 0; });
    return cells;
}

}  // namespace

CellList list_cells(const Runs& solid, const Extent& extent, const BlockLayout& blocks, int most, int edge,
                    std::size_t most_cells, const TurnedDepths& depths) {
    CellList list;
    // Sums are kept in 32 bits.
    if (solid.voxels * most > std::numeric_limits<std::int32_t>::max()) return list;
    const int block = blocks.block();
    std::vector<Cell> cells = cells_of(solid, extent, edge, block, depths);
    while (cells.size() > most_cells) {
        edge *= 2;
        cells = cells_of(solid, extent, edge, block, depths);
    }
    std::ranges::stable_sort(cells, [](const Cell& a, const Cell& b) { return a.voxels > b.voxels; });
    for (const Cell& cell : cells) {
        list.least += cell.depth;
        const std::int64_t drop = (cell.distance + cell.depth + cell.voxels - 1) / cell.voxels;
        const VoxelIndex at{cell.centre.x / block, cell.centre.y / block, cell.centre.z / block};
        list.cells.push_back({at, blocks.offset(at), static_cast<std::uint32_t>(cell.voxels),
                              static_cast<std::uint16_t>(std::min<std::int64_t>(drop, 65535))});
    }
    return list;
}

}  // namespace spectralpack
