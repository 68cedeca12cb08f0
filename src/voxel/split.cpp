#include "voxel/split.hpp"

#include <algorithm>
#include <bit>
#include <span>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// How fine voxels lie in coarse ones.
struct Layout {
    VoxelIndex offset;  ///< coarse voxel of the grid's voxel (0,0,0)
    VoxelIndex rest;    ///< fine voxels from its lower corner to there
    Extent extent;      ///< coarse voxels that the grid touches
};

Layout layout_of(const Extent& fine, const VoxelIndex& at, int detail) {
    Layout layout;
    for (int axis = 0; axis < 3; ++axis) {
        layout.offset[axis] = floor_div(at[axis], detail);
        layout.rest[axis] = at[axis] - detail * layout.offset[axis];
        layout.extent[axis] = ceil_div(layout.rest[axis] + fine[axis], detail);
    }
    return layout;
}

enum class Rule { some, every };

/// 64 bits of a row from bit `first` on, 0 outside the row; first > -64.
Word bits_at(std::span<const Word> row, int first) {
    if (first < 0) return row[0] << -first;
    const auto w = static_cast<std::size_t>(first / BitGrid::kWordBits);
    const int shift = first % BitGrid::kWordBits;
    Word bits = w < row.size() ? row[w] >> shift : 0;
    if (shift > 0 && w + 1 < row.size()) bits |= row[w + 1] << (BitGrid::kWordBits - shift);
    return bits;
}

/// Every second bit, from the lowest on.
Word every_second(Word bits) {
    bits &= 0x5555555555555555u;
    bits = (bits | bits >> 1) & 0x3333333333333333u;
    bits = (bits | bits >> 2) & 0x0F0F0F0F0F0F0F0Fu;
    bits = (bits | bits >> 4) & 0x00FF00FF00FF00FFu;
    bits = (bits | bits >> 8) & 0x0000FFFF0000FFFFu;
    return (bits | bits >> 16) & 0x00000000FFFFFFFFu;
}

/// Voxel detail * i + p - rest of a row becomes voxel i of part_row(p); i < count.
template <class PartRow>
void deal_out(std::span<const Word> row, int rest, int count, int detail, const PartRow& part_row) {
    if (detail == 2) {  // as nearly always: half a word at once
        for (int p = 0; p < 2; ++p) {
            Word* to = part_row(p);
            for (int x = 0; x < count; x += BitGrid::kWordBits / 2) {
                to[x / BitGrid::kWordBits] |= every_second(bits_at(row, 2 * x + p - rest)) << (x % BitGrid::kWordBits);
            }
        }
        return;
    }
    for (std::size_t w = 0; w < row.size(); ++w) {
        for (Word bits = row[w]; bits != 0; bits &= bits - 1) {
            const int x = BitGrid::kWordBits * static_cast<int>(w) + std::countr_zero(bits) + rest;
            part_row(x % detail)[x / detail / BitGrid::kWordBits] |= Word{1} << (x / detail % BitGrid::kWordBits);
        }
    }
}

/// The coarse voxels of which some or every fine voxel is set.
CoarseVoxels pooled(const BitGrid& fine, const VoxelIndex& at, int detail, Rule rule) {
    const Layout layout = layout_of(fine.extent(), at, detail);
    CoarseVoxels result{BitGrid(layout.extent), layout.offset};
    const auto words = static_cast<std::size_t>(fine.words_per_row());
    const std::vector<Word> outside(words, 0);
    std::vector<Word> row(words);
    const Word all = (Word{1} << detail) - 1;  // the bits of one coarse voxel
    for (int z = 0; z < layout.extent.z; ++z) {
        for (int y = 0; y < layout.extent.y; ++y) {
            for (int i = 0; i < detail * detail; ++i) {
                const int fy = detail * y + i % detail - layout.rest.y;
                const int fz = detail * z + i / detail - layout.rest.z;
                const bool inside = fy >= 0 && fy < fine.extent().y && fz >= 0 && fz < fine.extent().z;
                const Word* from = inside ? fine.row(fy, fz) : outside.data();
                for (std::size_t w = 0; w < words; ++w) {
                    row[w] = i == 0 ? from[w] : rule == Rule::some ? row[w] | from[w] : row[w] & from[w];
                }
            }
            if (std::ranges::all_of(row, [](Word word) { return word == 0; })) continue;
            Word* to = result.voxels.row(y, z);
            if (detail == 2) {  // as nearly always: half a word at once
                for (int x = 0; x < layout.extent.x; x += BitGrid::kWordBits / 2) {
                    const Word bits = bits_at(row, 2 * x - layout.rest.x);
                    const Word next = bits_at(row, 2 * x - layout.rest.x + 1);
                    const Word coarse = every_second(rule == Rule::some ? bits | next : bits & next);
                    to[x / BitGrid::kWordBits] |= coarse << (x % BitGrid::kWordBits);
                }
                continue;
            }
            for (int x = 0; x < layout.extent.x; ++x) {
                const Word group = bits_at(row, detail * x - layout.rest.x) & all;
                to[x / BitGrid::kWordBits] |= Word{rule == Rule::some ? group != 0 : group == all}
                                              << (x % BitGrid::kWordBits);
            }
        }
    }
    return result;
}

}  // namespace

SplitVoxels split(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {{fine}, at};
    const Layout layout = layout_of(fine.extent(), at, detail);
    SplitVoxels result{{static_cast<std::size_t>(part_count(detail)), BitGrid(layout.extent)}, layout.offset};
    for (int z = 0; z < fine.extent().z; ++z) {
        for (int y = 0; y < fine.extent().y; ++y) {
            const int fy = y + layout.rest.y, fz = z + layout.rest.z;
            const int first = (fz % detail * detail + fy % detail) * detail;
            const std::span row(fine.row(y, z), static_cast<std::size_t>(fine.words_per_row()));
            deal_out(row, layout.rest.x, layout.extent.x, detail, [&](int part) {
                return result.parts[static_cast<std::size_t>(first + part)].row(fy / detail, fz / detail);
            });
        }
    }
    return result;
}

CoarseVoxels reached_voxels(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {fine, at};
    return pooled(fine, at, detail, Rule::some);
}

CoarseVoxels filled_voxels(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {fine, at};
    return pooled(fine, at, detail, Rule::every);
}

}  // namespace spectralpack
