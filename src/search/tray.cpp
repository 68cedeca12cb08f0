#include "search/tray.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

#include "spectralpack/error.hpp"
#include "voxel/voxelize.hpp"
#include "voxel/widen.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 40;
// A container that is a whole number of voxels long up to rounding has exactly that many.
constexpr double kWholeVoxel = 1e-9;

bool overlap(const TrayObject& a, const TrayObject& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.position[axis] >= b.position[axis] + b.solid->extent()[axis] ||
            b.position[axis] >= a.position[axis] + a.solid->extent()[axis]) {
            return false;
        }
    }
    return true;
}

}  // namespace

TrayObject fine_object(std::shared_ptr<const BitGrid> fine, const VoxelIndex& fine_position, int detail,
                       int gap_class) {
    if (detail == 1) return {fine, fine_position, gap_class, false, fine, fine_position};
    CoarseVoxels reached = reached_voxels(*fine, fine_position, detail);
    return {std::make_shared<const BitGrid>(std::move(reached.voxels)),
            reached.offset,
            gap_class,
            false,
            std::move(fine),
            fine_position};
}

TraySetup finest_setup(TraySetup setup) {
    setup.voxel_size /= setup.detail;
    setup.detail = 1;
    setup.reference_layers = 0;
    setup.blocked = {};
    return setup;
}

TrayObject on_finest(TrayObject object) {
    if (!object.fine) return object;
    object.solid = std::move(object.fine);
    object.position = object.fine_position;
    object.fine = nullptr;
    return object;
}

TrayIdentity::TrayIdentity() {
    static std::atomic<std::uint64_t> counter{0};  // an identity: nothing depends on its value
    value_ = std::make_shared<const std::uint64_t>(++counter);
}

Tray::Tray(TraySetup setup) : setup_(std::move(setup)) {
    const double dx = setup_.voxel_size;
    if (!(dx > 0) || !std::isfinite(dx)) throw UsageError("the voxel size must be a positive length");
    if (setup_.detail < 1) throw InternalError("a tray's detail must be 1 or more");
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = setup_.size[axis] / dx;
        if (!std::isfinite(voxels) || voxels < 1 - kWholeVoxel) {
            throw UsageError("the tray, less the wall gap, is smaller than one voxel");
        }
        if (voxels > 1e9) throw ResourceError("the tray has over a billion voxels along one axis");
        extent_[axis] = std::max(1, static_cast<int>(std::ceil(voxels - kWholeVoxel)));
    }
    if (extent_.count() > kMaxVoxels) throw ResourceError("the tray has more than 2^40 voxels");
    if (!setup_.blocked.extent().empty() && !(setup_.blocked.extent() == extent_)) {
        throw InternalError("the container mask does not have the grid's extent");
    }
    const std::vector<double>& gaps = setup_.gap_classes;
    if (gaps.empty() || std::ranges::adjacent_find(gaps, std::greater_equal<>{}) != gaps.end()) {
        throw InternalError("a tray's gap classes must be ascending, and at least one");
    }
    reference_layers_ = setup_.reference_layers > 0 ? setup_.reference_layers : extent_.z;
    const auto make = [&](std::vector<BitGrid>& grids, std::size_t count) {
        grids.reserve(count);  // one more on the way would be as large as a tray
        while (grids.size() < count) {
            grids.emplace_back(extent_);
        }
    };
    make(occupied_, gaps.size());
    if (setup_.detail > 1) make(parts_, gaps.size() * static_cast<std::size_t>(part_count(setup_.detail)));
}

Extent Tray::candidates(const Vec3& reach) const {
    Extent count;
    for (int axis = 0; axis < 3; ++axis) {
        const double room = setup_.size[axis] + kContainTolerance - reach[axis];
        if (!(room >= 0)) return {};
        count[axis] = static_cast<int>(std::floor(room / setup_.voxel_size)) + 1;
        // The tolerance must not push voxels over the edge of the grid.
        const int fine = voxels_along(reach[axis], setup_.voxel_size / setup_.detail);
        const int voxels = (fine + setup_.detail - 1) / setup_.detail;
        count[axis] = std::min(count[axis], extent_[axis] - voxels + 1);
        if (count[axis] <= 0) return {};
    }
    return count;
}

bool Tray::excludes(int gap_class) const {
    const auto alone = [&](int c) {
        return holds_one_only(setup_.size, setup_.gap_classes[static_cast<std::size_t>(c)]);
    };
    if (setup_.ceiling == Ceiling::open || !alone(gap_classes() - 1)) return false;
    return std::ranges::any_of(objects_, [&](const Entry& entry) {
        return entry.present && alone(std::max(gap_class, entry.object.gap_class));
    });
}

BitGrid Tray::omega_place() const {
    BitGrid all = omega_move();
    if (!blocked().extent().empty()) unite(all, blocked(), {});
    return all;
}

BitGrid Tray::omega_move(const VoxelBox& box, std::optional<ObjectId> without) const {
    BitGrid all({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
    const VoxelIndex corner = VoxelIndex{} - box.lo;
    for (const BitGrid& occupied : occupied_) {
        unite(all, occupied, corner);
    }
    if (without) {
        const TrayObject& out = object(*without);
        subtract(all, *out.solid, out.position + corner);
        for (const Entry& entry : objects_) {
            if (entry.present && &entry.object != &out && overlap(entry.object, out)) {
                unite(all, *entry.object.solid, entry.object.position + corner);
            }
        }
    }
    if (setup_.blocked_is_physical && !blocked().extent().empty()) unite(all, blocked(), corner);
    return all;
}

void Tray::unite_parts(const TrayObject& object) {
    if (setup_.detail == 1) return;
    const SplitVoxels fine = split(*object.fine, object.fine_position, setup_.detail);
    for (std::size_t p = 0; p < fine.parts.size(); ++p) {
        unite(parts_[static_cast<std::size_t>(object.gap_class) * fine.parts.size() + p], fine.parts[p], fine.offset);
    }
}

ObjectId Tray::add(TrayObject object) {
    if (object.gap_class < 0 || object.gap_class >= gap_classes()) {
        throw InternalError("an object has a gap class that the tray does not have");
    }
    if (setup_.detail > 1 && !object.fine) throw InternalError("an object has no fine voxels");
    const ObjectId id = object_count();
    unite(occupied_[static_cast<std::size_t>(object.gap_class)], *object.solid, object.position);
    unite_parts(object);
    objects_.push_back({std::move(object), true});
    changes_.push_back({version() + 1, id, true});
    return id;
}

void Tray::remove(ObjectId id) {
    if (!find(id)) throw InternalError("an object was removed that is not in the tray");
    Entry& gone = objects_[static_cast<std::size_t>(id)];
    gone.present = false;
    BitGrid& occupied = occupied_[static_cast<std::size_t>(gone.object.gap_class)];
    subtract(occupied, *gone.object.solid, gone.object.position);
    if (setup_.detail > 1) {
        const SplitVoxels fine = split(*gone.object.fine, gone.object.fine_position, setup_.detail);
        for (std::size_t p = 0; p < fine.parts.size(); ++p) {
            subtract(parts_[static_cast<std::size_t>(gone.object.gap_class) * fine.parts.size() + p], fine.parts[p],
                     fine.offset);
        }
    }
    for (const Entry& entry : objects_) {
        if (entry.present && entry.object.gap_class == gone.object.gap_class && overlap(entry.object, gone.object)) {
            unite(occupied, *entry.object.solid, entry.object.position);
            unite_parts(entry.object);
        }
    }
    changes_.push_back({version() + 1, id, false});
}

const TrayObject* Tray::find(ObjectId id) const {
    if (id < 0 || id >= object_count()) return nullptr;
    const Entry& entry = objects_[static_cast<std::size_t>(id)];
    return entry.present ? &entry.object : nullptr;
}

}  // namespace spectralpack
