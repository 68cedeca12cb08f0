#include "search/cpu/bit_tables.hpp"

#include <limits>

namespace spectralpack {
namespace {

using Word = std::uint64_t;

/// 64 bits of a row from bit `first` on, 0 outside the row.
Word row_bits(const Word* row, int words, int first) {
    const int w = first >= 0 ? first / 64 : -((63 - first) / 64);
    const int shift = first - 64 * w;
    const auto at = [&](int i) { return i >= 0 && i < words ? row[i] : Word{0}; };
    return shift == 0 ? at(w) : at(w) >> shift | at(w + 1) << (64 - shift);
}

}  // namespace

BitTables::BitTables(const Extent& grid, int margin, int detail, int fine_layers, int coarse_layers)
    : grid_(grid),
      margin_(margin),
      detail_(detail),
      fine_layers_(fine_layers),
      coarse_layers_(coarse_layers),
      columns_((grid.x + 2 * margin + 63) / 64 + 1),
      column_(grid.y + 2 * margin),
      table_(checked_product({columns_, column_, grid.z + 2 * margin})) {
    const std::int64_t groups = checked_product({fine_layers, part_count(detail)}) + coarse_layers;
    const std::int64_t words = checked_product({table_, groups, kTables}) + column_ + 64;
    if (words > std::numeric_limits<std::int32_t>::max()) {
        throw ResourceError("the tray is too large for this engine");
    }
    words_.assign(static_cast<std::size_t>(words), 0);
}

BitTables::Place BitTables::place(int layer, int axis, int level, const VoxelIndex& d) const {
    const int s = detail(layer);
    VoxelIndex coarse;
    for (int i = 0; i < 3; ++i) {
        coarse[i] = floor_div(d[i], s);
    }
    const int part = ((d.z - s * coarse.z) * s + d.y - s * coarse.y) * s + d.x - s * coarse.x;
    const int bit = coarse.x + margin_;
    const std::int64_t offset =
        table_offset(layer, part, axis, level) +
        (static_cast<std::int64_t>(coarse.z + margin_) * columns_ + bit / 64) * column_ + coarse.y + margin_;
    return {static_cast<std::int32_t>(offset), bit % 64};
}

void BitTables::refresh_plain(Word* plain, const BitGrid& occupied, const VoxelBox& changed) {
    const int first = (changed.lo.x + margin_) / 64;
    const int last = (changed.hi.x - 1 + margin_) / 64;
    for (int z = changed.lo.z; z < changed.hi.z; ++z) {
        for (int y = changed.lo.y; y < changed.hi.y; ++y) {
            const Word* row = occupied.row(y, z);
            for (int w = first; w <= last; ++w) {
                plain[(static_cast<std::int64_t>(z + margin_) * columns_ + w) * column_ + y +
                      margin_] = row_bits(row, occupied.words_per_row(), 64 * w - margin_);
            }
        }
    }
}

/// to = from OR `moved` moved down by `by` voxels of dx along the axis, for the words of lo <= X < hi (margin included).
void BitTables::dilate(Word* to, const Word* from, const Word* moved, int axis, int by, const VoxelIndex& lo,
                       const VoxelIndex& hi) {
    const int rows = static_cast<int>(column_), layers = grid_.z + 2 * margin_;
    for (int z = lo.z; z < hi.z; ++z) {
        for (int w = lo.x / 64; w <= (hi.x - 1) / 64; ++w) {
            const std::int64_t at = (static_cast<std::int64_t>(z) * columns_ + w) * column_;
            if (axis == 0 && by > 0) {
                for (std::int64_t y = at + lo.y; y < at + hi.y; ++y) {
                    to[y] = from[y] | moved[y] >> by | moved[y + column_] << (64 - by);
                }
            } else if (axis == 1) {
                const int both = std::min(hi.y, rows - by);
                for (std::int64_t y = at + lo.y; y < at + both; ++y) {
                    to[y] = from[y] | moved[y + by];
                }
                for (std::int64_t y = at + std::max(lo.y, both); y < at + hi.y; ++y) {
                    to[y] = from[y];
                }
            } else {
                const bool both = axis == 0 || z + by < layers;
                const std::int64_t up = axis == 0 ? 0 : by * static_cast<std::int64_t>(columns_) * column_;
                for (std::int64_t y = at + lo.y; y < at + hi.y; ++y) {
                    to[y] = both ? from[y] | moved[y + up] : from[y];
                }
            }
        }
    }
}

void BitTables::refresh(int layer, const std::vector<const BitGrid*>& parts, const VoxelBox& changed) {
    const VoxelBox box = intersection(changed, whole(grid_));
    if (box.empty()) return;
    const int s = detail(layer);
    const auto table = [&](int part, int axis, int level) {
        return words_.data() + table_offset(layer, part, axis, level);
    };
    for (int part = 0; part < part_count(s); ++part) {
        refresh_plain(table(part, 0, 0), *parts[static_cast<std::size_t>(part)], box);
    }
    int stride = 1;  // from a part to the next along the axis
    for (int axis = 0; axis < 3; ++axis, stride *= s) {
        for (int level = 1; level <= kLevels; ++level) {
            const int half = 1 << (level - 1);
            // In table coordinates (the margin included), what can differ.
            VoxelIndex lo = box.lo + VoxelIndex{margin_, margin_, margin_};
            const VoxelIndex hi = box.hi + VoxelIndex{margin_, margin_, margin_};
            lo[axis] = std::max(0, lo[axis] - ceil_div(2 * half - 1, s));
            for (int part = 0; part < part_count(s); ++part) {
                const int along = part / stride % s;
                const int other = part + ((along + half) % s - along) * stride;
                dilate(table(part, axis, level), table(part, axis, level - 1), table(other, axis, level - 1), axis,
                       (along + half) / s, lo, hi);
            }
        }
    }
}

}  // namespace spectralpack
