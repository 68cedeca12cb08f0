#include "search/cpu/free_rows.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// out |= in, moved down by `shift` bits (up if it is negative).
void or_shifted(Word* out, int out_words, const Word* in, int in_words, int shift) {
    const int words = shift >= 0 ? shift / 64 : -((63 - shift) / 64);
    const int bits = shift - 64 * words;
    const int first = std::max(0, -words - 1);
    const int last = std::min(out_words, in_words - words);
    for (int i = first; i < last; ++i) {
        const int j = i + words;
        Word word = j >= 0 ? in[j] >> bits : 0;
        if (bits > 0 && j + 1 < in_words) word |= in[j + 1] << (64 - bits);
        out[i] |= word;
    }
}

}  // namespace

FreeRows::FreeRows(const BitGrid& omega, const BitGrid& solid, int padding)
    : grid_(omega.extent()), runs_(runs_along(solid, 0)) {
    int longest = 1;
    for (const Run& run : runs_.runs) {
        longest = std::max(longest, run.length);
    }
    while ((2 << levels_) <= longest)
        ++levels_;
    ++levels_;
    shift_ = (1 << (levels_ - 1)) - 1;
    for (int axis = 0; axis < 3; ++axis) {
        origin_[axis] = -(solid.extent()[axis] - 1) - padding;
        extent_[axis] = grid_[axis] + solid.extent()[axis] - 1 + 2 * padding;
    }
    for (int level = 0; level < levels_; ++level) {
        BitGrid table({grid_.x + shift_, grid_.y, grid_.z});
        if (level == 0) {
            unite(table, omega, {shift_, 0, 0});
        } else {
            const BitGrid& half = dilated_.back();
            table = half;
            unite(table, half, {-(1 << (level - 1)), 0, 0});
        }
        dilated_.push_back(std::move(table));
    }
}

void FreeRows::words(int y, int z, int first, int count, std::uint64_t* free) const {
    std::fill_n(free, count, Word{0});
    for (const Run& run : runs_.runs) {
        const int at_y = y + origin_.y + run.start.y, at_z = z + origin_.z + run.start.z;
        if (at_y < 0 || at_y >= grid_.y || at_z < 0 || at_z >= grid_.z) continue;
        int level = 0;
        while ((2 << level) <= run.length)
            ++level;
        const BitGrid& table = dilated_[static_cast<std::size_t>(level)];
        const Word* in = table.row(at_y, at_z);
        const int begin = 64 * first + origin_.x + run.start.x + shift_;
        or_shifted(free, count, in, table.words_per_row(), begin);
        const int end = begin + run.length - (1 << level);
        if (end != begin) or_shifted(free, count, in, table.words_per_row(), end);
    }
    for (int i = 0; i < count; ++i) {
        free[i] = ~free[i];
    }
    const bool last = first + count == (extent_.x + 63) / 64;
    if (last && extent_.x % 64 != 0) free[count - 1] &= (Word{1} << (extent_.x % 64)) - 1;
}

}  // namespace spectralpack
