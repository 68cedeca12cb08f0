#include "voxel/bit_grid.hpp"
#include "core/checked.hpp"

#include <algorithm>
#include <bit>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;
constexpr int kWordBits = BitGrid::kWordBits;

/// Calls visit(target word, source bits moved into that word) for every pair of words that can
/// meet, until it returns false. Shifting is exact for negative positions: bits that leave the row
/// are dropped.
template <class TargetWord, class Visit>
bool for_shifted_words(TargetWord* target, int target_words, const Word* source, int source_words, int shift,
                       const Visit& visit) {
    const int word_shift = shift >= 0 ? shift / kWordBits : -((-shift + kWordBits - 1) / kWordBits);
    const int bit_shift = shift - word_shift * kWordBits;
    for (int i = std::max(0, word_shift); i < std::min(target_words, word_shift + source_words + 1); ++i) {
        const int j = i - word_shift;
        Word bits = j < source_words ? source[j] << bit_shift : 0;
        if (bit_shift > 0 && j > 0) bits |= source[j - 1] >> (kWordBits - bit_shift);
        if (bits != 0 && !visit(target[i], bits)) return false;
    }
    return true;
}

template <class Target, class Visit>
bool for_overlap(Target& target, const BitGrid& source, const VoxelIndex& at, const Visit& visit) {
    const Extent& t = target.extent();
    const Extent& s = source.extent();
    for (int z = std::max(0, -at.z); z < std::min(s.z, t.z - at.z); ++z) {
        for (int y = std::max(0, -at.y); y < std::min(s.y, t.y - at.y); ++y) {
            if (!for_shifted_words(target.row(y + at.y, z + at.z), target.words_per_row(), source.row(y, z),
                                   source.words_per_row(), at.x, visit)) {
                return false;
            }
        }
    }
    return true;
}

/// The bits of a row's last word that are voxels.
Word last_word_mask(const Extent& extent) {
    const int used = extent.x % kWordBits;
    return used == 0 ? ~Word{0} : (Word{1} << used) - 1;
}

}  // namespace

BitGrid::BitGrid(const Extent& extent)
    : extent_(extent),
      words_per_row_((extent.x + kWordBits - 1) / kWordBits),
      words_(static_cast<std::size_t>(checked_product({words_per_row_, extent.y, extent.z})), 0) {}

void BitGrid::fill(bool value) {
    std::fill(words_.begin(), words_.end(), value ? ~Word{0} : Word{0});
    if (!value || words_per_row_ == 0) return;
    const Word mask = last_word_mask(extent_);
    for (std::size_t i = static_cast<std::size_t>(words_per_row_) - 1; i < words_.size();
         i += static_cast<std::size_t>(words_per_row_)) {
        words_[i] = mask;
    }
}

std::int64_t BitGrid::count() const {
    std::int64_t bits = 0;
    for (const Word word : words_) {
        bits += std::popcount(word);
    }
    return bits;
}

bool BitGrid::none() const {
    return std::all_of(words_.begin(), words_.end(), [](Word word) { return word == 0; });
}

void unite(BitGrid& target, const BitGrid& source, const VoxelIndex& at) {
    for_overlap(target, source, at, [](Word& word, Word bits) {
        word |= bits;
        return true;
    });
    // A source wider than what is left of the target's row may have spilled into its last word.
    if (at.x + source.extent().x > target.extent().x && target.words_per_row() > 0) {
        const Word mask = last_word_mask(target.extent());
        const Extent& s = source.extent();
        for (int z = std::max(0, at.z); z < std::min(target.extent().z, at.z + s.z); ++z) {
            for (int y = std::max(0, at.y); y < std::min(target.extent().y, at.y + s.y); ++y) {
                target.row(y, z)[target.words_per_row() - 1] &= mask;
            }
        }
    }
}

void subtract(BitGrid& target, const BitGrid& source, const VoxelIndex& at) {
    for_overlap(target, source, at, [](Word& word, Word bits) {
        word &= ~bits;
        return true;
    });
}

bool intersects(const BitGrid& target, const BitGrid& source, const VoxelIndex& at) {
    return !for_overlap(target, source, at, [](const Word& word, Word bits) { return (word & bits) == 0; });
}

}  // namespace spectralpack
