#include "voxel/axis_turn.hpp"

#include <algorithm>
#include <bit>
#include <vector>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;
constexpr int kSide = BitGrid::kWordBits;
using Block = std::array<Word, kSide>;  ///< 64 x 64 bits

/// Bit j of word i becomes bit i of word j, for i, j < side, a power of two (Warren, Hacker's Delight, section 7-3);
/// other bits of these words are 0.
void transpose(Block& block, int side) {
    Word mask = 0x00000000ffffffffu;
    for (int step = kSide / 2; step != 0; step /= 2, mask ^= mask << step) {
        for (int first = 0; first + step < side; first += 2 * step) {
            for (int i = first; i < first + step; ++i) {
                const Word exchange = ((block[i] >> step) ^ block[i + step]) & mask;
                block[i] ^= exchange << step;
                block[i + step] ^= exchange;
            }
        }
    }
}

/// The source's row at these coordinates along the axes other than x.
const Word* source_row(const BitGrid& grid, int axis, int at, int other) {
    return axis == 1 ? grid.row(at, other) : grid.row(other, at);
}

int there(bool reversed, int at, int length) { return reversed ? length - 1 - at : at; }

/// The source's row that comes to lie at (y, z), if perhaps reversed, by a turn that keeps x.
const Word* row_turned_to(const BitGrid& grid, const AxisTurn& turn, int y, int z) {
    const Extent& n = grid.extent();
    return source_row(grid, turn.order[1], there(turn.reversed[1], y, n[turn.order[1]]),
                      there(turn.reversed[2], z, n[turn.order[2]]));
}

/// Bit 63 becomes bit 0 (Hacker's Delight, section 7-1).
Word reversed_bits(Word word) {
    constexpr Word kMasks[] = {0x5555555555555555u, 0x3333333333333333u, 0x0f0f0f0f0f0f0f0fu};
    int step = 1;
    for (const Word mask : kMasks) {
        word = (word >> step & mask) | (word & mask) << step;
        step *= 2;
    }
    return __builtin_bswap64(word);
}

/// Bit n - 1 of a row of that many words becomes its bit 0.
void reverse_row(Word* row, std::size_t words, int n) {
    std::reverse(row, row + words);
    std::transform(row, row + words, row, reversed_bits);
    const int beyond = static_cast<int>(words) * kSide - n;  // of the last word, which came first
    if (beyond == 0) return;
    for (std::size_t i = 0; i < words; ++i) {
        row[i] = row[i] >> beyond | (i + 1 < words ? row[i + 1] << (kSide - beyond) : 0);
    }
}

}  // namespace

BitGrid turned(const BitGrid& grid, const AxisTurn& turn) {
    const Extent& n = grid.extent();
    const AxisOrder& order = turn.order;
    BitGrid result(turned(n, turn));
    const Extent& m = result.extent();
    if (order[0] == 0) {
        const auto words = static_cast<std::size_t>(grid.words_per_row());
        for (int z = 0; z < m.z; ++z) {
            for (int y = 0; y < m.y; ++y) {
                Word* row = result.row(y, z);
                std::copy_n(row_turned_to(grid, turn, y, z), words, row);
                if (turn.reversed[0]) reverse_row(row, words, m.x);
            }
        }
        return result;
    }
    // Planes of the source's x and the axis that becomes x, turned over block by block; in a row of blocks the source's
    // rows are taken in the order in which they become bits.
    const int across = order[0], third = 3 - across;
    const bool x_becomes_y = order[1] == 0;
    const bool x_reversed = turn.reversed[x_becomes_y ? 1 : 2], layers_reversed = turn.reversed[x_becomes_y ? 2 : 1];
    Block block;
    for (int layer = 0; layer < n[third]; ++layer) {
        const int to_layer = there(layers_reversed, layer, n[third]);
        for (int to = 0; to < n[across]; to += kSide) {
            const int rows = std::min(kSide, n[across] - to);
            for (int word = 0; word < grid.words_per_row(); ++word) {
                const int columns = std::min(kSide, n.x - word * kSide);
                const auto side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(rows, columns))));
                std::fill_n(block.begin(), side, Word{0});
                for (int i = 0; i < rows; ++i) {
                    block[i] = source_row(grid, across, there(turn.reversed[0], to + i, n[across]), layer)[word];
                }
                transpose(block, side);
                for (int i = 0; i < columns; ++i) {
                    const int x = there(x_reversed, word * kSide + i, n.x);
                    Word* row = x_becomes_y ? result.row(x, to_layer) : result.row(to_layer, x);
                    row[to / kSide] = block[i];
                }
            }
        }
    }
    return result;
}

bool is_symmetric(const BitGrid& grid, const AxisTurn& turn) {
    const Extent& n = grid.extent();
    if (turned(n, turn) != n) return false;
    if (turn.order[0] != 0) return turned(grid, turn) == grid;
    const auto words = static_cast<std::size_t>(grid.words_per_row());
    std::vector<Word> row(words);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            std::copy_n(row_turned_to(grid, turn, y, z), words, row.data());
            if (turn.reversed[0]) reverse_row(row.data(), words, n.x);
            if (!std::equal(row.begin(), row.end(), grid.row(y, z))) return false;
        }
    }
    return true;
}

AxisTurn inverse(const AxisTurn& turn) {
    AxisTurn back;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<std::size_t>(turn.order[axis]);
        back.order[from] = static_cast<int>(axis);
        back.reversed[from] = turn.reversed[axis];
    }
    return back;
}

AxisTurn chained(const AxisTurn& first, const AxisTurn& second) {
    AxisTurn both;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto between = static_cast<std::size_t>(second.order[axis]);
        both.order[axis] = first.order[between];
        both.reversed[axis] = first.reversed[between] != second.reversed[axis];
    }
    return both;
}

std::optional<AxisTurn> axis_turn(const Mat3& from, const Mat3& to) {
    AxisTurn turn;
    do {
        bool equal = true;
        for (std::size_t axis = 0; axis < 3 && equal; ++axis) {
            const Vec3& row = from.rows[static_cast<std::size_t>(turn.order[axis])];
            turn.reversed[axis] = !(to.rows[axis] == row);
            equal = !turn.reversed[axis] || to.rows[axis] == -row;
        }
        if (equal) return turn;
    } while (std::ranges::next_permutation(turn.order).found);
    return std::nullopt;
}

Box turned(const Box& box, const AxisTurn& turn) {
    Box result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double low = box.min[turn.order[i]], high = box.max[turn.order[i]];
        result.min[axis] = turn.reversed[i] ? -high : low;
        result.max[axis] = turn.reversed[i] ? -low : high;
    }
    return result;
}

}  // namespace spectralpack
