#include "disassembly/reachable_region.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace spectralpack {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};
constexpr std::size_t kWordsPerLook = 16;  // of a walk: the first and every n-th are asked for a straight way out

/// Bits of positions x .. x + 63 that are below `end`.
std::uint64_t below(int x, int end) {
    if (end <= x) return 0;
    return end - x >= 64 ? kAll : (std::uint64_t{1} << (end - x)) - 1;
}

}  // namespace

ReachableRegion::ReachableRegion(FreeTileReader& tiles, const Extent& solid, const VoxelBox& rest, StopToken stop,
                                 StraightOut straight_out)
    : tiles_(tiles),
      extent_(tiles.extent()),
      solid_(solid),
      rest_{rest.lo - tiles.origin(), rest.hi - tiles.origin()},
      known_(tiles.extent()),
      stop_(std::move(stop)),
      straight_out_(std::move(straight_out)) {}

ReachableRegion::Tile& ReachableRegion::tile(int y, int z, int i) {
    std::unique_ptr<Tile>& tile = known_.at(i, y, z);
    if (!tile) {
        tile = std::make_unique<Tile>();
        ++tiles_made_;
    }
    return *tile;
}

/// Steps at least along y or z; 0 is outside.
int ReachableRegion::to_go(int y, int z) const {
    return std::max(0,
                    std::min({y + solid_.y - rest_.lo.y, rest_.hi.y - y, z + solid_.z - rest_.lo.z, rest_.hi.z - z}));
}

/// Those of word i that lie beside the rest along x.
std::uint64_t ReachableRegion::outside_along_x(int i) const {
    return below(64 * i, rest_.lo.x - solid_.x + 1) | ~below(64 * i, rest_.hi.x);
}

/// Visits positions, which are free.
void ReachableRegion::reach(const Some& fresh, Tile& tile) {
    Word& at = word(tile, fresh.y);
    at.visited |= fresh.positions;
    walked_.push_back({fresh, &tile});
    const auto left = static_cast<std::size_t>(to_go(fresh.y, fresh.z));
    const auto leads_straight_out = [&] {
        if (!straight_out_ || (walked_.size() - 1) % kWordsPerLook != 0) return false;
        const int x = 64 * fresh.i + std::countr_zero(fresh.positions);
        return straight_out_(VoxelIndex{x, fresh.y, fresh.z} + tiles_.origin());
    };
    if (left == 0 || (fresh.positions & outside_along_x(fresh.i)) != 0 || leads_straight_out()) {
        outside_ = true;
        return;
    }
    if (open_.size() <= left) open_.resize(left + 1);
    open_[left].push_back({fresh, &tile});
    least_ = std::min(least_, left);
    if (at.sideways == 0) sideways_.push_back({fresh, &tile});
    at.sideways |= fresh.positions;
}

/// Finds out which of these positions are free, and likewise of those beside them along y, which a walk asks for next.
void ReachableRegion::look(const Some& wanted, Tile& tile) {
    if ((wanted.positions & ~word(tile, wanted.y).known) == 0) return;
    FreeTileReader::Rows unknown;
    for (std::size_t row = 0; row < kRows; ++row) {
        unknown[row] = wanted.positions & ~tile[row].known;
    }
    const FreeTileReader::Told told = tiles_.tell(wanted.i, wanted.y / kRows, wanted.z, unknown);
    for (std::size_t row = 0; row < kRows; ++row) {
        tile[row].known |= told.known[row];
        tile[row].free |= told.free[row];
    }
}

/// Visits those of `neighbours`, next to positions visited, that are free.
void ReachableRegion::touch(const Some& neighbours, Tile& tile) {
    Word& at = word(tile, neighbours.y);
    if (neighbours.positions & at.outside) {
        outside_ = true;
        return;
    }
    Some some = neighbours;
    some.positions &= ~at.visited;
    look(some, tile);
    some.positions &= at.free;
    if (some.positions != 0) reach(some, tile);
}

void ReachableRegion::go_on(const Visited& from) {
    for (int move = 0; move < 4 && !outside_; ++move) {
        Some to = from.some;
        (move < 2 ? to.y : to.z) += move % 2 == 0 ? 1 : -1;
        if (to.y < 0 || to.y >= extent_.y || to.z < 0 || to.z >= extent_.z) continue;
        const bool same = to.z == from.some.z && to.y / kRows == from.some.y / kRows;
        touch(to, same ? *from.tile : tile(to.y, to.z, to.i));
    }
}

void ReachableRegion::go_sideways(const Visited& where) {
    const auto& [y, z, i, first] = where.some;
    const std::uint64_t from = std::exchange(word(*where.tile, y).sideways, 0);
    touch({y, z, i, from << 1 | from >> 1}, *where.tile);
    if (from >> 63 && i + 1 < known_.words()) touch({y, z, i + 1, 1}, tile(y, z, i + 1));
    if ((from & 1) && i > 0) touch({y, z, i - 1, std::uint64_t{1} << 63}, tile(y, z, i - 1));
}

bool ReachableRegion::free(const VoxelIndex& position) {
    const VoxelIndex at = position - tiles_.origin();
    if (!extent_.contains(at)) return true;
    const std::uint64_t bit = std::uint64_t{1} << (at.x % 64);
    Tile& tile = this->tile(at.y, at.z, at.x / 64);
    look({at.y, at.z, at.x / 64, bit}, tile);
    return word(tile, at.y).free & bit;
}

bool ReachableRegion::visited(const VoxelIndex& position) {
    const VoxelIndex at = position - tiles_.origin();
    return extent_.contains(at) && (word(at.y, at.z, at.x / 64).visited >> (at.x % 64) & 1);
}

bool ReachableRegion::contains(const VoxelIndex& start) {
    const VoxelIndex from = start - tiles_.origin();
    if (!extent_.contains(from)) return true;
    const std::uint64_t bit = std::uint64_t{1} << (from.x % 64);
    Tile& tile = this->tile(from.y, from.z, from.x / 64);
    Word& at = word(tile, from.y);
    if (at.visited & bit) return at.outside & bit;

    outside_ = false;
    at.known |= bit;
    at.free |= bit;
    reach({from.y, from.z, from.x / 64, bit}, tile);
    while (!outside_ && !stop_.stopped()) {
        while (least_ < open_.size() && open_[least_].empty()) {
            ++least_;
        }
        if (least_ < open_.size()) {
            const Visited next = open_[least_].back();
            open_[least_].pop_back();
            go_on(next);
        } else if (!sideways_.empty()) {
            const Visited next = sideways_.back();
            sideways_.pop_back();
            go_sideways(next);
        } else {
            break;
        }
    }
    for (const auto& [visited, where] : walked_) {
        Word& there = word(*where, visited.y);
        there.sideways = 0;
        if (outside_) there.outside |= visited.positions;
        const int x = 64 * visited.i;
        const VoxelIndex lo{x + std::countr_zero(visited.positions), visited.y, visited.z};
        const VoxelIndex hi{x + 64 - std::countl_zero(visited.positions), visited.y + 1, visited.z + 1};
        visited_box_ = hull(visited_box_, {lo + tiles_.origin(), hi + tiles_.origin()});
    }
    walked_.clear();
    for (std::size_t i = least_; i < open_.size(); ++i) {
        open_[i].clear();  // which keeps its room for the next walk: most are short
    }
    sideways_.clear();
    least_ = open_.size();
    return outside_;
}

}  // namespace spectralpack
