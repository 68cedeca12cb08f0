#include "packing/off_grid/off_grid.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

/// Vertices turned to learn a part's boxes: of many orientations of a large mesh the first that come to so many.
constexpr double kMostTurned = 2e7;

bool same_size(const Vec3& a, const Vec3& b) {
    return std::abs(a.x - b.x) <= kSameSize && std::abs(a.y - b.y) <= kSameSize && std::abs(a.z - b.z) <= kSameSize;
}

Box box_of_turned(const Mesh& mesh, const Mat3& turn) {
    Box box;
    for (const Vec3& vertex : mesh.vertices) {
        box.add(turn * vertex);
    }
    return box;
}

}  // namespace

OffGrid::OffGrid(const Container& container, double wall_gap, Tray& tray, const TrayContext& context,
                 Refinement& refinement, PartSurfaces& surfaces)
    : container_(container),
      wall_gap_(wall_gap),
      tray_(tray),
      context_(context),
      refinement_(refinement),
      surfaces_(surfaces),
      has_mesh_walls_(
          container.mesh ||
          std::ranges::any_of(container.keep_out, [](const KeepOut& keep_out) { return keep_out.mesh.has_value(); })),
      room_(room_at_start()) {}

const std::vector<TurnedBox>& OffGrid::boxes_of(int part) {
    const auto [entry, fresh] = boxes_.try_emplace(part);
    std::vector<TurnedBox>& boxes = entry->second;
    if (!fresh) return boxes;
    const ScaledPart scaled = surfaces_.part(part);
    const double most = kMostTurned / static_cast<double>(std::max<std::size_t>(1, scaled.mesh->vertices.size()));
    for (std::size_t i = 0; i < scaled.orientations->size() && (i == 0 || static_cast<double>(i) < most); ++i) {
        const Box box = box_of_turned(*scaled.mesh, (*scaled.orientations)[i]);
        const bool seen =
            std::ranges::any_of(boxes, [&](const TurnedBox& other) { return same_size(other.box.size(), box.size()); });
        if (!seen) boxes.push_back({static_cast<int>(i), box});
    }
    return boxes;
}

BoxRoom OffGrid::room_at_start() const {
    const Vec3 walls{wall_gap_, wall_gap_, wall_gap_};
    BoxRoom room({walls, container_.size - walls});
    for (const PlacedSurface& standing : refinement_.from_start()) {
        if (!standing.wall) room.add({standing.box(), standing.gap});
    }
    for (const KeepOut& keep_out : container_.keep_out) {
        if (!keep_out.mesh) room.add({keep_out.box, wall_gap_, true});
    }
    return room;
}

void OffGrid::follow(const std::vector<PlacedCopy>& placed) {
    for (; followed_ < placed.size(); ++followed_) {
        const PlacedCopy& copy = placed[followed_];
        const Box& box = surfaces_.at(copy.copy.part, copy.orientation)->box();
        room_.add({{box.min + copy.offset, box.max + copy.offset}, surfaces_.part(copy.copy.part).gap});
    }
}

bool OffGrid::is_hopeless(const Vec3& size, double gap) const {
    return std::ranges::any_of(refused_, [&](const Refused& refused) {
        return gap >= refused.gap && size.x >= refused.size.x && size.y >= refused.size.y && size.z >= refused.size.z;
    });
}

bool OffGrid::may_stand(int part, const TurnedBox& turned, const Vec3& corner) const {
    const Caps* caps = context_.limits.caps;
    if (caps && !caps->may_stand(part, turned.orientation, corner - turned.box.min)) return false;
    if (!has_mesh_walls_) return true;
    // What a box does not tell: voxels that are wholly free do.
    const Vec3 walls{wall_gap_, wall_gap_, wall_gap_};
    const StandingVoxels voxels = voxelize_at(surfaces_.turned_mesh(part, turned.orientation), corner - walls,
                                              tray_.voxel_size(), context_.workers);
    return !intersects(tray_.blocked(), voxels.solid, voxels.position);
}

bool OffGrid::put(const Copy& copy, std::vector<PlacedCopy>& placed) {
    const Caps* caps = context_.limits.caps;
    if (caps && !caps->why_not(copy.part).empty()) return false;
    follow(placed);
    const double gap = surfaces_.part(copy.part).gap;
    const TurnedBox* best = nullptr;
    Vec3 best_corner;
    const auto rank = [](const TurnedBox& turned, const Vec3& corner) {
        return std::tuple(corner.z + turned.box.size().z, corner.z, corner.y, corner.x);
    };
    for (const TurnedBox& turned : boxes_of(copy.part)) {
        const Vec3 size = turned.box.size();
        if (is_hopeless(size, gap)) continue;
        const std::optional<Vec3> corner =
            room_.lowest(size, gap, [&](const Vec3& at) { return may_stand(copy.part, turned, at); });
        if (!corner) {
            if (!has_mesh_walls_ && !caps) refused_.push_back({size, gap});
        } else if (!best || rank(turned, *corner) < rank(*best, best_corner)) {
            best = &turned;
            best_corner = *corner;
        }
    }
    if (!best) return false;
    put_at(copy, *best, best_corner, placed);
    return true;
}

void OffGrid::put_at(const Copy& copy, const TurnedBox& turned, const Vec3& corner, std::vector<PlacedCopy>& placed) {
    Settled settled = refinement_.stand_at(copy, turned.orientation, corner - turned.box.min, gap_class(copy.part));
    const VoxelIndex position = settled.object.position;
    const ObjectId object = tray_.add(std::move(settled.object));
    if (Caps* caps = context_.limits.caps) caps->add(copy.part, turned.orientation, settled.offset);
    placed.push_back({copy, turned.orientation, position, settled.offset, object, {}});
}

void OffGrid::put_again(const PlacedCopy& copy, std::vector<PlacedCopy>& placed) {
    Settled settled = refinement_.stand_at(copy.copy, copy.orientation, copy.offset, gap_class(copy.copy.part));
    placed.push_back(copy);
    placed.back().object = tray_.add(std::move(settled.object));
    if (Caps* caps = context_.limits.caps) caps->add(copy.copy.part, copy.orientation, copy.offset);
}

int OffGrid::gap_class(int part) const { return tray_.gap_class_of(surfaces_.part(part).gap); }

void OffGrid::clear(std::vector<PlacedCopy>& placed) {
    for (const PlacedCopy& copy : placed) {
        if (Caps* caps = context_.limits.caps) caps->remove(copy.copy.part, copy.orientation, copy.offset);
        tray_.remove(copy.object);
    }
    placed.clear();
    refinement_.restart();
    room_ = room_at_start();
    followed_ = 0;
    refused_.clear();
}

}  // namespace spectralpack
