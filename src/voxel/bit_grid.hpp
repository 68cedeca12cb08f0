#pragma once
/// A set of voxels, one bit each. A row is the voxels of one (y, z) along x, in whole 64-bit words:
/// voxel x is bit x % 64 of word x / 64. Invariant: bits at and beyond extent.x are zero.

#include <cstdint>
#include <vector>

#include "spectralpack/grid.hpp"

namespace spectralpack {

class BitGrid {
  public:
    using Word = std::uint64_t;
    static constexpr int kWordBits = 64;

    BitGrid() = default;
    explicit BitGrid(const Extent& extent);

    const Extent& extent() const { return extent_; }
    int words_per_row() const { return words_per_row_; }
    std::int64_t bytes() const { return static_cast<std::int64_t>(words_.size() * sizeof(Word)); }

    bool get(int x, int y, int z) const { return (row(y, z)[x / kWordBits] >> (x % kWordBits)) & 1; }
    void set(int x, int y, int z, bool value = true) {
        const Word mask = Word{1} << (x % kWordBits);
        Word& word = row(y, z)[x / kWordBits];
        word = value ? word | mask : word & ~mask;
    }

    Word* row(int y, int z) { return words_.data() + row_offset(y, z); }
    const Word* row(int y, int z) const { return words_.data() + row_offset(y, z); }

    std::vector<Word>& words() { return words_; }
    const std::vector<Word>& words() const { return words_; }

    void fill(bool value);
    std::int64_t count() const;
    bool none() const;
    bool operator==(const BitGrid&) const = default;

  private:
    std::size_t row_offset(int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(extent_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(words_per_row_);
    }

    Extent extent_;
    int words_per_row_ = 0;
    std::vector<Word> words_;
};

/// target |= source with source's voxel 0 at `at`; voxels that fall outside the target are dropped.
void unite(BitGrid& target, const BitGrid& source, const VoxelIndex& at);

/// target &= ~source, likewise.
void subtract(BitGrid& target, const BitGrid& source, const VoxelIndex& at);

/// True when some voxel of `source` placed at `at` meets a voxel of `target`; what falls outside
/// meets nothing.
bool intersects(const BitGrid& target, const BitGrid& source, const VoxelIndex& at);

}  // namespace spectralpack
