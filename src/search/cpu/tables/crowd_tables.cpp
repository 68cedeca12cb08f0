#include "search/cpu/tables/crowd_tables.hpp"

#include <algorithm>

#include "core/checked.hpp"
#include "search/cpu/tables/block_bits.hpp"
#include "search/cpu/tables/kernels.hpp"

namespace spectralpack {
namespace {

using Word = std::uint64_t;

constexpr int kReach = 2 * CrowdTables::kBlock - 1;  // voxels that a bit tells of, along each axis

/// Ones beyond voxel `end` of a row, in its word w.
Word beyond(int w, int end) {
    const int first = end - 64 * w;
    return first >= 64 ? 0 : first <= 0 ? ~Word{0} : ~Word{0} << first;
}

/// Bit i: voxels 4 i to 4 i + 6 are all set, of a word and the one after.
std::uint32_t all_of_reach(Word word, Word after) {
    const Word three = word & word >> 1 & word >> 2;
    const Word three_after = after & after >> 1 & after >> 2;
    return every_fourth(three & word >> 3 & (three >> 4 | three_after << 60));
}

}  // namespace

CrowdTables::CrowdTables(const BitTables& bits)
    : voxels_(bits.voxels()),
      first_layer_(bits.detail() > 1 ? bits.fine_layers() : 0),
      first_table_(bits.first_table(first_layer_)),
      columns_(ceil_div(voxels_.x, kBlock * kTileX) + 1),
      column_(ceil_div(voxels_.y, kBlock)),
      table_(checked_product({columns_, column_, ceil_div(voxels_.z, kBlock)})),
      // A tile at the end reads on beyond it.
      words_(static_cast<std::size_t>((bits.tables() - first_table_) * table_ + column_ + kTileY), 0) {}

BitTables::Place CrowdTables::place(const BitTables::Spot& spot) const {
    const int x = spot.at.x / kBlock;
    const std::int64_t offset = (spot.table - first_table_) * table_ +
                                (static_cast<std::int64_t>(spot.at.z / kBlock) * columns_ + x / kTileX) * column_ +
                                spot.at.y / kBlock;
    return {static_cast<std::int32_t>(offset), x % kTileX};
}

void CrowdTables::refresh_table(const BitTables& bits, int table, const VoxelBox& changed) {
    VoxelBox blocks;
    for (int axis = 1; axis < 3; ++axis) {
        blocks.lo[axis] = std::max(0, ceil_div(changed.lo[axis] - kReach + 1, kBlock));
        blocks.hi[axis] = ceil_div(changed.hi[axis], kBlock);
    }
    const int first_row = kBlock * blocks.lo.y;
    const int rows = std::min(kBlock * (blocks.hi.y - 1) + kReach, voxels_.y) - first_row;
    std::vector<Word> row(static_cast<std::size_t>(rows)), row_after(row.size());
    constexpr int kAfter = kReach - kBlock;  // voxels that blocks reach into the next word
    const int first = std::max(0, changed.lo.x - kAfter) / 64, last = (changed.hi.x - 1) / 64;
    for (int z = blocks.lo.z; z < blocks.hi.z; ++z) {
        for (int w = first; w <= last; ++w) {
            std::ranges::fill(row, ~Word{0});
            std::ranges::fill(row_after, ~Word{0});
            for (int k = kBlock * z; k < std::min(kBlock * z + kReach, voxels_.z); ++k) {
                kernels().and_rows(row.data(), bits.column(table, w, k) + first_row, row.size());
                kernels().and_rows(row_after.data(), bits.column(table, w + 1, k) + first_row, row.size());
            }
            Word* to = words_.data() + (table - first_table_) * table_ +
                       (static_cast<std::int64_t>(z) * columns_ + w / kBlock) * column_;
            const int shift = 16 * (w % kBlock);
            for (int y = blocks.lo.y; y < blocks.hi.y; ++y) {
                Word all = ~Word{0}, all_after = ~Word{0};
                for (int k = kBlock * y - first_row; k < std::min(kBlock * y - first_row + kReach, rows); ++k) {
                    all &= row[static_cast<std::size_t>(k)];
                    all_after &= row_after[static_cast<std::size_t>(k)];
                }
                const Word none = beyond(w, voxels_.x);
                const Word crowded =
                    all_of_reach(all | none, all_after | beyond(w + 1, voxels_.x)) & every_fourth(~none);
                to[y] = (to[y] & ~(Word{0xFFFF} << shift)) | crowded << shift;
            }
        }
    }
}

void CrowdTables::refresh(const BitTables& bits, int layer, const VoxelBox& changed, const Workers& workers) {
    struct Part {
        int table;
        VoxelBox changed;
    };
    std::vector<Part> parts;
    bits.for_each_table(layer, changed, [&](int table, const Form& form, const VoxelBox& box) {
        if (holds(layer, form)) parts.push_back({table, box});
    });
    workers.for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t i) {
        const Part& part = parts[static_cast<std::size_t>(i)];
        refresh_table(bits, part.table, part.changed);
    });
}

}  // namespace spectralpack
