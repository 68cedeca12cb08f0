#include "search/cpu/block_minima.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "search/cpu/kernels.hpp"

namespace spectralpack {

BlockMinima::BlockMinima(const Extent& grid, int block)
    : blocks_{(grid.x + block - 1) / block, (grid.y + block - 1) / block, (grid.z + block - 1) / block},
      block_(block),
      values_(static_cast<std::size_t>(blocks_.count() + 2 * blocks_.x) + kOverrun, 0) {}

void BlockMinima::update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers) {
    const VoxelBox box = intersection(changed, whole(phi.extent()));
    if (box.empty()) return;
    const int first = box.lo.x / block_;
    const int last = (box.hi.x - 1) / block_;
    const int begin_z = box.lo.z / block_;
    const int count_z = (box.hi.z - 1) / block_ + 1 - begin_z;
    const int lo = first * block_;
    const int hi = std::min(phi.extent().x, (last + 1) * block_);
    workers.for_ranges(count_z, 4, [&](std::int64_t begin, std::int64_t end) {
        std::vector<std::uint16_t> least(static_cast<std::size_t>(hi - lo));
        for (int bz = begin_z + static_cast<int>(begin); bz < begin_z + static_cast<int>(end); ++bz) {
            for (int by = box.lo.y / block_; by <= (box.hi.y - 1) / block_; ++by) {
                std::ranges::fill(least, std::numeric_limits<std::uint16_t>::max());
                for (int z = bz * block_; z < std::min(phi.extent().z, (bz + 1) * block_); ++z) {
                    for (int y = by * block_; y < std::min(phi.extent().y, (by + 1) * block_); ++y) {
                        min_rows(least.data(), least.data(), phi.row(y, z) + lo, least.size());
                    }
                }
                std::uint16_t* out = values_.data() + offset({0, by, bz});
                for (int bx = first; bx <= last; ++bx) {
                    const auto from = least.begin() + (bx - first) * block_;
                    out[bx] = *std::min_element(from, std::min(from + block_, least.end()));
                }
            }
        }
    });
}

namespace {

constexpr std::size_t kMostCells = 1600;

/// The voxels of one cell: how many, where on average, how far from c.
struct Cell {
    std::int64_t voxels = 0;
    std::int64_t sum[3] = {};
    VoxelIndex centre;
    std::int64_t distance = 0;
};

/// 0 + 1 + ... + n.
std::int64_t triangle(std::int64_t n) { return n > 0 ? n * (n + 1) / 2 : 0; }

/// Calls visit(cell, stretch) for the stretches of all runs within cells of edge^3 voxels.
template <class Visit>
void for_each_stretch(const Runs& solid, const Extent& cells, int edge, const Visit& visit) {
    for (const Run& run : solid.runs) {
        const int end = run.start[solid.axis] + run.length;
        Run stretch = run;
        while (stretch.start[solid.axis] < end) {
            int& first = stretch.start[solid.axis];
            const int border = std::min(end, (first / edge + 1) * edge);
            stretch.length = border - first;
            const VoxelIndex& v = stretch.start;
            visit(static_cast<std::size_t>((static_cast<std::int64_t>(v.z / edge) * cells.y + v.y / edge) * cells.x +
                                           v.x / edge),
                  stretch);
            first = border;
        }
    }
}

/// The solid's cells of edge^3 voxels, c in a block's corner.
std::vector<Cell> cells_of(const Runs& solid, const Extent& extent, int edge, int block) {
    const Extent count{(extent.x + edge - 1) / edge, (extent.y + edge - 1) / edge, (extent.z + edge - 1) / edge};
    std::vector<Cell> cells(static_cast<std::size_t>(count.count()));
    const int along = solid.axis;
    for_each_stretch(solid, count, edge, [&](std::size_t i, const Run& run) {
        Cell& cell = cells[i];
        cell.voxels += run.length;
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
    for_each_stretch(solid, count, edge, [&](std::size_t i, const Run& run) {
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

CellPlan plan_cells(const Runs& solid, const Extent& extent, const BlockMinima& minima, int most, bool apart) {
    CellPlan plan;
    plan.least = apart ? solid.voxels : 0;
    // Sums are kept in 32 bits.
    if (solid.voxels * most > std::numeric_limits<std::int32_t>::max()) return plan;
    const int block = minima.block();
    std::vector<Cell> cells;
    int edge = 2 * block;
    do {
        cells = cells_of(solid, extent, edge, block);
        edge *= 2;
    } while (cells.size() > kMostCells);
    std::ranges::stable_sort(cells, [](const Cell& a, const Cell& b) { return a.voxels > b.voxels; });
    for (const Cell& cell : cells) {
        const std::int64_t drop = (cell.distance + cell.voxels - 1) / cell.voxels + (apart ? 1 : 0);
        const VoxelIndex at{cell.centre.x / block, cell.centre.y / block, cell.centre.z / block};
        plan.cells.push_back({at, minima.offset(at), static_cast<std::uint32_t>(cell.voxels),
                              static_cast<std::uint16_t>(std::min<std::int64_t>(drop, 65535))});
    }
    return plan;
}

}  // namespace spectralpack
