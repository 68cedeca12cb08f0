#include "disassembly/subassembly.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "disassembly/ways/moves.hpp"
#include "geometry/slides_past.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

// A copy this near to the grid, in voxels, is on it: voxelize_at() sees it so.
constexpr double kOnGrid = kSurfaceShrink;

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
    struct Candidate {
        double distance;
        Pair pair;
    };
    std::vector<Candidate> candidates;
    const AxisDirection direction = move.direction;
    for (const std::size_t member : move.members) {
        const Box box = moved(boxes_[member], move.from);
        const Box way = swept(box, direction, move.way);
        for (const std::int64_t id : index_.near(way)) {
            const auto other = static_cast<std::size_t>(id);
            if (!meet(way, boxes_[other])) continue;
            if (other == aside_ || std::binary_search(move.members.begin(), move.members.end(), other)) continue;
            if (hints.known && hints.known->passed(member, direction, other)) continue;
            double distance = direction.sign > 0 ? boxes_[other].min[direction.axis] - box.max[direction.axis]
                                                 : box.min[direction.axis] - boxes_[other].max[direction.axis];
            if (hints.first == other) distance = -Box::kInfinity;
            candidates.push_back({distance, {member, other}});
        }
    }
    // The nearest first: it is the likeliest to be in the way, and asked before threads share the others.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    const auto meets = [&](const Pair& pair) {
        const Body &moving = parts_[pair.member], &still = parts_[pair.other];
        const Vec3 offset = moving.offset + move.from - still.offset;
        return !slides_past(*moving.surface, offset, *still.surface, direction, kGraze, move.way);
    };
    std::size_t met = 0;
    if (!candidates.empty() && !meets(candidates.front().pair)) {
        const std::span<const Candidate> others = std::span(candidates).subspan(1);
        met = 1 + static_cast<std::size_t>(options_.workers.first(std::ssize(others), [&](std::int64_t k) {
                  return meets(others[static_cast<std::size_t>(k)].pair);
              }));
    }
    for (std::size_t k = 0; k < met; ++k) {
        passed.push_back(candidates[k].pair);
    }
    if (met < candidates.size()) return candidates[met].pair;
    return std::nullopt;
}

Box Subassembly::box_of(const Members& members) const {
    Box box;
    for (const std::size_t member : members) {
        box.add(boxes_[member]);
    }
    return box;
}

Box Subassembly::box_of_others(const Members& members) const {
    if (!aside_) return hull_.without(members);
    Members gone = members;
    gone.insert(std::upper_bound(gone.begin(), gone.end(), *aside_), *aside_);
    return hull_.without(gone);
}

Subassembly::Straight Subassembly::straight_way(const Members& members, const Vec3& from, AxisDirection direction,
                                                const Hints& hints) const {
    const Box others = box_of_others(members);
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
    flood.origin = origin_;
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

bool Subassembly::leads_out(const Members& members, const Path& path) const {
    const Box others = box_of_others(members);
    if (others.empty()) return true;
    const bool along_axes = std::ranges::all_of(path, [](const Vec3& move) {
        const AxisDirection direction = direction_of(move);
        return along(direction, std::abs(move[direction.axis])) == move;
    });
    return along_axes && !meet(at_end(box_of(members), path), others) && free_path(members, {}, path);
}

}  // namespace spectralpack
