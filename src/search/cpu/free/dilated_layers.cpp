#include "search/cpu/free/dilated_layers.hpp"

#include <algorithm>

#include "search/cpu/tables/kernels.hpp"

namespace spectralpack {

VoxelBox DilatedRows::read_for(const VoxelBox& changed, const Extent& extent) {
    VoxelBox box = changed;
    box.lo.x = 64 * std::max(0, first_word(changed.lo.x) - 1);
    box.hi.x = std::min(extent.x, 64 * (last_word(changed.hi.x) + 1));
    return box;
}

void DilatedRows::make(const VoxelBox& changed, const BitGrid& voxels, const VoxelIndex& corner) const {
    const int first = first_word(changed.lo.x), last = last_word(changed.hi.x);
    // Table 0: the voxels, moved up.
    static_assert(kShift < 64);
    for (int y = changed.lo.y; y < changed.hi.y; ++y) {
        const Word* row = voxels.row(y - corner.y, changed.lo.z - corner.z);
        const auto word = [&](int w) {
            const int i = w - corner.x / 64;
            return 0 <= i && i < voxels.words_per_row() ? row[i] : 0;
        };
        for (int w = first; w <= last; ++w) {
            words[w * stride + y] = word(w) << kShift | word(w - 1) >> (64 - kShift);
        }
    }
    const auto rows = static_cast<std::size_t>(std::max(0, changed.hi.y - changed.lo.y));
    for (int level = 1; level < kLevels; ++level) {
        const int by = 1 << (level - 1);
        for (int w = first; w <= last; ++w) {
            const Word* half = words + (level - 1) * table + w * stride + changed.lo.y;
            Word* whole = words + level * table + w * stride + changed.lo.y;
            kernels().or_moved_down(whole, half, half, half + stride, by, rows);
        }
    }
}

DilatedLayers::DilatedLayers(const Tray& tray)
    : extent_(tray.extent()),
      tray_life_(tray.life()),
      instance_(tray.instance()),
      version_(tray.version()),
      words_(words_for(extent_)),
      layers_(static_cast<std::size_t>(extent_.z)) {
    for (int z = 0; z < extent_.z; ++z) {
        layers_[static_cast<std::size_t>(z)].changed = layer_of(whole(extent_), z);
    }
}

void DilatedLayers::follow(const Tray& tray) {
    for (; version_ < tray.version(); ++version_) {
        const TrayObject& object = tray.object(tray.changes()[version_].id);
        const VoxelBox box = intersection(object.box(), whole(extent_));
        if (box.empty()) continue;
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            Layer& layer = layers_[static_cast<std::size_t>(z)];
            layer.current = false;
            layer.changed = hull(layer.changed, layer_of(box, z));
        }
    }
}

const DilatedRows& DilatedLayers::layer(const Tray& tray, int z) {
    Layer& layer = layers_[static_cast<std::size_t>(z)];
    if (layer.current.load(std::memory_order_acquire)) return layer.rows;
    const std::lock_guard lock(making_);
    if (layer.current.load(std::memory_order_relaxed)) return layer.rows;
    bring_up(layer, tray);
    layer.changed = {};
    layer.current.store(true, std::memory_order_release);
    return layer.rows;
}

void DilatedLayers::bring_up(Layer& layer, const Tray& tray) {
    const VoxelBox box = DilatedRows::read_for(layer.changed, extent_);
    const BitGrid voxels = tray.omega_move(box, std::nullopt);
    DilatedRows& rows = layer.rows;
    if (!layer.words) {
        if (voxels.none()) return;
        layer.words = std::make_unique<Word[]>(layer_words(extent_));
        ++made_;
        rows.lie_in(layer.words.get(), -1, columns_for(extent_), -kBeside, rows_for(extent_));
    }
    rows.make(layer.changed, voxels, box.lo);
    rows.begin = std::min(rows.begin, layer.changed.lo.y);
    rows.end = std::max(rows.end, layer.changed.hi.y);
    const auto empty = [&](int y) {
        for (int w = 0; w < words_; ++w) {
            if (rows.words[w * rows.stride + y] != 0) return false;
        }
        return true;
    };
    while (rows.begin < rows.end && empty(rows.begin)) {
        ++rows.begin;
    }
    while (rows.begin < rows.end && empty(rows.end - 1)) {
        --rows.end;
    }
}

std::int64_t DilatedLayers::bytes() const {
    return static_cast<std::int64_t>(layers_.size() * sizeof(Layer)) +
           made_.load() * static_cast<std::int64_t>(layer_words(extent_) * sizeof(Word));
}

std::int64_t DilatedLayers::most_bytes(const Extent& extent) {
    const std::size_t layer = sizeof(Layer) + layer_words(extent) * sizeof(Word);
    return static_cast<std::int64_t>(extent.z) * static_cast<std::int64_t>(layer);
}

}  // namespace spectralpack
