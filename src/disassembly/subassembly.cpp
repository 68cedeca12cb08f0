#include "disassembly/subassembly.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "disassembly/ways/flood_fill.hpp"
#include "disassembly/ways/moves.hpp"
#include "disassembly/ways/reachable_region.hpp"
#include "geometry/slides_past.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

// A copy this near to the grid, in voxels, is on it: voxelize_at() sees it so.
constexpr double kOnGrid = kSurfaceShrink;
// Section 4.2: the nearest free positions that a copy off the grid is moved to; how far away they are looked for.
constexpr int kSnaps = 10;
constexpr int kSnapReach = 2;  // voxels

Box hull_of(const std::vector<Box>& boxes) {
    Box hull;
    for (const Box& box : boxes) {
        hull.add(box);
    }
    return hull;
}

/// Voxel indices as coordinates.
Box voxel_box(const Body& part) {
    const VoxelBox box = part.object.box();
    return {{1.0 * box.lo.x, 1.0 * box.lo.y, 1.0 * box.lo.z}, {1.0 * box.hi.x, 1.0 * box.hi.y, 1.0 * box.hi.z}};
}

std::vector<Box> voxel_boxes_of(const std::vector<Body>& parts) {
    std::vector<Box> boxes;
    for (const Body& part : parts) {
        boxes.push_back(voxel_box(part));
    }
    return boxes;
}

template <class T>
std::vector<T> picked(const std::vector<T>& from, const Subassembly::Members& members) {
    std::vector<T> some;
    for (const std::size_t i : members) {
        some.push_back(from[i]);
    }
    return some;
}

VoxelIndex voxel(const Vec3& corner) {
    return {static_cast<int>(corner.x), static_cast<int>(corner.y), static_cast<int>(corner.z)};
}

}  // namespace

Subassembly::Subassembly(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts)
    : Subassembly(options, std::move(names), std::move(parts), {options.grid, {}}) {}

Subassembly::Subassembly(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts,
                         const Plot& plot)
    : options_(options),
      names_(std::move(names)),
      parts_(std::move(parts)),
      boxes_(boxes_of(parts_)),
      present_(parts_.size(), true),
      index_(hull_of(boxes_)),
      hull_(boxes_),
      voxel_hull_(voxel_boxes_of(parts_)),
      origin_(plot.origin),
      tray_(plot.grid) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        index_.add(static_cast<std::int64_t>(i), boxes_[i]);
        objects_.push_back(place(parts_[i].object));
    }
}

Subassembly::Subassembly(const Subassembly& whole, const Members& members)
    : Subassembly(closed(whole.options_, picked(whole.names_, members), picked(whole.parts_, members))) {
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto known = whole.on_grid_.find(members[i]);
        if (known != whole.on_grid_.end()) on_grid_.emplace(i, known->second);
    }
}

std::size_t Subassembly::add(int name, Body part) {
    const std::size_t i = parts_.size();
    names_.push_back(name);
    boxes_.push_back(part.box());
    present_.push_back(true);
    index_.add(static_cast<std::int64_t>(i), boxes_[i]);
    hull_.add(boxes_[i]);
    voxel_hull_.add(voxel_box(part));
    objects_.push_back(place(part.object));
    parts_.push_back(std::move(part));
    return i;
}

/// Without the rest of the grid: large trays are taken apart in many subassemblies.
Subassembly::Plot Subassembly::plot_around(const TraySetup& grid, const std::vector<Body>& parts) {
    VoxelBox around;
    for (const Body& part : parts) {
        around = hull(around, part.object.box());
    }
    VoxelBox all;  // of it, and perhaps a voxel more, which holds nothing
    for (int axis = 0; axis < 3; ++axis) {
        all.hi[axis] = static_cast<int>(std::ceil(grid.size[axis] / grid.voxel_size));
    }
    around = intersection(around, all);
    if (around.empty() || !grid.blocked.extent().empty()) return {grid, {}};
    Plot plot{grid, around.lo};
    for (int axis = 0; axis < 3; ++axis) {
        plot.grid.size[axis] = (around.hi[axis] - around.lo[axis]) * plot.grid.voxel_size;
    }
    return plot;
}

Subassembly Subassembly::closed(const DisassemblyOptions& options, std::vector<int> names, std::vector<Body> parts) {
    const Plot plot = plot_around(options.grid, parts);
    return {options, std::move(names), std::move(parts), plot};
}

ObjectId Subassembly::place(TrayObject object) {
    object.position = object.position - origin_;
    return tray_.add(std::move(object));
}

void Subassembly::remove(std::size_t i) {
    present_[i] = false;
    on_grid_.erase(i);
    index_.remove(static_cast<std::int64_t>(i), boxes_[i]);
    hull_.remove(i);
    voxel_hull_.remove(i);
    tray_.remove(objects_[i]);
}

Subassembly::Members Subassembly::movable() const {
    Members members;
    for (std::size_t i = 0; i < size(); ++i) {
        if (movable(i)) members.push_back(i);
    }
    return members;
}

std::optional<Subassembly::Pair> Subassembly::meeting(const Move& move, const Hints& hints,
                                                      std::vector<Pair>& passed) const {
    struct Near {
        double apart;
        Pair pair;
    };
    std::vector<Near> near;
    const AxisDirection direction = move.direction;
    for (const std::size_t member : move.members) {
        const Box box = moved(boxes_[member], move.from);
        const Box way = swept(box, direction, move.way);
        for (const std::int64_t id : index_.near(way)) {
            const auto other = static_cast<std::size_t>(id);
            if (!meet(way, boxes_[other])) continue;
            if (std::binary_search(move.members.begin(), move.members.end(), other)) continue;
            if (hints.known && hints.known->passed(member, direction, other)) continue;
            double apart = direction.sign > 0 ? boxes_[other].min[direction.axis] - box.max[direction.axis]
                                              : box.min[direction.axis] - boxes_[other].max[direction.axis];
            if (hints.first == other) apart = -Box::kInfinity;
            near.push_back({apart, {member, other}});
        }
    }
    // The nearest first: it is the likeliest to be in the way, and asked before threads share the others.
    std::stable_sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.apart < b.apart; });
    const auto meets = [&](const Pair& pair) {
        const Body &moving = parts_[pair.member], &still = parts_[pair.other];
        const Vec3 offset = moving.offset + move.from - still.offset;
        return !slides_past(*moving.surface, offset, *still.surface, direction, kGraze, move.way);
    };
    std::size_t met = 0;
    if (!near.empty() && !meets(near.front().pair)) {
        const std::span<const Near> others = std::span(near).subspan(1);
        met = 1 + static_cast<std::size_t>(options_.workers.first(std::ssize(others), [&](std::int64_t k) {
                  return meets(others[static_cast<std::size_t>(k)].pair);
              }));
    }
    for (std::size_t k = 0; k < met; ++k) {
        passed.push_back(near[k].pair);
    }
    if (met < near.size()) return near[met].pair;
    return std::nullopt;
}

Box Subassembly::box_of(const Members& members) const {
    Box box;
    for (const std::size_t member : members) {
        box.add(boxes_[member]);
    }
    return box;
}

Subassembly::Straight Subassembly::straight_way(const Members& members, const Vec3& from, AxisDirection direction,
                                                const Hints& hints) const {
    const Box others = hull_.without(members);
    if (others.empty()) return {};
    const Box own = moved(box_of(members), from);
    const double way = std::max(way_past(own, others, direction), 0.0) + kClearance;
    Straight straight;
    straight.met = meeting({members, from, direction, way}, hints, straight.passed);
    if (!straight.met) straight.path = {along(direction, way)};
    return straight;
}

Subassembly::Straight Subassembly::straight_way(const Members& members, AxisDirection direction,
                                                const BlockingGraph* known) const {
    return straight_way(members, Vec3{}, direction, {known, std::nullopt});
}

bool Subassembly::free_move(const Members& members, const Vec3& from, const Vec3& move) const {
    const AxisDirection direction = direction_of(move);
    std::vector<Pair> passed;
    return !meeting({members, from, direction, std::abs(move[direction.axis])}, {}, passed);
}

bool Subassembly::free_path(const Members& members, Vec3 from, const Path& path) const {
    for (const Vec3& move : path) {
        if (!free_move(members, from, move)) return false;
        from = from + move;
    }
    return true;
}

std::optional<Subassembly::Path> Subassembly::snap(std::size_t i, const Vec3& move) const {
    constexpr int kOrders[6][3] = {{2, 0, 1}, {2, 1, 0}, {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}};
    for (const auto& order : kOrders) {
        Path path;
        for (const int axis : order) {
            Vec3 leg;
            leg[axis] = move[axis];
            path.push_back(leg);
        }
        path = merged(path);
        if (free_path({i}, {}, path)) return path;
    }
    return std::nullopt;
}

/// Of a copy off the grid. They are made without the lock, since that may be done by several threads.
std::shared_ptr<const BitGrid> Subassembly::voxels_on_grid(std::size_t i) const {
    {
        const std::lock_guard lock(*asking_);
        if (const auto known = on_grid_.find(i); known != on_grid_.end()) return known->second;
    }
    std::shared_ptr<const BitGrid> made = options_.on_grid(names_[i]);
    const std::lock_guard lock(*asking_);
    return on_grid_[i] = std::move(made);
}

Subassembly::Flood Subassembly::flood(std::size_t i) const {
    const Body& part = parts_[i];
    Flood flood;
    flood.i = i;
    const Box rest = voxel_hull_.without({i});
    if (rest.empty()) return flood;
    flood.others = {voxel(rest.min) - origin_, voxel(rest.max) - origin_};
    flood.at = boxes_[i].min - inset(boxes_[i].size(), tray_.voxel_size()) - options_.corner;
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = flood.at[axis] / tray_.voxel_size();
        flood.nearest[axis] = static_cast<int>(std::lround(voxels));
        flood.on_grid = flood.on_grid && std::abs(voxels - flood.nearest[axis]) <= kOnGrid;
    }
    flood.solid = flood.on_grid ? part.object.solid : voxels_on_grid(i);
    const std::lock_guard lock(*asking_);
    flood.tiles = options_.search->free_tiles(tray_, flood.solid, {objects_[i], 1});
    return flood;
}

Subassembly::Flooded Subassembly::way_out(Flood& flood) const {
    if (!flood.tiles) return {Path{}};
    const auto& [i, solid, at, nearest, on_grid, others, tiles] = flood;
    const double dx = tray_.voxel_size();
    ReachableRegion region(*tiles, solid->extent(), others, options_.stop);

    // Where to start: on the grid where it stands; off it, at free positions near by.
    struct Start {
        double away;
        VoxelIndex position;
    };
    std::vector<Start> starts;
    if (on_grid && region.free(nearest - origin_)) {
        starts.push_back({0, nearest});
    } else {
        const VoxelIndex reach{kSnapReach, kSnapReach, kSnapReach};
        const VoxelIndex around = nearest - origin_;
        region.look_around({around - reach, around + reach + VoxelIndex{1, 1, 1}});
        for (int z = -kSnapReach; z <= kSnapReach; ++z) {
            for (int y = -kSnapReach; y <= kSnapReach; ++y) {
                for (int x = -kSnapReach; x <= kSnapReach; ++x) {
                    const VoxelIndex position = nearest + VoxelIndex{x, y, z};
                    if (!region.free(position - origin_)) continue;
                    const Vec3 there{position.x * dx, position.y * dx, position.z * dx};
                    starts.push_back({length(there - at), position});
                }
            }
        }
        std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.away < b.away; });
    }
    int snaps = 0;
    for (const Start& start : starts) {
        if (!region.free(start.position - origin_)) continue;  // in a closed region found closed
        if (start.away > 0 && ++snaps > kSnaps) break;
        if (!region.contains(start.position - origin_)) continue;
        // Sweeps take longer than walks, which never come to the same place twice: so only from where there is a way.
        Path path;
        if (start.away > 0) {
            const Vec3 there{start.position.x * dx, start.position.y * dx, start.position.z * dx};
            std::optional<Path> there_by = snap(i, there - at);
            if (!there_by) continue;
            path = std::move(*there_by);
        }
        const std::vector<VoxelIndex> way = FloodFill(region, options_.stop).way_out(start.position - origin_);
        if (way.empty()) break;  // stopped
        for (std::size_t k = 1; k < way.size(); ++k) {
            const VoxelIndex d = way[k] - way[k - 1];
            path.push_back({d.x * dx, d.y * dx, d.z * dx});
        }
        if (std::optional<Path> out = out_along(i, merged(path))) {
            const auto free = [this, one = flood.i](const Vec3& from, const Vec3& move) {
                return free_move({one}, from, move);
            };
            return {shortened(std::move(*out), free)};
        }
        // Voxels and meshes disagree, which only rounding can make them do. Whoever leaves may change that.
        return {std::nullopt, ClosedRegion({others.lo + origin_, others.hi + origin_}), true};
    }
    // Positions that were found taken, or that sweeps led by.
    constexpr int kSwept = kSnapReach + 1;
    VoxelBox asked{nearest - VoxelIndex{kSwept, kSwept, kSwept},
                   nearest + VoxelIndex{kSwept + 1, kSwept + 1, kSwept + 1}};
    if (VoxelBox walked = region.visited_box(); !walked.empty()) {
        walked = {walked.lo + origin_ - VoxelIndex{1, 1, 1}, walked.hi + origin_ + VoxelIndex{1, 1, 1}};
        asked = hull(asked, walked);
    }
    return {std::nullopt, ClosedRegion(*solid, asked), !starts.empty()};
}

std::optional<Subassembly::Path> Subassembly::any_way_out(std::size_t i) const {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        Straight straight = straight_way({i}, BlockingGraph::direction(d));
        if (!straight.met) return std::move(straight.path);
    }
    Flood last = flood(i);
    return way_out(last).path;
}

std::optional<Subassembly::Path> Subassembly::way_beside_the_grid(std::size_t i) const {
    std::array<Hints, BlockingGraph::kDirections> hints;  // who was in the way from elsewhere, likely is from here
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        const AxisDirection first = BlockingGraph::direction(d);
        const Vec3 aside = along(first, tray_.voxel_size());
        if (!free_move({i}, {}, aside)) continue;
        for (int on = 0; on < BlockingGraph::kDirections; ++on) {
            const AxisDirection direction = BlockingGraph::direction(on);
            if (direction.axis == first.axis) continue;
            const Straight way = straight_way({i}, aside, direction, hints[on]);
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

bool Subassembly::leads_out(const Members& members, const Path& path) const {
    const Box others = hull_.without(members);
    if (others.empty()) return true;
    const bool along_axes = std::ranges::all_of(path, [](const Vec3& move) {
        const AxisDirection direction = direction_of(move);
        return along(direction, std::abs(move[direction.axis])) == move;
    });
    return along_axes && !meet(at_end(box_of(members), path), others) && free_path(members, {}, path);
}

std::optional<Subassembly::Path> Subassembly::out_along(std::size_t i, const Path& path) const {
    Path gone;
    Vec3 from;
    std::array<Hints, BlockingGraph::kDirections> hints;  // who was in the way the last time, likely still is
    for (const Vec3& move : path) {
        if (!free_move({i}, from, move)) return std::nullopt;
        from = from + move;
        gone.push_back(move);
        // From the end it goes on by the clearance.
        const bool end = gone.size() == path.size();
        for (int d = 0; d < BlockingGraph::kDirections; ++d) {
            const AxisDirection direction = BlockingGraph::direction(d);
            const AxisDirection last = direction_of(move);
            if (end && (direction.axis != last.axis || direction.sign != last.sign)) continue;
            const Straight way = straight_way({i}, from, direction, hints[d]);
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

}  // namespace spectralpack
