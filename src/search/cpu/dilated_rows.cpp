#include "search/cpu/dilated_rows.hpp"

#include <algorithm>
#include <memory>

namespace spectralpack {

DilatedRows::DilatedRows(const Tray& tray)
    : extent_(tray.extent()),
      instance_(tray.instance()),
      version_(tray.version()),
      words_(words_for(extent_)),
      empty_(row_words(), 0),
      rows_(static_cast<std::size_t>(extent_.y) * static_cast<std::size_t>(extent_.z)) {}

DilatedRows::~DilatedRows() {
    for (const std::atomic<const Word*>& row : rows_) {
        if (row.load() != empty_row()) delete[] row.load();
    }
}

void DilatedRows::drop(int y, int z) {
    std::atomic<const Word*>& row =
        rows_[static_cast<std::size_t>(z) * static_cast<std::size_t>(extent_.y) + static_cast<std::size_t>(y)];
    const Word* gone = row.exchange(nullptr);
    if (gone == nullptr || gone == empty_row()) return;
    delete[] gone;
    --made_;
}

void DilatedRows::follow(const Tray& tray) {
    for (; version_ < tray.version(); ++version_) {
        const TrayObject& object = tray.object(tray.journal()[version_].id);
        const VoxelBox box = intersection(object.box(), whole(extent_));
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            for (int y = box.lo.y; y < box.hi.y; ++y) {
                drop(y, z);
            }
        }
    }
}

void DilatedRows::dilate(const Word* voxels, Word* tables) const {
    // Table 0: the voxels, moved up by 63 bits, which is a word less one bit.
    static_assert(kShift == 63);
    const int count = (extent_.x + 63) / 64;
    Word* table = tables + 1;
    for (int i = 0; i < count; ++i) {
        table[i] |= voxels[i] << 63;
        if (i + 1 < words_) table[i + 1] |= voxels[i] >> 1;
    }
    for (int level = 1; level < kLevels; ++level) {
        const Word* half = table;
        table += words_ + 2;
        const int by = 1 << (level - 1);
        for (int i = 0; i < words_; ++i) {
            table[i] = half[i] | half[i] >> by | half[i + 1] << (64 - by);
        }
    }
}

const DilatedRows::Word* DilatedRows::row(const Tray& tray, int y, int z) {
    std::atomic<const Word*>& wanted =
        rows_[static_cast<std::size_t>(z) * static_cast<std::size_t>(extent_.y) + static_cast<std::size_t>(y)];
    if (const Word* made = wanted.load(std::memory_order_acquire)) return made;
    const BitGrid voxels = tray.omega_move({{0, y, z}, {extent_.x, y + 1, z + 1}}, std::nullopt);
    const Word* expected = nullptr;
    const Word* first = voxels.row(0, 0);
    if (std::all_of(first, first + (extent_.x + 63) / 64, [](Word word) { return word == 0; })) {
        wanted.compare_exchange_strong(expected, empty_row(), std::memory_order_acq_rel);
        return empty_row();
    }
    auto tables = std::make_unique<Word[]>(row_words());
    dilate(first, tables.get());
    if (!wanted.compare_exchange_strong(expected, tables.get(), std::memory_order_acq_rel)) return expected;
    ++made_;
    return tables.release();
}

std::int64_t DilatedRows::bytes() const {
    return static_cast<std::int64_t>(rows_.size() * sizeof(void*)) +
           made_.load() * static_cast<std::int64_t>(row_words() * sizeof(Word));
}

std::int64_t DilatedRows::most_bytes(const Extent& extent) {
    const auto rows = static_cast<std::int64_t>(extent.y) * extent.z;
    return rows * static_cast<std::int64_t>(sizeof(void*) + row_words(words_for(extent)) * sizeof(Word));
}

}  // namespace spectralpack
