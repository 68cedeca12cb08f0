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
#include "voxel/voxel_box.hpp"

namespace spectralpack {

/// The tables of one layer, or of a part of it: for 1, 2, 4 .. 2^(kLevels - 1) voxels along x. Words of 64 voxels lie
/// in the order row, word along x, table, rows fastest, so that neighbouring rows are loaded together.
struct DilatedRows {
    using Word = BitGrid::Word;
    static constexpr int kLevels = 5;
    static constexpr int kShift = (1 << (kLevels - 1)) - 1;
    static constexpr int kTogether = 8;  ///< rows that are read at once

    /// Something is in rows begin .. end - 1 at most.
    int begin = std::numeric_limits<int>::max(), end = 0;
    /// Row `row` and the seven after it, of word w (-1 .. words() - 1, or one more: zeros) of table `level`, are at
    /// words[level * table + w * stride + row], for any of them that meet rows begin .. end - 1.
    Word* words = nullptr;
    std::int64_t table = 0, stride = 0;

    /// Words of tables with so many columns, a word wide, and rows.
    static std::size_t words_in(int columns, int rows) {
        return static_cast<std::size_t>(kLevels) * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    /// They lie from `block` on, of words `first_word` .. and rows `first_row` ..
    void lie_in(Word* block, int first_word, int columns, int first_row, int rows) {
        stride = rows;
        table = columns * stride;
        words = block - first_word * stride - first_row;
    }

    /// Of the words that voxels from x = lo on, or up to hi - 1, set bits in: the first, the last.
    static int first_word(int lo) { return lo / 64; }
    static int last_word(int hi) { return (hi - 1 + kShift) / 64; }
    /// The voxels that make() asks for where a layer, or many, of such an extent changed in a box.
    static VoxelBox read_for(const VoxelBox& changed, const Extent& extent);

    /// Makes the tables anew for one layer of voxels that may have come or gone in the box `changed`, from `voxels`,
    /// which hold those of read_for() from `corner` on. What lies beside the words that these set bits in is right.
    void make(const VoxelBox& changed, const BitGrid& voxels, const VoxelIndex& corner) const;
};

class DilatedLayers {
  public:
    using Word = DilatedRows::Word;

    explicit DilatedLayers(const Tray& tray);

    /// Brings the layers up to `tray`, which is the same one as ever. Nobody may be reading.
    void follow(const Tray& tray);

    const Extent& extent() const { return extent_; }
    bool tray_is_gone() const { return tray_life_.expired(); }
    std::uint64_t instance() const { return instance_; }
    std::uint64_t version() const { return version_; }  ///< of the tray that they are of
    int words() const { return words_; }                ///< of a row's table: bits 0 .. extent.x + kShift - 1

    /// Bit X + kShift of table k: something in voxels X .. X + 2^k - 1 of the row. `tray` as it was followed last.
    /// Several threads may ask at once. O(words of the layer) when first asked for; then of what has changed.
    const DilatedRows& layer(const Tray& tray, int z);

    std::int64_t bytes() const;
    /// Of all layers of such a grid: what bytes() comes to at most.
    static std::int64_t most_bytes(const Extent& extent);

  private:
    struct Layer {
        std::atomic<bool> current = false;
        VoxelBox changed;  // since it was current; before it was, all of it
        DilatedRows rows;
        std::unique_ptr<Word[]> words;  // null: nothing in it so far
    };

    static int words_for(const Extent& extent) { return DilatedRows::last_word(extent.x) + 1; }
    /// Rows of zeros that are read with those that hold something, before and after them.
    static constexpr int kBeside = DilatedRows::kTogether - 1;
    /// Of a layer's tables: with a column of zeros before the others, which is that after those of the table before,
    /// and rows of zeros, which likewise are those after the rows of the column before.
    static int columns_for(const Extent& extent) { return words_for(extent) + 1; }
    static int rows_for(const Extent& extent) { return extent.y + kBeside; }
    static std::size_t layer_words(const Extent& extent) {
        return DilatedRows::words_in(columns_for(extent), rows_for(extent)) + rows_for(extent) + kBeside;
    }
    void bring_up(Layer& layer, const Tray& tray);

    Extent extent_;
    std::weak_ptr<const void> tray_life_;
    std::uint64_t instance_;
    std::uint64_t version_;
    int words_;
    std::mutex making_;
    std::vector<Layer> layers_;           // by z
    std::atomic<std::int64_t> made_ = 0;  // that hold words
};

}  // namespace spectralpack
