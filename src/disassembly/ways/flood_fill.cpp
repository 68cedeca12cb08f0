#include "disassembly/ways/flood_fill.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace spectralpack {
namespace {

VoxelIndex step(VoxelIndex at, int move) {
    at[move / 2] += move % 2 == 0 ? 1 : -1;
    return at;
}

/// Of axis-parallel moves from a to b and from b to c.
bool in_line(const VoxelIndex& a, const VoxelIndex& b, const VoxelIndex& c) {
    return (a.x != b.x) == (b.x != c.x) && (a.y != b.y) == (b.y != c.y);
}

}  // namespace

FloodFill::FloodFill(const ReachableRegion& region, StopToken stop)
    : region_(region), known_(region.extent()), stop_(std::move(stop)) {}

FloodFill::Tile& FloodFill::tile(const VoxelIndex& at) {
    return known_.at(at.x / 64, at.y, at.z, [&] { return Tile{region_.visited_rows(at.x / 64, at.y, at.z)}; });
}

std::vector<VoxelIndex> FloodFill::way_out(const VoxelIndex& start) {
    const VoxelIndex from = start - region_.origin();
    if (!region_.extent().contains(from)) return {start};
    // Buckets by steps in all; the least only grows, since a step brings at most one step nearer.
    std::vector<std::vector<Entry>> open;
    auto least = static_cast<std::size_t>(region_.to_go(from));
    const auto push = [&](const Entry& entry) {
        const auto total = static_cast<std::size_t>(entry.gone + region_.to_go(entry.at));
        if (open.size() <= total) open.resize(total + 1);
        open[total].push_back(entry);
    };
    std::int64_t visited = 0;
    push({from, 0, kStart});
    for (; least < open.size(); ++least) {
        while (!open[least].empty()) {
            const Entry entry = open[least].back();
            open[least].pop_back();
            std::uint8_t& came_here = came(tile(entry.at), entry.at);
            if (came_here != 0) continue;
            if (visited++ % kPoll == 0 && stop_.stopped()) return {};
            came_here = entry.came;
            if (region_.to_go(entry.at) == 0) return trace(entry.at);
            // The move that led here is tried first (it is pushed last), for few corners.
            const int ahead = entry.came == kStart ? 0 : entry.came - 1;
            for (int i = 5; i >= 0; --i) {
                const int move = i == 0 ? ahead : i <= ahead ? i - 1 : i;
                const VoxelIndex next = step(entry.at, move);
                if (!region_.extent().contains(next)) continue;
                Tile& there = tile(next);
                const bool is_open = there.open[static_cast<std::size_t>(next.y % kRows)] >> (next.x % 64) & 1;
                if (!is_open || came(there, next) != 0) continue;
                push({next, entry.gone + 1, static_cast<std::uint8_t>(move + 1)});
            }
        }
        open[least] = {};  // its room
    }
    return {};
}

std::vector<VoxelIndex> FloodFill::trace(VoxelIndex at) {
    std::vector<VoxelIndex> way{at + region_.origin()};
    int last = -1;
    for (;;) {
        const std::uint8_t came_here = came(tile(at), at);
        if (came_here == kStart) break;
        const int move = came_here - 1;
        at = step(at, move ^ 1);  // back
        if (move == last) way.pop_back();
        way.push_back(at + region_.origin());
        last = move;
    }
    std::reverse(way.begin(), way.end());
    return with_few_corners(way);
}

std::vector<VoxelIndex> FloodFill::with_few_corners(const std::vector<VoxelIndex>& way) const {
    std::vector<VoxelIndex> corners{way.front()};
    for (std::size_t k = 0; k + 1 < way.size();) {
        // Straight, or with a corner or two, to the farthest corner that can be reached so; the next one can.
        std::size_t next = way.size() - 1;
        std::vector<VoxelIndex> leg;
        while (next > k + 1 && (leg = leg_between(way[k], way[next], next - k)).empty()) {
            --next;
        }
        if (next == k + 1) leg = {way[next]};
        for (const VoxelIndex& corner : leg) {
            if (corners.size() > 1 && in_line(corners[corners.size() - 2], corners.back(), corner)) corners.pop_back();
            corners.push_back(corner);
        }
        k = next;
    }
    return corners;
}

std::vector<VoxelIndex> FloodFill::leg_between(const VoxelIndex& from, const VoxelIndex& to,
                                               std::size_t fewer_than) const {
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis) {
        if (from[axis] != to[axis]) axes.push_back(axis);
    }
    if (axes.size() >= fewer_than) return {};
    // Long moves first: the way may go straight out after them.
    const auto before = [&](int a, int b) {
        const int way_a = std::abs(to[a] - from[a]), way_b = std::abs(to[b] - from[b]);
        return way_a != way_b ? way_a > way_b : a < b;
    };
    std::sort(axes.begin(), axes.end(), before);
    do {
        std::vector<VoxelIndex> leg;
        VoxelIndex at = from;
        const bool free = std::all_of(axes.begin(), axes.end(), [&](int axis) {
            while (at[axis] != to[axis]) {
                at[axis] += to[axis] > at[axis] ? 1 : -1;
                if (!region_.visited(at)) return false;
            }
            leg.push_back(at);
            return true;
        });
        if (free) return leg;
    } while (std::next_permutation(axes.begin(), axes.end(), before));
    return {};
}

}  // namespace spectralpack
