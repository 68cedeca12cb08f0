#include "search/cpu/dilated_layers.hpp"

#include <algorithm>

namespace spectralpack {

DilatedLayers::DilatedLayers(const Tray& tray)
    : extent_(tray.extent()),
      instance_(tray.instance()),
      version_(tray.version()),
      words_(words_for(extent_)),
      layers_(static_cast<std::size_t>(extent_.z)) {}

void DilatedLayers::follow(const Tray& tray) {
    for (; version_ < tray.version(); ++version_) {
        const TrayObject& object = tray.object(tray.journal()[version_].id);
        const VoxelBox box = intersection(object.box(), whole(extent_));
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            layers_[static_cast<std::size_t>(z)].current = false;
        }
    }
}

std::size_t DilatedLayers::table_words(int words, int rows) {
    // Up to kTogether - 1 rows before and after those that hold something are read with them.
    const int padded = rows + 2 * (DilatedRows::kTogether - 1);
    return static_cast<std::size_t>(DilatedRows::kLevels) * static_cast<std::size_t>(words + 2) *
           static_cast<std::size_t>(padded);
}

std::size_t DilatedLayers::table_words(int rows) const { return table_words(words_, rows); }

DilatedRows DilatedLayers::dilate(const BitGrid& voxels, int z, int first_row, Word* words) const {
    const int rows = voxels.extent().y;
    DilatedRows result;
    result.stride = rows + 2 * (DilatedRows::kTogether - 1);
    result.first = words + DilatedRows::kTogether - 1 - first_row;
    result.begin = first_row + rows;
    result.end = first_row;
    // Table 0: the voxels, moved up by 63 bits, which is a word less one bit.
    static_assert(DilatedRows::kShift == 63);
    const auto stride = static_cast<std::size_t>(result.stride);
    Word* table = words + stride + DilatedRows::kTogether - 1;  // word 0 of row 0
    for (int y = 0; y < rows; ++y) {
        const Word* row = voxels.row(y, z);
        Word any = 0;
        for (int i = 0; i < voxels.words_per_row(); ++i) {
            Word* to = table + static_cast<std::size_t>(i) * stride + y;
            any |= row[i];
            to[0] |= row[i] << 63;
            if (i + 1 < words_) to[stride] |= row[i] >> 1;
        }
        if (any == 0) continue;
        result.begin = std::min(result.begin, first_row + y);
        result.end = first_row + y + 1;
    }
    const std::size_t table_size = static_cast<std::size_t>(columns()) * stride;
    for (int level = 1; level < DilatedRows::kLevels; ++level) {
        const int by = 1 << (level - 1);
        const Word* half = table;
        table += table_size;
        // Padding goes through it as well and stays zero.
        for (std::size_t i = 0; i < static_cast<std::size_t>(words_) * stride; ++i) {
            table[i] = half[i] | half[i] >> by | half[i + stride] << (64 - by);
        }
    }
    return result;
}

const DilatedRows& DilatedLayers::layer(const Tray& tray, int z) {
    Layer& layer = layers_[static_cast<std::size_t>(z)];
    if (layer.current.load(std::memory_order_acquire)) return layer.rows;
    const std::lock_guard lock(making_);
    if (layer.current.load(std::memory_order_relaxed)) return layer.rows;
    const BitGrid voxels = tray.omega_move({{0, 0, z}, {extent_.x, extent_.y, z + 1}}, std::nullopt);
    if (voxels.none()) {
        layer.rows = {};
    } else {
        const std::size_t count = table_words(extent_.y);
        if (!layer.words) {
            layer.words = std::make_unique<Word[]>(count);
            ++made_;
        } else {
            std::fill_n(layer.words.get(), count, Word{0});
        }
        layer.rows = dilate(voxels, 0, 0, layer.words.get());
    }
    layer.current.store(true, std::memory_order_release);
    return layer.rows;
}

std::int64_t DilatedLayers::bytes() const {
    return static_cast<std::int64_t>(layers_.size() * sizeof(Layer)) +
           made_.load() * static_cast<std::int64_t>(table_words(extent_.y) * sizeof(Word));
}

std::int64_t DilatedLayers::most_bytes(const Extent& extent) {
    const std::size_t layer = sizeof(Layer) + table_words(words_for(extent), extent.y) * sizeof(Word);
    return static_cast<std::int64_t>(extent.z) * static_cast<std::int64_t>(layer);
}

}  // namespace spectralpack
