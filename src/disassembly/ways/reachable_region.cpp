#include "disassembly/ways/reachable_region.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace spectralpack {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};
constexpr std::int64_t kReachedPerLook = 16;  // of a walk: the first and every n-th are asked for a straight way out
constexpr std::size_t kTilesOfShortWalk = 1000;

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
      straight_out_(std::move(straight_out)) {
    for (Word& word : closed_.words) {
        word.known = kAll;
    }
}

ReachableRegion::Place ReachableRegion::place(int i, int y, int z) {
    return {&known_.at(i, y, z, [&] { return Tile{i, y / kRows * kRows, z}; }), y};
}

/// Steps at least along y or z; 0 is outside.
int ReachableRegion::to_go(int y, int z) const {
    return std::max(0,
                    std::min({y + solid_.y - rest_.lo.y, rest_.hi.y - y, z + solid_.z - rest_.lo.z, rest_.hi.z - z}));
}

int ReachableRegion::to_go(const VoxelIndex& at) const {
    return std::max(0, std::min({to_go(at.y, at.z), at.x + solid_.x - rest_.lo.x, rest_.hi.x - at.x}));
}

/// Those of word i that lie beside the rest along x.
std::uint64_t ReachableRegion::outside_along_x(int i) const {
    return below(64 * i, rest_.lo.x - solid_.x + 1) | ~below(64 * i, rest_.hi.x);
}

/// Visits positions, which are free.
void ReachableRegion::reach(const Place& at, std::uint64_t fresh) {
    Tile& tile = *at.tile;
    Word& word = at.word();
    word.visited |= fresh;
    word.known &= ~fresh;
    if (!std::exchange(tile.on_walk, true)) walk_.tiles.push_back(&tile);
    const auto left = static_cast<std::size_t>(to_go(at.y, tile.z));
    const auto leads_straight_out = [&] {
        if (!straight_out_ || walk_.reached++ % kReachedPerLook != 0) return false;
        return straight_out_(VoxelIndex{64 * tile.i + std::countr_zero(fresh), at.y, tile.z} + tiles_.origin());
    };
    if (left == 0 || (fresh & outside_along_x(tile.i)) != 0 || leads_straight_out()) {
        walk_.outside = true;
        return;
    }
    if ((tile.onward & at.bit()) == 0) {
        if (walk_.open.size() <= left) walk_.open.resize(left + 1);
        walk_.open[left].push_back(at);
        walk_.least = std::min(walk_.least, left);
        tile.onward |= at.bit();
    }
    if ((tile.sideways & at.bit()) == 0) {
        walk_.sideways.push_back(at);
        tile.sideways |= at.bit();
    }
}

/// Finds out which of these positions are free, and likewise of those beside them along y, which a walk asks for next.
/// True where nothing of the tile is free: it is let go of then.
bool ReachableRegion::look(const Place& at, std::uint64_t wanted) {
    if ((wanted & ~at.word().known) == 0) return false;
    Tile& tile = *at.tile;
    FreeTileReader::Rows unknown;
    for (std::size_t row = 0; row < kRows; ++row) {
        unknown[row] = wanted & ~(tile.words[row].known | tile.words[row].visited);
    }
    const FreeTileReader::Told told = tiles_.tell(tile.i, tile.y / kRows, tile.z, unknown);
    for (std::size_t row = 0; row < kRows; ++row) {
        Word& word = tile.words[row];
        const std::uint64_t news = told.known[row] & ~(word.known | word.visited);
        word.free |= told.free[row] & news;
        word.known |= news;
    }
    return let_go_if_closed(tile);
}

/// Visits those of `neighbours`, next to positions visited, that are free.
void ReachableRegion::touch(const Place& at, std::uint64_t neighbours) {
    const Word& word = at.word();
    if (neighbours & word.outside()) {
        walk_.outside = true;
        return;
    }
    const std::uint64_t wanted = neighbours & ~word.visited;
    if (look(at, wanted)) return;
    if (const std::uint64_t fresh = wanted & word.free) reach(at, fresh);
}

void ReachableRegion::go_on(const Place& from) {
    Tile& tile = *from.tile;
    tile.onward ^= from.bit();
    const std::uint64_t positions = from.word().on_walk();
    for (int move = 0; move < 4 && !walk_.outside; ++move) {
        int y = from.y, z = tile.z;
        (move < 2 ? y : z) += move % 2 == 0 ? 1 : -1;
        if (y < 0 || y >= extent_.y || z < 0 || z >= extent_.z) continue;
        const bool same = z == tile.z && y / kRows == from.y / kRows;
        touch(same ? Place{from.tile, y} : place(tile.i, y, z), positions);
    }
}

void ReachableRegion::go_sideways(const Place& from) {
    from.tile->sideways ^= from.bit();
    const std::uint64_t positions = from.word().on_walk();
    const int i = from.tile->i, y = from.y, z = from.tile->z;
    touch(from, positions << 1 | positions >> 1);
    if (positions >> 63 && i + 1 < known_.words()) touch(place(i + 1, y, z), 1);
    if ((positions & 1) && i > 0) touch(place(i - 1, y, z), std::uint64_t{1} << 63);
}

void ReachableRegion::look_around(const VoxelBox& positions) {
    const VoxelBox box = intersection({positions.lo - tiles_.origin(), positions.hi - tiles_.origin()}, whole(extent_));
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y / kRows * kRows; y < box.hi.y; y += kRows) {
            for (int i = box.lo.x / 64; 64 * i < box.hi.x; ++i) {
                look(place(i, y, z), below(64 * i, box.hi.x) & ~below(64 * i, box.lo.x));
            }
        }
    }
}

bool ReachableRegion::free(const VoxelIndex& position) {
    const VoxelIndex q = position - tiles_.origin();
    if (!extent_.contains(q)) return true;
    const std::uint64_t bit = std::uint64_t{1} << (q.x % 64);
    const Place at = place(q.x / 64, q.y, q.z);
    if (at.word().visited & bit) return true;
    return !look(at, bit) && at.word().free & bit;
}

bool ReachableRegion::visited(const VoxelIndex& position) const {
    const VoxelIndex q = position - tiles_.origin();
    const Tile* tile = extent_.contains(q) ? known_.find(q.x / 64, q.y, q.z) : nullptr;
    return tile && (tile->words[static_cast<std::size_t>(q.y % kRows)].visited >> (q.x % 64) & 1);
}

FreeTileReader::Rows ReachableRegion::visited_rows(int i, int y, int z) const {
    FreeTileReader::Rows rows{};
    const Tile* tile = known_.find(i, y, z);
    for (std::size_t row = 0; tile && row < kRows; ++row) {
        rows[row] = tile->words[row].visited;
    }
    return rows;
}

bool ReachableRegion::contains(const VoxelIndex& start) {
    const VoxelIndex q = start - tiles_.origin();
    if (!extent_.contains(q)) return true;
    const std::uint64_t bit = std::uint64_t{1} << (q.x % 64);
    const Place from = place(q.x / 64, q.y, q.z);
    if (from.word().outside() & bit) return true;
    if (from.word().known & ~from.word().free & bit) return false;  // of a closed region

    from.word().free |= bit;
    reach(from, bit);
    while (!walk_.outside && !stop_.stopped()) {
        while (walk_.least < walk_.open.size() && walk_.open[walk_.least].empty()) {
            ++walk_.least;
        }
        if (walk_.least < walk_.open.size()) {
            const Place next = walk_.open[walk_.least].back();
            walk_.open[walk_.least].pop_back();
            go_on(next);
        } else if (!walk_.sideways.empty()) {
            const Place next = walk_.sideways.back();
            walk_.sideways.pop_back();
            go_sideways(next);
        } else {
            break;
        }
    }
    const bool outside = walk_.outside;
    end_walk();
    return outside;
}

/// Two thirds of the tiles end so, and one does for all of them.
bool ReachableRegion::let_go_if_closed(const Tile& tile) {
    if (tile.on_walk || !tile.closed()) return false;
    known_.replace(tile.i, tile.y, tile.z, closed_);
    return true;
}

/// Remembers of all that was visited what it came to.
void ReachableRegion::end_walk() {
    for (Tile* tile : walk_.tiles) {
        tile->on_walk = false;
        tile->onward = tile->sideways = 0;
        const int x = 64 * tile->i;
        for (int row = 0; row < kRows; ++row) {
            Word& word = tile->words[static_cast<std::size_t>(row)];
            const std::uint64_t visited = word.on_walk();
            if (visited == 0) continue;
            if (!walk_.outside) {
                word.free &= ~visited;
                word.visited &= ~visited;
            }
            word.known |= visited;
            const VoxelIndex lo{x + std::countr_zero(visited), tile->y + row, tile->z};
            const VoxelIndex hi{x + 64 - std::countl_zero(visited), tile->y + row + 1, tile->z + 1};
            visited_box_ = hull(visited_box_, {lo + tiles_.origin(), hi + tiles_.origin()});
        }
        if (!walk_.outside) let_go_if_closed(*tile);
    }
    if (walk_.tiles.size() > kTilesOfShortWalk) {
        walk_ = {};
        return;
    }
    // Most are short, and the next one has use for their room.
    walk_.outside = false;
    walk_.reached = 0;
    walk_.tiles.clear();
    walk_.sideways.clear();
    for (std::size_t i = walk_.least; i < walk_.open.size(); ++i) {
        walk_.open[i].clear();
    }
    walk_.least = walk_.open.size();
}

}  // namespace spectralpack
