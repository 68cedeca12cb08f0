#pragma once
/// Omega_move dilated along x, a layer at a time and only where someone looks (paper, sections 4.1 and 4.3): a walk
/// that stays near its start touches few layers, and a copy that leaves or comes changes few.

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "search/tray.hpp"

namespace spectralpack {

/// The tables of one layer, or of some neighbouring rows of it: for 1, 2, 4 .. 64 voxels along x. Words of 64 voxels
/// lie in the order row, word along x, table, rows fastest, so that neighbouring rows are loaded together.
struct DilatedRows {
    using Word = BitGrid::Word;
    static constexpr int kLevels = 7;
    static constexpr int kShift = (1 << (kLevels - 1)) - 1;
    static constexpr int kTogether = 8;  ///< rows that are read at once

    /// Something is in rows begin .. end - 1 at most.
    int begin = std::numeric_limits<int>::max(), end = 0;
    /// Row `row` and the seven after it, of word w (-1 .. words() - 1, or one more: zeros) of table `level`, are at
    /// first[(level * columns + w + 1) * stride + row], for any of them that meet rows begin .. end - 1.
    const Word* first = nullptr;
    std::int64_t stride = 0;
};

class DilatedLayers {
  public:
    using Word = DilatedRows::Word;

    /// Trays whose layers an engine keeps: while copies are put back, there are two that grow side by side.
    static constexpr int kTrays = 2;

    explicit DilatedLayers(const Tray& tray);

    /// Brings the layers up to `tray`, which is the same one as ever. Nobody may be reading.
    void follow(const Tray& tray);

    const Extent& extent() const { return extent_; }
    std::uint64_t instance() const { return instance_; }
    std::uint64_t version() const { return version_; }  ///< of the tray that they are of
    int words() const { return words_; }                ///< of a row's table: bits 0 .. extent.x + kShift - 1
    int columns() const { return words_ + 2; }          ///< with a zero before and after them

    /// Bit X + kShift of table k: something in voxels X .. X + 2^k - 1 of the row. `tray` as it was followed last.
    /// Several threads may ask at once. O(words of the layer) when first asked for.
    const DilatedRows& layer(const Tray& tray, int z);

    /// Words that the tables of so many rows take.
    std::size_t table_words(int rows) const;
    /// The tables of layer z of `voxels`, whose rows are those from first_row on; in `words`, table_words() zeros
    /// before.
    DilatedRows dilate(const BitGrid& voxels, int z, int first_row, Word* words) const;

    std::int64_t bytes() const;
    /// Of all layers of such a grid: what bytes() comes to at most.
    static std::int64_t most_bytes(const Extent& extent);

  private:
    struct Layer {
        std::atomic<bool> current = false;
        DilatedRows rows;
        std::unique_ptr<Word[]> words;  // null: nothing in it so far
    };

    static int words_for(const Extent& extent) { return (extent.x + DilatedRows::kShift + 63) / 64; }
    static std::size_t table_words(int words, int rows);

    Extent extent_;
    std::uint64_t instance_;
    std::uint64_t version_;
    int words_;
    std::mutex making_;
    std::vector<Layer> layers_;           // by z
    std::atomic<std::int64_t> made_ = 0;  // that hold words
};

}  // namespace spectralpack
