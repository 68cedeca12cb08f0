#include "packing/shape_store.hpp"

#include <algorithm>
#include <utility>

#include "core/stopwatch.hpp"

namespace spectralpack {
namespace {

// Orientations made at a time: those of kAhead parts that may be turned by right angles.
constexpr std::size_t kOrientationsAhead = 24 * ShapeStore::kAhead;

std::int64_t bytes_of(const Shape& shape) {
    std::int64_t bytes = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        bytes += oriented.solid->bytes();
        if (oriented.fine && oriented.fine != oriented.solid) bytes += oriented.fine->bytes();
        for (std::size_t c = 0; c < oriented.widened.size(); ++c) {
            if (c == 0 || oriented.widened[c] != oriented.widened[c - 1]) bytes += oriented.widened[c]->voxels.bytes();
        }
    }
    return bytes;
}

}  // namespace

int ShapeStore::ahead(std::size_t orientations) {
    return static_cast<int>(
        std::clamp<std::size_t>(kOrientationsAhead / std::max<std::size_t>(1, orientations), 1, kAhead));
}

ShapeStore::ShapeStore(Make make, const Workers& workers, std::int64_t keep, int ahead)
    : make_(std::move(make)), workers_(workers), keep_(keep), ahead_(static_cast<std::size_t>(ahead)) {}

void ShapeStore::start_tray(const std::vector<PackItem>& items) {
    items_ = items;
    std::size_t parts = shapes_.size();
    for (const PackItem& item : items_) {
        parts = std::max(parts, static_cast<std::size_t>(item.part) + 1);
    }
    shapes_.resize(parts);
    remaining_.assign(parts, 0);
    left_over_.assign(parts, false);
    for (const PackItem& item : items_) {
        ++remaining_[static_cast<std::size_t>(item.part)];
    }
    kept_.resize(parts, 0);
    for (std::size_t part = 0; part < parts; ++part) {
        if (remaining_[part] == 0) drop(part);
    }
}

const Shape& ShapeStore::at(std::size_t i) {
    auto& wanted = shapes_[static_cast<std::size_t>(items_[i].part)];
    if (!wanted) {
        const Stopwatch watch;
        std::vector<int> batch;
        std::vector<bool> listed(shapes_.size(), false);
        for (std::size_t j = i; j < items_.size() && batch.size() < ahead_; ++j) {
            const auto part = static_cast<std::size_t>(items_[j].part);
            if (!listed[part] && !shapes_[part] && remaining_[part] > 0) {
                listed[part] = true;
                batch.push_back(items_[j].part);
            }
        }
        workers_.for_each(static_cast<std::int64_t>(batch.size()), [&](std::int64_t k) {
            const int part = batch[static_cast<std::size_t>(k)];
            shapes_[static_cast<std::size_t>(part)] = make_(part);
        });
        seconds_ += watch.seconds();
    }
    return *wanted;
}

void ShapeStore::release(std::size_t i, bool placed) {
    const auto part = static_cast<std::size_t>(items_[i].part);
    if (!placed) left_over_[part] = true;
    if (--remaining_[part] > 0) return;
    if (!left_over_[part]) {
        drop(part);
    } else if (shapes_[part] && kept_[part] == 0) {
        const std::int64_t bytes = bytes_of(*shapes_[part]);
        if (bytes > keep_) return drop(part);
        keep_ -= bytes;
        kept_[part] = bytes;
    }
}

void ShapeStore::drop(std::size_t part) {
    shapes_[part].reset();
    keep_ += kept_[part];
    kept_[part] = 0;
}

}  // namespace spectralpack
