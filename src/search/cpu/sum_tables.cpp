#include "search/cpu/sum_tables.hpp"

#include <limits>

#include "search/cpu/kernels.hpp"

namespace spectralpack {
namespace {

constexpr int kOverrun = 256;  // lanes past the last position are read, never used

}  // namespace

SumTables::SumTables(const Extent& grid, int block, bool apart)
    : grid_(grid),
      block_(block),
      apart_(apart),
      phase_((grid.x + block) / block),
      stride_(phase_ * block),
      table_(checked_product({stride_, grid.y + 1, grid.z + 1})) {
    if (3 * table_ + stride_ + kOverrun > std::numeric_limits<std::int32_t>::max()) {
        throw ResourceError("the tray is too large for this engine");
    }
    values_.assign(static_cast<std::size_t>(3 * table_ + stride_ + kOverrun), 0);
    if (block > 1) pooled_.assign(static_cast<std::size_t>(table_), 0);
}

/// Prefix sums of one row from x on.
void SumTables::sum_along(std::uint16_t* out, const std::uint16_t* from, int x) const {
    std::uint16_t sum = out[x];
    if (block_ == 1) {
        for (; x < grid_.x; ++x) {
            sum = static_cast<std::uint16_t>(sum + from[x]);
            out[x + 1] = sum;
        }
        return;
    }
    // In steps of a block, from one that is right: first its sums at phase 0, then each phase from the one before.
    const int first = x / block_;
    const auto count = static_cast<std::size_t>(phase_ - first);
    out += first;
    from += first;
    sum = *out;
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = sum;
        for (int p = 0; p < block_; ++p) {
            sum = static_cast<std::uint16_t>(sum + from[static_cast<std::size_t>(p * phase_) + i]);
        }
    }
    for (int p = 1; p < block_; ++p, out += phase_, from += phase_) {
        add_rows(out + phase_, out, from, count);
    }
}

void SumTables::pool(const DistanceGrid& phi, const VoxelBox& box, const Workers& workers) {
    const Extent& n = grid_;
    const int first = box.lo.x / block_, lo = first * block_;
    const int hi = std::min(n.x, box.hi.x + block_ - 1);
    const auto width = static_cast<std::size_t>(hi - lo);
    // Apart, values count from 1, and the 0 of an occupied voxel wraps around to the greatest.
    const std::uint16_t floor = apart_ ? 1 : 0;
    const int most = apart_ ? kMostPooled : std::numeric_limits<std::uint16_t>::max();
    workers.for_ranges(box.hi.z - box.lo.z, 2, [&](std::int64_t begin, std::int64_t end) {
        const int rows = std::min(n.y, box.hi.y + block_ - 1) - box.lo.y;
        std::vector<std::uint16_t> layer(width * static_cast<std::size_t>(rows));
        std::vector<std::uint16_t> least(width + static_cast<std::size_t>(block_));
        const auto layer_row = [&](int y) { return layer.data() + width * static_cast<std::size_t>(y - box.lo.y); };
        for (int z = box.lo.z + static_cast<int>(begin); z < box.lo.z + static_cast<int>(end); ++z) {
            for (int y = box.lo.y; y < box.lo.y + rows; ++y) {
                std::uint16_t* out = layer_row(y);
                std::fill_n(out, width, std::numeric_limits<std::uint16_t>::max());
                for (int dz = 0; dz < block_ && z + dz < n.z; ++dz) {
                    min_rows_above(out, phi.row(y, z + dz) + lo, floor, width);
                }
            }
            for (int y = box.lo.y; y < box.hi.y; ++y) {
                std::copy_n(layer_row(y), width, least.data());
                for (int dy = 1; dy < block_ && y + dy < n.y; ++dy) {
                    min_rows(least.data(), least.data(), layer_row(y + dy), width);
                }
                // Beyond the grid nothing counts.
                std::fill(least.begin() + static_cast<std::ptrdiff_t>(width), least.end(),
                          std::numeric_limits<std::uint16_t>::max());
                for (int step = 1; step < block_; step *= 2) {
                    min_rows(least.data(), least.data(), least.data() + step, width);
                }
                std::uint16_t* out = pooled_.data() + row(y, z);
                for (int p = 0; p < block_; ++p, out += phase_) {
                    const std::uint16_t* value = least.data() + p;
                    for (int i = first; block_ * i + p < box.hi.x; ++i, value += block_) {
                        out[i] = static_cast<std::uint16_t>(std::min(*value + floor, most));
                    }
                }
            }
        }
    });
}

void SumTables::update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers) {
    VoxelBox box = intersection(changed, whole(grid_));
    if (box.empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = std::max(0, box.lo[axis] - (block_ - 1));
    }
    if (block_ > 1) pool(phi, box, workers);

    std::uint16_t* along_x = values_.data();
    std::uint16_t* along_y = values_.data() + table_;
    std::uint16_t* along_z = values_.data() + 2 * table_;
    // A stretch of a row for each phase, or where that is most of it, all from the first on.
    const int first = box.lo.x / block_;
    const int count = (box.hi.x - 1) / block_ + 1 - first;
    const auto for_each_stretch = [&](const auto& visit) {
        if (block_ > 1 && 2 * count > phase_) {
            visit(first, static_cast<std::size_t>(stride_ - first));
            return;
        }
        for (int p = 0; p < block_; ++p) {
            visit(p * phase_ + first, static_cast<std::size_t>(count));
        }
    };
    workers.for_ranges(box.hi.z - box.lo.z, 2, [&](std::int64_t begin, std::int64_t end) {
        for (int z = box.lo.z + static_cast<int>(begin); z < box.lo.z + static_cast<int>(end); ++z) {
            for (int y = box.lo.y; y < box.hi.y; ++y) {
                std::uint16_t* out = along_x + row(y, z);
                const std::uint16_t* from = pooled_row(phi, y, z);
                sum_along(out, from, box.lo.x);
            }
            for (int y = box.lo.y; y < grid_.y; ++y) {
                std::uint16_t* out = along_y + row(y, z);
                const std::uint16_t* from = pooled_row(phi, y, z);
                for_each_stretch(
                    [&](int i, std::size_t length) { add_rows(out + stride_ + i, out + i, from + i, length); });
            }
        }
    });
    workers.for_ranges(box.hi.y - box.lo.y, 4, [&](std::int64_t begin, std::int64_t end) {
        const std::int64_t up = row(0, 1);
        for (int z = box.lo.z; z < grid_.z; ++z) {
            for (int y = box.lo.y + static_cast<int>(begin); y < box.lo.y + static_cast<int>(end); ++y) {
                std::uint16_t* out = along_z + row(y, z);
                const std::uint16_t* from = pooled_row(phi, y, z);
                for_each_stretch([&](int i, std::size_t length) { add_rows(out + up + i, out + i, from + i, length); });
            }
        }
    });
}

}  // namespace spectralpack
