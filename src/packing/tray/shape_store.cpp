#include "packing/tray/shape_store.hpp"

#include <algorithm>
#include <utility>

#include "core/stopped.hpp"
#include "core/stopwatch.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kOrientationsAhead = 768;  // made at a time

std::int64_t bytes_of(const Shape& shape) {
    std::int64_t bytes = 0;
    for (const OrientedShape& oriented : shape.orientations) {
        bytes += oriented.solid.bytes();
        if (oriented.fine != oriented.solid) bytes += oriented.fine.bytes();
        for (std::size_t c = 0; c < oriented.widened.size(); ++c) {
            const LazyGrid& wide = oriented.widened[c].voxels;
            if (wide != (c == 0 ? oriented.fine : oriented.widened[c - 1].voxels)) bytes += wide.bytes();
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
    : make_(std::move(make)),
      workers_(workers),
      keep_(keep),
      most_ahead_(static_cast<std::size_t>(ahead)),
      ahead_(most_ahead_) {}

void ShapeStore::start_tray(const std::vector<Copy>& copies, int ahead) {
    copies_ = copies;
    ahead_ = std::min(most_ahead_, static_cast<std::size_t>(ahead));
    next_ = 0;
    std::size_t parts = shapes_.size();
    for (const Copy& copy : copies_) {
        parts = std::max(parts, static_cast<std::size_t>(copy.part) + 1);
    }
    shapes_.resize(parts);
    making_.resize(parts);
    kept_.resize(parts, 0);
    remaining_.assign(parts, 0);
    left_over_.assign(parts, false);
    for (const Copy& copy : copies_) {
        ++remaining_[static_cast<std::size_t>(copy.part)];
    }
    for (std::size_t part = 0; part < parts; ++part) {
        if (remaining_[part] == 0) drop(part);
    }
}

void ShapeStore::stop_with(const StopToken& stop) {
    workers_ = workers_.stopping_with(stop);
    alone_ = alone_.stopping_with(stop);
}

const Shape& ShapeStore::at(std::size_t i) {
    const auto part = static_cast<std::size_t>(copies_[i].part);
    const std::unique_ptr<Making> making = std::move(making_[part]);
    if (making) --begun_;
    begin_next(part);
    if (!shapes_[part]) {
        const Stopwatch watch;
        try {
            if (making) shapes_[part] = making->take().value_or(nullptr);
        } catch (const Stopped&) {
            workers_.check();  // it may have been begun for work that was given up since
        }
        if (!shapes_[part]) shapes_[part] = make_(copies_[i].part, workers_);
        seconds_ += watch.seconds();
    }
    return *shapes_[part];
}

/// Begins the parts that come next, as many as may be held besides `now`.
void ShapeStore::begin_next(std::size_t now) {
    for (; next_ < copies_.size() && begun_ + 1 < ahead_; ++next_) {
        const int id = copies_[next_].part;
        const auto part = static_cast<std::size_t>(id);
        if (part == now || shapes_[part] || making_[part] || remaining_[part] == 0) continue;
        making_[part] = std::make_unique<Making>(workers_, [this, id] { return make_(id, alone_); });
        ++begun_;
    }
}

void ShapeStore::release(std::size_t i, bool placed) {
    const auto part = static_cast<std::size_t>(copies_[i].part);
    if (!placed) left_over_[part] = true;
    if (--remaining_[part] > 0) return;
    if (!left_over_[part] || making_[part]) {  // what nobody asked for is not kept
        drop(part);
    } else if (shapes_[part] && kept_[part] == 0) {
        const std::int64_t bytes = bytes_of(*shapes_[part]);
        if (bytes > keep_) return drop(part);
        keep_ -= bytes;
        kept_[part] = bytes;
    }
}

void ShapeStore::drop(std::size_t part) {
    if (making_[part]) --begun_;
    making_[part].reset();
    shapes_[part].reset();
    keep_ += kept_[part];
    kept_[part] = 0;
}

}  // namespace spectralpack
