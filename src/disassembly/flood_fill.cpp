#include "disassembly/flood_fill.hpp"

#include <algorithm>
#include <limits>

namespace spectralpack {
namespace {

VoxelIndex step(VoxelIndex at, int move) {
    at[move / 2] += move % 2 == 0 ? 1 : -1;
    return at;
}

}  // namespace

FloodFill::FloodFill(FreeRowReader& rows, const Extent& solid, const VoxelBox& rest, StopToken stop)
    : rows_(rows),
      solid_(solid),
      rest_{rest.lo - rows.origin(), rest.hi - rows.origin()},
      of_(static_cast<std::size_t>(rows.extent().y) * static_cast<std::size_t>(rows.extent().z), -1),
      stop_(std::move(stop)) {}

FloodFill::Row& FloodFill::row(int y, int z) {
    std::int32_t& index = of_[static_cast<std::size_t>(z) * static_cast<std::size_t>(rows_.extent().y) +
                              static_cast<std::size_t>(y)];
    if (index < 0) {
        index = static_cast<std::int32_t>(known_.size());
        const auto nx = static_cast<std::size_t>(rows_.extent().x);
        const std::size_t words = (nx + 63) / 64;
        known_.push_back({std::vector<std::uint64_t>(words), std::vector<bool>(words), std::vector<std::uint8_t>(nx, 0)});
    }
    return known_[static_cast<std::size_t>(index)];
}

bool FloodFill::is_free(Row& row, const VoxelIndex& at) {
    const auto word = static_cast<std::size_t>(at.x / 64);
    if (!row.computed[word]) {
        rows_.words(at.y, at.z, at.x / 64, 1, &row.free[word]);
        row.computed[word] = true;
    }
    return row.free[word] >> (at.x % 64) & 1;
}

int FloodFill::to_go(const VoxelIndex& at) const {
    int least = std::numeric_limits<int>::max();
    for (int axis = 0; axis < 3; ++axis) {
        least = std::min({least, at[axis] + solid_[axis] - rest_.lo[axis], rest_.hi[axis] - at[axis]});
    }
    return std::max(0, least);
}

std::vector<VoxelIndex> FloodFill::way_out(const VoxelIndex& start) {
    const VoxelIndex from = start - rows_.origin();
    if (!rows_.extent().contains(from)) return {start};
    // Buckets by steps in all; the least only grows, since a step brings at most one step nearer.
    std::vector<std::vector<Entry>> open;
    std::size_t least = static_cast<std::size_t>(to_go(from));
    const auto push = [&](const Entry& entry) {
        const auto total = static_cast<std::size_t>(entry.gone + to_go(entry.at));
        if (open.size() <= total) open.resize(total + 1);
        open[total].push_back(entry);
    };
    push({from, 0, kStart});
    for (; least < open.size(); ++least) {
        while (!open[least].empty()) {
            const Entry entry = open[least].back();
            open[least].pop_back();
            std::uint8_t& came = row(entry.at.y, entry.at.z).came[static_cast<std::size_t>(entry.at.x)];
            if (came != 0) continue;
            if (++visited_ % kPoll == 0 && stop_.stopped()) return {};
            came = entry.came;
            if (to_go(entry.at) == 0) return trace(entry.at);
            // The move that led here is tried first (it is pushed last), for few corners.
            const int ahead = entry.came == kStart ? 0 : entry.came - 1;
            for (int i = 5; i >= 0; --i) {
                const int move = i == 0 ? ahead : i <= ahead ? i - 1 : i;
                const VoxelIndex next = step(entry.at, move);
                if (!rows_.extent().contains(next)) continue;
                Row& there = row(next.y, next.z);
                if (!is_free(there, next)) continue;
                if (there.came[static_cast<std::size_t>(next.x)] != 0) continue;
                push({next, entry.gone + 1, static_cast<std::uint8_t>(move + 1)});
            }
        }
    }
    return {};
}

std::vector<VoxelIndex> FloodFill::trace(VoxelIndex at) {
    std::vector<VoxelIndex> way{at + rows_.origin()};
    int last = -1;
    for (;;) {
        const std::uint8_t came = row(at.y, at.z).came[static_cast<std::size_t>(at.x)];
        if (came == kStart) break;
        const int move = came - 1;
        at = step(at, move ^ 1);  // back
        if (move == last) way.pop_back();
        way.push_back(at + rows_.origin());
        last = move;
    }
    std::reverse(way.begin(), way.end());
    return way;
}

}  // namespace spectralpack
