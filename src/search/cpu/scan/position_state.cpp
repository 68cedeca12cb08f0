#include "search/cpu/scan/position_state.hpp"

#include <algorithm>
#include <utility>

#include "core/checked.hpp"
#include "search/cpu/tables/block_bits.hpp"

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

OpenPair& PositionState::open(int bx, int by, int bz) {
    place_[pair(bx, by, bz)] = opened_[static_cast<std::size_t>(bz)]++;
    return open_pair(bx, by, bz);
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
        if (!left[i] && place_[i] == kFresh) close(i);
    }
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
        if (place_[i] == kFresh) return;
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

/// The blocks from which a shape of `extent` reaches into `changed`.
VoxelBox PositionState::blocks_reaching(const VoxelBox& changed, const Extent& extent) const {
    if (changed.empty()) return {};
    // Position q meets the box where q < hi and q + extent > lo.
    VoxelBox box =
        intersection({changed.lo - VoxelIndex{extent.x - 1, extent.y - 1, extent.z - 1}, changed.hi}, whole(count_));
    if (box.empty()) return {};
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] /= TrayTables::kBlock;
        box.hi[axis] = ceil_div(box.hi[axis], TrayTables::kBlock);
    }
    return box;
}

void PositionState::forget(const VoxelBox& changed, const Extent& extent) {
    const VoxelBox blocks = blocks_reaching(changed, extent);
    for (int z = blocks.lo.z; z < blocks.hi.z; ++z) {
        for (int y = blocks.lo.y; y < blocks.hi.y; ++y) {
            const int by = y / kBlocksY;
            for (int bx = blocks.lo.x / kBlocksX / kPair * kPair; bx * kBlocksX < blocks.hi.x; bx += kPair) {
                if (!is_dead(bx, by, z)) set_least_bound(bx, by, z, 0);
                if (!is_open(bx, by, z)) continue;
                const int first = bx * kBlocksX;
                std::uint32_t* row = open_pair(bx, by, z).bound[y % kBlocksY];
                const int end = std::min(blocks.hi.x, first + kPair * kBlocksX);
                for (int x = std::max(blocks.lo.x, first); x < end; ++x) {
                    std::uint32_t& bound = row[x - first];
                    if (bound != kDead) bound = 0;
                }
            }
        }
    }
}

std::int64_t PositionState::bytes_for(const Extent& count, bool keeps) {
    const std::size_t of_pair = sizeof(std::int32_t) + sizeof(std::uint32_t) + (keeps ? sizeof(OpenPair) : 0);
    return pair_count(brick_count(count)) * static_cast<std::int64_t>(of_pair);
}

}  // namespace spectralpack
