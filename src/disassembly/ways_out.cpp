#include "disassembly/ways_out.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "disassembly/ways/flood_fill.hpp"
#include "disassembly/ways/moves.hpp"
#include "disassembly/ways/reachable_region.hpp"

namespace spectralpack {
namespace {

using Path = Subassembly::Path;

// Section 4.2: the nearest free positions that a copy off the grid is moved to; how far away they are looked for.
constexpr int kSnaps = 10;
constexpr int kSnapReach = 2;  // voxels

/// Moves along the axes, in some order, that are free and come to `move`.
std::optional<Path> snap(const Subassembly& subassembly, std::size_t i, const Vec3& move) {
    constexpr int kOrders[6][3] = {{2, 0, 1}, {2, 1, 0}, {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}};
    for (const auto& order : kOrders) {
        Path path;
        for (const int axis : order) {
            Vec3 leg;
            leg[axis] = move[axis];
            path.push_back(leg);
        }
        path = merged(path);
        if (subassembly.free_path({i}, {}, path)) return path;
    }
    return std::nullopt;
}

/// Goes along `path`, which leads outside, to the first corner from which it is free to go straight out, and then that
/// way. None where a move is not free.
std::optional<Path> out_along(const Subassembly& subassembly, std::size_t i, const Path& path) {
    Path gone;
    Vec3 from;
    std::array<Subassembly::Hints, BlockingGraph::kDirections>
        hints;  // who was in the way the last time, likely still is
    for (const Vec3& move : path) {
        if (!subassembly.free_move({i}, from, move)) return std::nullopt;
        from = from + move;
        gone.push_back(move);
        // From the end it goes on by the clearance.
        const bool end = gone.size() == path.size();
        for (int d = 0; d < BlockingGraph::kDirections; ++d) {
            const AxisDirection direction = BlockingGraph::direction(d);
            const AxisDirection last = direction_of(move);
            if (end && (direction.axis != last.axis || direction.sign != last.sign)) continue;
            const Subassembly::Straight way = subassembly.straight_way({i}, from, direction, hints[d]);
            if (way.met) {
                hints[d].first = way.met->other;
                continue;
            }
            gone.insert(gone.end(), way.path.begin(), way.path.end());
            return merged(gone);
        }
    }
    return std::nullopt;
}

}  // namespace

Flooded way_out(const Subassembly& subassembly, Subassembly::Flood& flood) {
    if (!flood.tiles) return {Path{}};
    const auto& [i, solid, at, nearest, on_grid, origin, others, tiles] = flood;
    const double dx = subassembly.voxel_size();
    ReachableRegion region(*tiles, solid->extent(), others, subassembly.stop());

    // Where to start: on the grid where it stands; off it, at free positions near by.
    struct Start {
        double away;
        VoxelIndex position;
    };
    std::vector<Start> starts;
    if (on_grid && region.free(nearest - origin)) {
        starts.push_back({0, nearest});
    } else {
        const VoxelIndex reach{kSnapReach, kSnapReach, kSnapReach};
        const VoxelIndex around = nearest - origin;
        region.look_around({around - reach, around + reach + VoxelIndex{1, 1, 1}});
        for (int z = -kSnapReach; z <= kSnapReach; ++z) {
            for (int y = -kSnapReach; y <= kSnapReach; ++y) {
                for (int x = -kSnapReach; x <= kSnapReach; ++x) {
                    const VoxelIndex position = nearest + VoxelIndex{x, y, z};
                    if (!region.free(position - origin)) continue;
                    const Vec3 there{position.x * dx, position.y * dx, position.z * dx};
                    starts.push_back({length(there - at), position});
                }
            }
        }
        std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.away < b.away; });
    }
    int snaps = 0;
    for (const Start& start : starts) {
        if (!region.free(start.position - origin)) continue;  // in a closed region
        if (start.away > 0 && ++snaps > kSnaps) break;
        if (!region.contains(start.position - origin)) continue;
        // Sweeps take longer than walks, which never come to the same place twice: so only from where there is a way.
        Path path;
        if (start.away > 0) {
            const Vec3 there{start.position.x * dx, start.position.y * dx, start.position.z * dx};
            std::optional<Path> there_by = snap(subassembly, i, there - at);
            if (!there_by) continue;
            path = std::move(*there_by);
        }
        const std::vector<VoxelIndex> way = FloodFill(region, subassembly.stop()).way_out(start.position - origin);
        if (way.empty()) break;  // stopped
        for (std::size_t k = 1; k < way.size(); ++k) {
            const VoxelIndex d = way[k] - way[k - 1];
            path.push_back({d.x * dx, d.y * dx, d.z * dx});
        }
        if (std::optional<Path> out = out_along(subassembly, i, merged(path))) {
            const auto free = [&subassembly, one = flood.i](const Vec3& from, const Vec3& move) {
                return subassembly.free_move({one}, from, move);
            };
            return {shortened(std::move(*out), free)};
        }
        // Voxels and meshes disagree, which only rounding can make them do. Whoever leaves may change that.
        return {std::nullopt, ClosedRegion({others.lo + origin, others.hi + origin}), true};
    }
    // Positions that were found taken, or that sweeps led by.
    constexpr int kSwept = kSnapReach + 1;
    VoxelBox asked{nearest - VoxelIndex{kSwept, kSwept, kSwept},
                   nearest + VoxelIndex{kSwept + 1, kSwept + 1, kSwept + 1}};
    if (VoxelBox walked = region.visited_box(); !walked.empty()) {
        walked = {walked.lo + origin - VoxelIndex{1, 1, 1}, walked.hi + origin + VoxelIndex{1, 1, 1}};
        asked = hull(asked, walked);
    }
    return {std::nullopt, ClosedRegion(*solid, asked), !starts.empty()};
}

std::optional<Path> any_way_out(const Subassembly& subassembly, std::size_t i) {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        Subassembly::Straight straight = subassembly.straight_way({i}, BlockingGraph::direction(d));
        if (!straight.met) return std::move(straight.path);
    }
    Subassembly::Flood last = subassembly.flood(i);
    return way_out(subassembly, last).path;
}

std::optional<Path> way_beside_the_grid(const Subassembly& subassembly, std::size_t i) {
    std::array<Subassembly::Hints, BlockingGraph::kDirections>
        hints;  // who was in the way from elsewhere, likely is from here
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        const AxisDirection first = BlockingGraph::direction(d);
        const Vec3 aside = along(first, subassembly.voxel_size());
        if (!subassembly.free_move({i}, {}, aside)) continue;
        for (int on = 0; on < BlockingGraph::kDirections; ++on) {
            const AxisDirection direction = BlockingGraph::direction(on);
            if (direction.axis == first.axis) continue;
            const Subassembly::Straight way = subassembly.straight_way({i}, aside, direction, hints[on]);
            if (way.met) {
                hints[on].first = way.met->other;
                continue;
            }
            Path path{aside};
            path.insert(path.end(), way.path.begin(), way.path.end());
            return path;
        }
    }
    return std::nullopt;
}

}  // namespace spectralpack
