#pragma once
/// Setting runs of voxels in rows of a BitGrid, also from several threads at once.

#include <atomic>

#include "voxel/bit_grid.hpp"
#include "voxel/triangle_rows.hpp"

namespace spectralpack {

/// Bits first..last of a word, 0 <= first <= last < 64.
inline BitGrid::Word bits_between(int first, int last) {
    return (~BitGrid::Word{0} >> (BitGrid::kWordBits - 1 - last)) & (~BitGrid::Word{0} << first);
}

/// Calls visit(word of the row, bits in it) for the words that voxels first..last touch.
template <class Word, class Visit>
void for_run_words(Word* row, int first, int last, Visit visit) {
    const int first_word = first / BitGrid::kWordBits, last_word = last / BitGrid::kWordBits;
    if (first_word == last_word) {  // nearly always
        visit(row[first_word], bits_between(first % BitGrid::kWordBits, last % BitGrid::kWordBits));
        return;
    }
    for (int word = first_word; word <= last_word; ++word) {
        visit(row[word], bits_between(word == first_word ? first % BitGrid::kWordBits : 0,
                                      word == last_word ? last % BitGrid::kWordBits : BitGrid::kWordBits - 1));
    }
}

inline BitGrid::Word get_shared(BitGrid::Word& word) {
    return std::atomic_ref<BitGrid::Word>(word).load(std::memory_order_relaxed);
}

/// word |= bits, atomically; most words have them already, and then nothing is written.
inline void set_shared(BitGrid::Word& word, BitGrid::Word bits) {
    if ((get_shared(word) & bits) == bits) return;
    std::atomic_ref<BitGrid::Word>(word).fetch_or(bits, std::memory_order_relaxed);
}

/// True when all voxels of the range are set in a grid whose voxel (0,0,0) is voxel `first`; the range lies within.
inline bool all_set(BitGrid& grid, const VoxelRange& range, const VoxelIndex& first) {
    BitGrid::Word missing = 0;
    for (int z = range.low.z; z <= range.high.z; ++z) {
        for (int y = range.low.y; y <= range.high.y; ++y) {
            for_run_words(grid.row(y - first.y, z - first.z), range.low.x - first.x, range.high.x - first.x,
                          [&](BitGrid::Word& word, BitGrid::Word bits) { missing |= bits & ~get_shared(word); });
        }
    }
    return missing == 0;
}

}  // namespace spectralpack
