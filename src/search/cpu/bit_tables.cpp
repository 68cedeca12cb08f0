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

BitTables::BitTables(const Extent& grid, int margin, int layers)
    : grid_(grid),
      margin_(margin),
      layers_(layers),
      columns_((grid.x + 2 * margin + 63) / 64 + 1),
      column_(grid.y + 2 * margin),
      table_(checked_product({columns_, column_, grid.z + 2 * margin})) {
    const std::int64_t tables = static_cast<std::int64_t>(layers) * kTables;
    const std::int64_t words = checked_product({table_, tables}) + column_ + 64;
    if (words > std::numeric_limits<std::int32_t>::max()) {
        throw ResourceError("the tray is too large for this engine");
    }
    words_.assign(static_cast<std::size_t>(words), 0);
}

BitTables::Place BitTables::place(int layer, int axis, int level, const VoxelIndex& d) const {
    const int index = level == 0 ? 0 : 1 + axis * kLevels + level - 1;
    const int bit = d.x + margin_;
    const std::int64_t offset =
        (static_cast<std::int64_t>(layer) * kTables + index) * table_ +
        (static_cast<std::int64_t>(d.z + margin_) * columns_ + bit / 64) * column_ + d.y + margin_;
    return {static_cast<std::int32_t>(offset), bit % 64};
}

void BitTables::refresh_plain(int layer, const BitGrid& occupied, const VoxelBox& changed) {
    Word* plain = table(layer, 0, 0);
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

void BitTables::refresh(int layer, const BitGrid& occupied, const VoxelBox& changed) {
    const VoxelBox box = intersection(changed, whole(grid_));
    if (box.empty()) return;
    refresh_plain(layer, occupied, box);
    const VoxelIndex size{(columns_ - 1) * 64, static_cast<int>(column_), grid_.z + 2 * margin_};
    for (int axis = 0; axis < 3; ++axis) {
        for (int level = 1; level <= kLevels; ++level) {
            const int half = 1 << (level - 1);
            // In table coordinates (the margin included), what can differ.
            VoxelIndex lo = box.lo + VoxelIndex{margin_, margin_, margin_};
            const VoxelIndex hi = box.hi + VoxelIndex{margin_, margin_, margin_};
            lo[axis] = std::max(0, lo[axis] - (2 * half - 1));
            const Word* from = table(layer, axis, level - 1);
            Word* to = table(layer, axis, level);
            for (int z = lo.z; z < hi.z; ++z) {
                for (int w = lo.x / 64; w <= (hi.x - 1) / 64; ++w) {
                    const std::int64_t at = (static_cast<std::int64_t>(z) * columns_ + w) * column_;
                    if (axis == 0) {
                        for (std::int64_t y = at + lo.y; y < at + hi.y; ++y) {
                            to[y] = from[y] | from[y] >> half | from[y + column_] << (64 - half);
                        }
                    } else if (axis == 1) {
                        const int both = std::min(hi.y, size.y - half);
                        for (std::int64_t y = at + lo.y; y < at + both; ++y) {
                            to[y] = from[y] | from[y + half];
                        }
                        for (std::int64_t y = at + std::max(lo.y, both); y < at + hi.y; ++y) {
                            to[y] = from[y];
                        }
                    } else {
                        const bool both = z + half < size.z;
                        const std::int64_t up =
                            both ? half * static_cast<std::int64_t>(columns_) * column_ : 0;
                        for (std::int64_t y = at + lo.y; y < at + hi.y; ++y) {
                            to[y] = from[y] | from[y + up];
                        }
                    }
                }
            }
        }
    }
}

}  // namespace spectralpack
