#include "packing/shape_store.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace spectralpack {

ShapeStore::ShapeStore(const std::vector<PackItem>& items, Make make, const Workers& workers,
                       Timed timed)
    : items_(items), make_(std::move(make)), workers_(workers), timed_(std::move(timed)) {
    int parts = 0;
    for (const PackItem& item : items_) {
        parts = std::max(parts, item.part + 1);
    }
    shapes_.resize(static_cast<std::size_t>(parts));
    remaining_.resize(static_cast<std::size_t>(parts), 0);
    for (const PackItem& item : items_) {
        ++remaining_[static_cast<std::size_t>(item.part)];
    }
}

const Shape& ShapeStore::at(std::size_t i) {
    auto& wanted = shapes_[static_cast<std::size_t>(items_[i].part)];
    if (!wanted) {
        const auto start = std::chrono::steady_clock::now();
        std::vector<int> batch;
        std::vector<bool> listed(shapes_.size(), false);
        for (std::size_t j = i; j < items_.size() && batch.size() < kAhead; ++j) {
            const auto part = static_cast<std::size_t>(items_[j].part);
            if (!listed[part] && !shapes_[part]) {
                listed[part] = true;
                batch.push_back(items_[j].part);
            }
        }
        workers_.for_each(static_cast<std::int64_t>(batch.size()), [&](std::int64_t k) {
            const int part = batch[static_cast<std::size_t>(k)];
            shapes_[static_cast<std::size_t>(part)] = make_(part);
        });
        timed_(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return *wanted;
}

void ShapeStore::release(std::size_t i) {
    const auto part = static_cast<std::size_t>(items_[i].part);
    if (--remaining_[part] == 0) shapes_[part].reset();
}

}  // namespace spectralpack
