#pragma once
/// Omega_move dilated along x, a row at a time and only where someone looks (paper, sections 4.1 and 4.3): a walk that
/// stays near its start touches few rows, and a copy that leaves or comes changes few.

#include <atomic>
#include <cstdint>
#include <vector>

#include "search/tray.hpp"

namespace spectralpack {

class DilatedRows {
  public:
    using Word = BitGrid::Word;
    static constexpr int kLevels = 7;                     ///< tables of a row: for 1, 2, 4 .. 64 voxels
    static constexpr int kShift = (1 << (kLevels - 1)) - 1;

    explicit DilatedRows(const Tray& tray);
    ~DilatedRows();
    DilatedRows(const DilatedRows&) = delete;
    DilatedRows& operator=(const DilatedRows&) = delete;

    /// Brings the rows up to `tray`, which is the same one as ever. Nobody may be reading.
    void follow(const Tray& tray);

    const Extent& extent() const { return extent_; }
    std::uint64_t instance() const { return instance_; }
    /// Words of a row's tables, one after the other, each with a word of zeros before and after it.
    std::size_t row_words() const { return row_words(words_); }
    int words() const { return words_; }  ///< of one table, without those

    /// Bit X + kShift of table k, from its second word on: something in voxels X .. X + 2^k - 1 of the row. `tray` as it
    /// was followed last. Several threads may ask at once. O(words of the row) when first asked for.
    const Word* row(const Tray& tray, int y, int z);
    /// What row() gives for every row with nothing in it: zeros.
    const Word* empty_row() const { return empty_.data(); }

    /// Fills the tables of a row with these voxels; `tables` are zero before.
    void dilate(const Word* voxels, Word* tables) const;

    std::int64_t bytes() const;
    /// Of all rows of such a grid: what bytes() comes to at most.
    static std::int64_t most_bytes(const Extent& extent);

  private:
    void drop(int y, int z);
    static std::size_t row_words(int words) { return static_cast<std::size_t>(kLevels) * static_cast<std::size_t>(words + 2); }
    static int words_for(const Extent& extent) { return (extent.x + kShift + 63) / 64; }

    Extent extent_;
    std::uint64_t instance_;
    std::uint64_t version_;
    int words_;
    std::vector<Word> empty_;
    // By z * ny + y; owned, but for empty_; null: not asked for since it changed.
    std::vector<std::atomic<const Word*>> rows_;
    std::atomic<std::int64_t> made_{0};     // rows
};

}  // namespace spectralpack
