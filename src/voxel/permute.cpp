#include "voxel/permute.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;
constexpr int kSide = BitGrid::kWordBits;
using Block = std::array<Word, kSide>;  ///< 64 x 64 bits

/// Bit j of word i becomes bit i of word j (Warren, Hacker's Delight, section 7-3).
void transpose(Block& block) {
    Word mask = 0x00000000ffffffffu;
    for (int step = kSide / 2; step != 0; step /= 2, mask ^= mask << step) {
        for (int i = 0; i < kSide; i = (i + step + 1) & ~step) {
            const Word exchange = ((block[i] >> step) ^ block[i + step]) & mask;
            block[i] ^= exchange << step;
            block[i + step] ^= exchange;
        }
    }
}

/// The source's row at these coordinates along the axes other than x.
const Word* source_row(const BitGrid& grid, int axis, int at, int other) {
    return axis == 1 ? grid.row(at, other) : grid.row(other, at);
}

}  // namespace

BitGrid permuted(const BitGrid& grid, const AxisOrder& order) {
    const Extent& n = grid.extent();
    BitGrid result({n[order[0]], n[order[1]], n[order[2]]});
    const Extent& m = result.extent();
    if (order[0] == 0) {
        for (int z = 0; z < m.z; ++z) {
            for (int y = 0; y < m.y; ++y) {
                std::copy_n(source_row(grid, order[1], y, z), grid.words_per_row(), result.row(y, z));
            }
        }
        return result;
    }
    // Planes of the source's x and the axis that becomes x, turned over block by block.
    const int across = order[0], third = 3 - across;
    const bool x_becomes_y = order[1] == 0;
    Block block;
    for (int layer = 0; layer < n[third]; ++layer) {
        for (int from = 0; from < n[across]; from += kSide) {
            const int rows = std::min(kSide, n[across] - from);
            for (int word = 0; word < grid.words_per_row(); ++word) {
                block.fill(0);
                for (int i = 0; i < rows; ++i) {
                    block[i] = source_row(grid, across, from + i, layer)[word];
                }
                transpose(block);
                for (int i = 0; i < std::min(kSide, n.x - word * kSide); ++i) {
                    const int x = word * kSide + i;
                    Word* row = x_becomes_y ? result.row(x, layer) : result.row(layer, x);
                    row[from / kSide] = block[i];
                }
            }
        }
    }
    return result;
}

std::optional<AxisOrder> exchanged_axes(const Mat3& turn, const Mat3& of) {
    AxisOrder order{0, 1, 2};
    do {
        bool equal = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            equal = equal && turn.rows[axis] == of.rows[static_cast<std::size_t>(order[axis])];
        }
        if (equal) return order;
    } while (std::ranges::next_permutation(order).found);
    return std::nullopt;
}

}  // namespace spectralpack
