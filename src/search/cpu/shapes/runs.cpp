#include "search/cpu/shapes/runs.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// Words to the next voxel along axis 1 or 2.
std::ptrdiff_t step_along(const BitGrid& bits, int axis) {
    return std::ptrdiff_t{bits.words_per_row()} * (axis == 1 ? 1 : bits.extent().y);
}

/// Bits of word w of a row at which a run along `axis` starts: set, and the voxel before is not. `at` is the row's y or
/// z for axis 1 or 2.
Word run_starts(const BitGrid& bits, int axis, const Word* row, int w, int at) {
    const Word word = row[w];
    if (axis == 0) return word & ~(word << 1 | (w > 0 ? row[w - 1] >> 63 : 0));
    return at == 0 ? word : word & ~row[w - step_along(bits, axis)];
}

/// Of the run that starts at voxel `x` of a row, which is row `at` along the axis.
int run_length(const BitGrid& bits, int axis, const Word* row, int x, int at) {
    if (axis != 0) {
        const std::ptrdiff_t step = step_along(bits, axis);
        const int most = bits.extent()[axis] - at;
        const Word bit = Word{1} << (x % 64);
        const Word* word = row + x / 64;
        int length = 1;
        while (length < most && (word[length * step] & bit) != 0)
            ++length;
        return length;
    }
    int w = x / 64;
    int length = std::countr_one(row[w] >> (x % 64));
    if (length < 64 - x % 64) return length;
    for (++w; w < bits.words_per_row(); ++w) {
        const int ones = std::countr_one(row[w]);
        length += ones;
        if (ones < 64) break;
    }
    return length;
}

/// Calls visit(row, y, z) for all rows.
template <class Visit>
void for_each_row(const BitGrid& bits, const Visit& visit) {
    for (int z = 0; z < bits.extent().z; ++z) {
        for (int y = 0; y < bits.extent().y; ++y) {
            visit(bits.row(y, z), y, z);
        }
    }
}

/// runs_along(), about `expected` of them.
Runs runs_along(const BitGrid& bits, int axis, std::int64_t expected) {
    Runs result;
    result.axis = axis;
    result.runs.reserve(static_cast<std::size_t>(expected));
    for_each_row(bits, [&](const Word* row, int y, int z) {
        const int at = axis == 1 ? y : z;
        for (int w = 0; w < bits.words_per_row(); ++w) {
            if (row[w] == 0) continue;
            for (Word starts = run_starts(bits, axis, row, w, at); starts != 0; starts &= starts - 1) {
                const VoxelIndex start{64 * w + std::countr_zero(starts), y, z};
                const int length = run_length(bits, axis, row, start.x, at);
                result.runs.push_back({start, length});
                result.voxels += length;
            }
        }
    });
    return result;
}

}  // namespace

std::vector<std::int64_t> count_runs(const BitGrid& bits) {
    std::vector<std::int64_t> count(3, 0);
    for_each_row(bits, [&](const Word* row, int y, int z) {
        for (int w = 0; w < bits.words_per_row(); ++w) {
            if (row[w] == 0) continue;
            count[0] += std::popcount(run_starts(bits, 0, row, w, 0));
            count[1] += std::popcount(run_starts(bits, 1, row, w, y));
            count[2] += std::popcount(run_starts(bits, 2, row, w, z));
        }
    });
    return count;
}

Runs runs_along(const BitGrid& bits, int axis) { return runs_along(bits, axis, 0); }

Runs fewest_runs(const BitGrid& bits) {
    const std::vector<std::int64_t> count = count_runs(bits);
    const auto fewest = std::ranges::min_element(count);
    return runs_along(bits, static_cast<int>(fewest - count.begin()), *fewest);
}

}  // namespace spectralpack
