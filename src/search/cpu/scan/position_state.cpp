#include "search/cpu/scan/position_state.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/checked.hpp"
#include "search/cpu/tables/block_bits.hpp"
#include "search/cpu/tuning.hpp"

namespace spectralpack {
namespace {

Extent brick_count(const Extent& count) {
    return {(count.x + kBrickX - 1) / kBrickX, (count.y + kBrickY - 1) / kBrickY, (count.z + kBrickZ - 1) / kBrickZ};
}

int pairs_along_x(const Extent& bricks) { return (bricks.x + kPair - 1) / kPair; }
std::int64_t pair_count(const Extent& bricks) { return checked_product({pairs_along_x(bricks), bricks.y, bricks.z}); }

}  // namespace

PositionState::PositionState(const Extent& count, bool keeps)
    : count_(count), bricks_(brick_count(count)), pairs_(pairs_along_x(bricks_)), keeps_(keeps) {
    const auto pairs = static_cast<std::size_t>(pair_count(bricks_)), layers = static_cast<std::size_t>(bricks_.z);
    place_.assign(pairs, kFresh);
    slot_.assign(keeps ? pairs : 0, kNoSlot);
    marks_.assign(keeps ? pairs : 0, 0);
    least_.assign(pairs, 0);
    opened_.assign(layers, 0);
    dead_layers_.assign(layers, 0);
    looks_.assign(layers, Patience());
    if (keeps) open_ = std::make_unique_for_overwrite<OpenPair[]>(pairs);
}

void PositionState::candidates(int bx, int by, const std::uint32_t (&alive)[kBlocksY], std::uint64_t* tile) const {
    const int columns = std::min(kBrickX, count_.x - kBrickX * bx);
    const int rows = std::min(kBrickY, count_.y - kBrickY * by);
    const std::uint64_t row = ~std::uint64_t{0} >> (kBrickX - columns);
    for (int j = 0; j < kBlocksY; ++j) {
        std::fill_n(tile + TrayTables::kBlock * j, TrayTables::kBlock, row & widened(alive[j]));
    }
    if (rows < kBrickY) std::fill(tile + rows, tile + kBrickY, std::uint64_t{0});
}

OpenPair& PositionState::open(int bx, int by, int bz) { return open_at(pair(bx, by, bz), bz); }

/// A pair that has been open before takes the place that it had.
OpenPair& PositionState::open_at(std::size_t pair, int bz) {
    if (slot_[pair] == kNoSlot) slot_[pair] = opened_[static_cast<std::size_t>(bz)]++;
    place_[pair] = slot_[pair];
    return open_[place_in(bz) + static_cast<std::size_t>(place_[pair])];
}

void PositionState::leave_only(const std::vector<VoxelBox>& positions) {
    std::vector<bool> left(place_.size(), false);
    for (const VoxelBox& box : positions) {
        const VoxelBox within = intersection(box, whole(count_));
        if (within.empty()) continue;
        for (int bz = within.lo.z / kBrickZ; bz <= (within.hi.z - 1) / kBrickZ; ++bz) {
            for (int by = within.lo.y / kBrickY; by <= (within.hi.y - 1) / kBrickY; ++by) {
                for (int bx = within.lo.x / kBrickX; bx <= (within.hi.x - 1) / kBrickX; ++bx) {
                    left[pair(bx, by, bz)] = true;
                }
            }
        }
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i] || place_[i] != kFresh) continue;
        close(i);
        left_only_ = true;
    }
}

template <class Visit>
void PositionState::for_each_pair_of(const BitGrid& blocks, const Visit& visit) const {
    static_assert(kPair * kBlocksX == 32 && TrayTables::kBlock == kBrickZ);
    const int rows = ceil_div(count_.y, TrayTables::kBlock);
    for (int bz = 0; bz < bricks_.z; ++bz) {
        for (int by = 0; by < bricks_.y; ++by) {
            for (int px = 0; px < pairs_; ++px) {
                std::uint32_t of_rows[kBlocksY] = {};
                std::uint32_t any = 0;
                const std::size_t i = pair(kPair * px, by, bz);
                for (int j = 0; j < std::min(kBlocksY, rows - kBlocksY * by); ++j) {
                    const BitGrid::Word word = blocks.row(kBlocksY * by + j, bz)[px / 2];
                    of_rows[j] = static_cast<std::uint32_t>(word >> (32 * (px % 2))) & blocks_in(i, j);
                    any |= of_rows[j];
                }
                if (any != 0) visit(i, bz, of_rows);
            }
        }
    }
}

std::uint32_t PositionState::blocks_in(std::size_t pair, int row) const {
    const auto pairs = static_cast<std::size_t>(pairs_);
    const int px = static_cast<int>(pair % pairs);
    const int by = static_cast<int>(pair / pairs % static_cast<std::size_t>(bricks_.y));
    if (kBrickY * by + TrayTables::kBlock * row >= count_.y) return 0;
    const int blocks = ceil_div(count_.x, TrayTables::kBlock) - kPair * kBlocksX * px;
    return blocks >= 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << blocks) - 1;
}

bool PositionState::reopen(const BitGrid& blocks) {
    if (count_.empty()) return false;
    std::int64_t reopened = 0;
    for_each_pair_of(blocks, [&](std::size_t, int, const auto& of_rows) {
        for (const std::uint32_t row : of_rows) {
            reopened += std::popcount(row);
        }
    });
    const std::int64_t all =
        checked_product({ceil_div(count_.x, TrayTables::kBlock), ceil_div(count_.y, TrayTables::kBlock), bricks_.z});
    if (left_only_ || reopened * tuning::kPartsReopened >= all) {
        std::ranges::fill(place_, kFresh);
        std::ranges::fill(slot_, kNoSlot);
        std::ranges::fill(least_, 0u);
        std::ranges::fill(marks_, std::uint8_t{0});
        std::ranges::fill(opened_, 0);
        std::ranges::fill(dead_layers_, std::uint8_t{0});
        left_only_ = false;
        return false;
    }
    for_each_pair_of(blocks, [&](std::size_t i, int bz, const auto& of_rows) { reopen(i, bz, of_rows); });
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        if ((marks_[i] & kHasRefused) != 0) make_fresh(i, static_cast<int>(i / place_in(1)));
    }
    return true;
}

void PositionState::reopen(std::size_t pair, int bz, const std::uint32_t (&blocks)[kBlocksY]) {
    int count = 0, of = 0;
    for (int j = 0; j < kBlocksY; ++j) {
        count += std::popcount(blocks[j]);
        of += std::popcount(blocks_in(pair, j));
    }
    if (count * tuning::kPartsReopened >= of || !keeps_ || place_[pair] == kFresh) {
        make_fresh(pair, bz);
        return;
    }
    const bool was_dead = place_[pair] == kNothing;
    OpenPair& open = open_at(pair, bz);
    if (was_dead) {
        std::fill_n(&open.live[0][0], kPair * kBrickY * kBrickZ, std::uint64_t{0});
        std::fill_n(&open.bound[0][0], kBlocksY * kPair * kBlocksX, kDead);
    }
    for (int j = 0; j < kBlocksY; ++j) {
        for (std::uint32_t left = blocks[j]; left != 0; left &= left - 1) {
            open.bound[j][std::countr_zero(left)] = kReopened;
        }
    }
    marks_[pair] |= kHasReopened;
    least_[pair] = 0;
    dead_layers_[static_cast<std::size_t>(bz)] = 0;
}

void PositionState::make_fresh(std::size_t pair, int bz) {
    place_[pair] = kFresh;
    least_[pair] = 0;
    if (keeps_) marks_[pair] = 0;
    dead_layers_[static_cast<std::size_t>(bz)] = 0;
}

std::uint32_t PositionState::reopened(int bx, int by, int bz, int row) {
    std::uint32_t blocks = 0;
    const auto& bounds = open_pair(bx, by, bz).bound[row];
    for (int x = 0; x < kPair * kBlocksX; ++x) {
        if (bounds[x] == kReopened) blocks |= std::uint32_t{1} << x;
    }
    return blocks;
}

bool PositionState::all_dead() const {
    return std::ranges::all_of(place_, [](std::int32_t place) { return place == kNothing; });
}

void PositionState::look_for_dead_layers(int bz) {
    const auto layer = static_cast<std::size_t>(bz);
    if (!keeps_ || !looks_[layer].asks()) return;
    const std::size_t first = place_in(bz), end = place_in(bz + 1);
    std::uint64_t live[kBrickZ] = {};
    for (std::size_t i = first; i < end; ++i) {
        if (place_[i] == kFresh || (marks_[i] & kHasReopened) != 0) return;
        if (place_[i] == kNothing) continue;
        for (const BrickWords& words : open_[first + static_cast<std::size_t>(place_[i])].live) {
            for (int k = 0; k < kBrickY * kBrickZ; ++k) {
                live[k / kBrickY] |= words[k];
            }
        }
    }
    std::uint8_t dead = 0;
    for (int z = 0; z < kBrickZ; ++z) {
        if (live[z] == 0) dead |= static_cast<std::uint8_t>(1 << z);
    }
    looks_[layer].learn(dead == dead_layers_[layer]);
    dead_layers_[layer] = dead;
}

void PositionState::forget(const BitGrid& blocks) {
    for_each_pair_of(blocks, [&](std::size_t i, int bz, const auto& of_rows) {
        if (place_[i] == kNothing) return;
        least_[i] = 0;
        if (place_[i] == kFresh || !keeps_) return;
        OpenPair& open = open_[place_in(bz) + static_cast<std::size_t>(place_[i])];
        for (int j = 0; j < kBlocksY; ++j) {
            for (std::uint32_t left = of_rows[j]; left != 0; left &= left - 1) {
                std::uint32_t& bound = open.bound[j][std::countr_zero(left)];
                if (bound < kReopened) bound = 0;
            }
        }
    });
}

std::int64_t PositionState::bytes_for(const Extent& count, bool keeps) {
    const std::size_t kept = keeps ? sizeof(std::int32_t) + sizeof(std::uint8_t) + sizeof(OpenPair) : 0;
    const std::size_t of_pair = sizeof(std::int32_t) + sizeof(std::uint32_t) + kept;
    return pair_count(brick_count(count)) * static_cast<std::int64_t>(of_pair);
}

}  // namespace spectralpack
