#include "disassembly/flood_fill.hpp"

#include <algorithm>
#include <utility>

#include "disassembly/moves.hpp"

namespace spectralpack {
namespace {

VoxelIndex step(VoxelIndex at, int move) {
    at[move / 2] += move % 2 == 0 ? 1 : -1;
    return at;
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
    std::vector<Vec3> moves;  // in voxels
    for (std::size_t k = 1; k < way.size(); ++k) {
        const VoxelIndex d = way[k] - way[k - 1];
        moves.push_back({static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)});
    }
    const auto position = [&](const Vec3& at) {
        return way.front() + VoxelIndex{static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z)};
    };
    moves = shortened(std::move(moves), [&](const Vec3& from, const Vec3& move) {
        const AxisDirection direction = direction_of(move);
        const VoxelIndex end = position(from + move);
        for (VoxelIndex at = position(from); at != end;) {
            at[direction.axis] += direction.sign;
            if (!region_.visited(at)) return false;
        }
        return true;
    });
    std::vector<VoxelIndex> corners{way.front()};
    Vec3 at;
    for (const Vec3& move : moves) {
        at = at + move;
        corners.push_back(position(at));
    }
    return corners;
}

}  // namespace spectralpack
