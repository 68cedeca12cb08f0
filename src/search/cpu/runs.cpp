#include "search/cpu/runs.hpp"

#include <bit>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// Word w of row (y, z), 0 outside the grid.
Word word_at(const BitGrid& bits, int w, int y, int z) {
    const Extent& e = bits.extent();
    if (w < 0 || w >= bits.words_per_row() || y < 0 || y >= e.y || z < 0 || z >= e.z) return 0;
    return bits.row(y, z)[w];
}

/// Bits of word w of row (y, z) at which a run along `axis` starts: set, and the voxel before is
/// not.
Word run_starts(const BitGrid& bits, int axis, int w, int y, int z) {
    const Word word = bits.row(y, z)[w];
    if (axis == 0) return word & ~(word << 1 | word_at(bits, w - 1, y, z) >> 63);
    return word & ~(axis == 1 ? word_at(bits, w, y - 1, z) : word_at(bits, w, y, z - 1));
}

int run_length(const BitGrid& bits, int axis, const VoxelIndex& start) {
    if (axis != 0) {
        const Word bit = Word{1} << (start.x % 64);
        int length = 1;
        if (axis == 1) {
            while (word_at(bits, start.x / 64, start.y + length, start.z) & bit)
                ++length;
        } else {
            while (word_at(bits, start.x / 64, start.y, start.z + length) & bit)
                ++length;
        }
        return length;
    }
    int w = start.x / 64;
    int length = std::countr_one(bits.row(start.y, start.z)[w] >> (start.x % 64));
    if (length < 64 - start.x % 64) return length;
    length = 64 - start.x % 64;
    for (++w; w < bits.words_per_row(); ++w) {
        const int ones = std::countr_one(bits.row(start.y, start.z)[w]);
        length += ones;
        if (ones < 64) break;
    }
    return length;
}

}  // namespace

std::vector<std::int64_t> count_runs(const BitGrid& bits) {
    std::vector<std::int64_t> count(3, 0);
    for (int z = 0; z < bits.extent().z; ++z) {
        for (int y = 0; y < bits.extent().y; ++y) {
            for (int w = 0; w < bits.words_per_row(); ++w) {
                if (bits.row(y, z)[w] == 0) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    count[static_cast<std::size_t>(axis)] += std::popcount(run_starts(bits, axis, w, y, z));
                }
            }
        }
    }
    return count;
}

Runs runs_along(const BitGrid& bits, int axis) {
    Runs result;
    result.axis = axis;
    for (int z = 0; z < bits.extent().z; ++z) {
        for (int y = 0; y < bits.extent().y; ++y) {
            for (int w = 0; w < bits.words_per_row(); ++w) {
                for (Word starts = run_starts(bits, axis, w, y, z); starts != 0; starts &= starts - 1) {
                    const VoxelIndex start{64 * w + std::countr_zero(starts), y, z};
                    const int length = run_length(bits, axis, start);
                    result.runs.push_back({start, length});
                    result.voxels += length;
                }
            }
        }
    }
    return result;
}

Runs fewest_runs(const BitGrid& bits) {
    const std::vector<std::int64_t> count = count_runs(bits);
    int best = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (count[static_cast<std::size_t>(axis)] < count[static_cast<std::size_t>(best)]) best = axis;
    }
    return runs_along(bits, best);
}

}  // namespace spectralpack
