#include "search/cpu/position_cache.hpp"

#include <algorithm>
#include <utility>

namespace spectralpack {
namespace {

constexpr std::size_t kSpareStates = 64;

Extent brick_count(const Extent& count) {
    return {(count.x + kBrickX - 1) / kBrickX, (count.y + kBrickY - 1) / kBrickY,
            (count.z + kBrickZ - 1) / kBrickZ};
}

}  // namespace

void PositionState::reset(const Extent& count) {
    count_ = count;
    bricks_ = brick_count(count);
    bound_rows_ = bricks_.y * kBlocksY;
    bound_stride_ = bricks_.x * kBlocksX + kBlocksX;  // bricks are looked at in pairs
    const auto bricks = static_cast<std::size_t>(bricks_.count());
    live_.resize(bricks * kBrickY * kBrickZ);
    bound_.resize(static_cast<std::size_t>(bricks_.z) * static_cast<std::size_t>(bound_rows_) *
                  static_cast<std::size_t>(bound_stride_));
    sifted_.resize(bricks);
    open_.assign(static_cast<std::size_t>(bricks_.z), 0);
}

void PositionState::open(int bz) {
    if (open_[static_cast<std::size_t>(bz)]) return;
    open_[static_cast<std::size_t>(bz)] = 1;
    std::fill_n(bound(0, 0, bz), bound_rows_ * bound_stride_, kDead);
    for (int row = 0; row < bound_rows_; ++row) {
        std::fill_n(bound(0, row, bz), (count_.x + TrayTables::kBlock - 1) / TrayTables::kBlock,
                    0u);
    }
    for (int by = 0; by < bricks_.y; ++by) {
        for (int bx = 0; bx < bricks_.x; ++bx) {
            sifted_[brick(bx, by, bz)] = 0;
            const int columns = std::min(kBrickX, count_.x - kBrickX * bx);
            const std::uint64_t row = ~std::uint64_t{0} >> (kBrickX - columns);
            const int rows = count_.y - kBrickY * by;
            const int layers = count_.z - kBrickZ * bz;
            std::uint64_t* words = live(bx, by, bz);
            for (int i = 0; i < kBrickY * kBrickZ; ++i) {
                words[i] = i % kBrickY < rows && i / kBrickY < layers ? row : 0;
            }
        }
    }
}

void PositionState::forget(const VoxelBox& changed, const Extent& extent) {
    // Position q meets the box where q < hi and q + extent > lo.
    const VoxelBox touched = intersection(
        {changed.lo - VoxelIndex{extent.x - 1, extent.y - 1, extent.z - 1}, changed.hi},
        whole(count_));
    if (touched.empty()) return;
    constexpr int kBlock = TrayTables::kBlock;
    for (int z = touched.lo.z / kBlock; z <= (touched.hi.z - 1) / kBlock; ++z) {
        if (!open_[static_cast<std::size_t>(z)]) continue;
        for (int y = touched.lo.y / kBlock; y <= (touched.hi.y - 1) / kBlock; ++y) {
            std::uint32_t* row = bound(0, y, z);
            for (int x = touched.lo.x / kBlock; x <= (touched.hi.x - 1) / kBlock; ++x) {
                if (row[x] != kDead) row[x] = 0;
            }
        }
    }
}

std::int64_t PositionState::bytes() const {
    return static_cast<std::int64_t>(live_.capacity() * 8 + bound_.capacity() * 4 +
                                     sifted_.capacity() + open_.capacity());
}

std::int64_t PositionState::bytes_for(const Extent& count) {
    const Extent bricks = brick_count(count);
    return bricks.count() * (kBrickY * kBrickZ * 8 + kBlocksX * kBlocksY * 4 + 1) + bricks.z;
}

void PositionCache::make_room(std::int64_t bytes) {
    while (bytes_ + bytes > budget_ && !entries_.empty()) {
        const auto less_useful = [](const auto& a, const auto& b) {
            const double worth_a =
                static_cast<double>(a.second.hits) / static_cast<double>(a.second.bytes + 1);
            const double worth_b =
                static_cast<double>(b.second.hits) / static_cast<double>(b.second.bytes + 1);
            return worth_a != worth_b ? worth_a < worth_b : a.second.last_use < b.second.last_use;
        };
        const auto gone = std::min_element(entries_.begin(), entries_.end(), less_useful);
        bytes_ -= gone->second.bytes;
        for (PositionState& state : gone->second.states) {
            if (spare_.size() < kSpareStates) spare_.push_back(std::move(state));
        }
        entries_.erase(gone);
    }
}

/// Also what takes no room: that nothing fitted the last tray says nothing of the next.
void PositionCache::forget_all() {
    for (auto& [id, entry] : entries_) {
        for (PositionState& state : entry.states) {
            if (spare_.size() < kSpareStates) spare_.push_back(std::move(state));
        }
    }
    entries_.clear();
    bytes_ = 0;
}

PositionCache::Entry& PositionCache::at(const Shape& shape, const Tray& tray,
                                        const TrayTables& tables) {
    if (tables.epoch() != epoch_) {
        epoch_ = tables.epoch();
        forget_all();
    }
    ++uses_;
    auto found = entries_.find(shape.id);
    if (found != entries_.end()) {
        Entry& entry = found->second;
        ++entry.hits;
        entry.last_use = uses_;
        const VoxelBox changed = tables.changed_since(entry.version);
        if (!changed.empty()) {
            for (std::size_t i = 0; i < entry.states.size(); ++i) {
                entry.states[i].forget(changed, shape.orientations[i].solid->extent());
            }
        }
        entry.version = tables.version();
        return entry;
    }
    Entry fresh;
    std::vector<Extent> counts;
    for (const OrientedShape& oriented : shape.orientations) {
        counts.push_back(tray.candidates(oriented.size));
        fresh.bytes += counts.back().empty() ? 0 : PositionState::bytes_for(counts.back());
    }
    make_room(fresh.bytes);
    for (const Extent& count : counts) {
        PositionState state;
        if (!count.empty() && !spare_.empty()) {
            state = std::move(spare_.back());
            spare_.pop_back();
        }
        state.reset(count);
        fresh.states.push_back(std::move(state));
    }
    fresh.runs.resize(fresh.states.size());
    fresh.version = tables.version();
    fresh.last_use = uses_;
    bytes_ += fresh.bytes;
    return entries_[shape.id] = std::move(fresh);
}

}  // namespace spectralpack
