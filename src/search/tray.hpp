#pragma once
/// The state every engine searches in: one container's worth of voxels and what stands in it. The
/// tray keeps occupancy only and a list of its changes; engines keep whatever they derive from
/// it and catch up.
///
/// Two occupancies (docs/conventions.md):
///   Omega_place: objects, keep-out, everything outside the container: zeta, phi and rho.
///   Omega_move: objects and fixed copies (and the container where it is physical): free positions.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "spectralpack/geometry.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/distance_field.hpp"
#include "voxel/split.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

struct TraySetup {
    Vec3 size;                           ///< container less the wall gap on every side, mm
    double voxel_size = 2;               ///< dx, mm
    int detail = 1;                      ///< s: collisions are decided on voxels of dx / s
    std::vector<double> gap_classes{0};  ///< distinct gaps of the job's parts, ascending, mm
    Ceiling ceiling = Ceiling::closed;   ///< open: no wall above, for open height
    int reference_layers = 0;            ///< nz of equation 5; 0: the grid's own
    /// Voxels of the grid that are not wholly free: outside a mesh container, or in a keep-out. May
    /// be empty (then the box is free throughout); otherwise it has the grid's extent.
    BitGrid blocked;
    bool blocked_is_physical = false;  ///< then `blocked` is part of Omega_move too
};

using ObjectId = std::int64_t;

/// An object standing in the tray. Its voxels may be shared with others (refined placements), and
/// may overhang the grid (what overhangs is dropped).
struct TrayObject {
    std::shared_ptr<const BitGrid> solid;
    VoxelIndex position;  ///< of the solid's voxel (0,0,0)
    int gap_class = 0;
    bool fixed = false;
    /// With s > 1 the object in voxels of dx / s; `solid` is then the voxels of dx that it reaches into
    /// (fine_object()).
    std::shared_ptr<const BitGrid> fine{};
    VoxelIndex fine_position{};  ///< of the fine grid's voxel (0,0,0), in voxels of dx / s

    /// Of its solid, in voxels of dx.
    VoxelBox box() const {
        const Extent& e = solid->extent();
        return {position, position + VoxelIndex{e.x, e.y, e.z}};
    }
};

/// The object whose voxels of dx / detail are `fine` at `fine_position`.
TrayObject fine_object(std::shared_ptr<const BitGrid> fine, const VoxelIndex& fine_position, int detail, int gap_class);

/// The same tray in the voxels that collisions are decided on, dx / s. Containers and keep-outs are virtual, in
/// nobody's way: nothing is blocked in it.
TraySetup finest_setup(TraySetup setup);
/// An object of such a tray.
TrayObject on_finest(TrayObject object);

/// A change: object `id` was added or removed when the version became `version`.
struct TrayChange {
    std::uint64_t version = 0;
    ObjectId id = 0;
    bool added = true;
};

/// Which tray this is, for engines that keep what they derived from it. A copy is another tray.
class TrayIdentity {
  public:
    TrayIdentity();
    TrayIdentity(const TrayIdentity&) : TrayIdentity() {}
    TrayIdentity& operator=(const TrayIdentity&) {
        value_ = TrayIdentity().value_;
        return *this;
    }
    std::uint64_t value() const { return *value_; }
    std::weak_ptr<const void> life() const { return value_; }

  private:
    std::shared_ptr<const std::uint64_t> value_;
};

class Tray {
  public:
    /// Throws UsageError for sizes or voxel sizes that make no grid (not finite, not positive,
    /// container smaller than one voxel), ResourceError when it exceeds 2^40 voxels, and
    /// InternalError for a setup that does not fit together (gap classes not ascending or none, a
    /// mask of another extent).
    explicit Tray(TraySetup setup);

    const TraySetup& setup() const { return setup_; }
    const Extent& extent() const { return extent_; }  ///< n = ceil(size / dx)
    double voxel_size() const { return setup_.voxel_size; }
    int reference_layers() const { return reference_layers_; }
    int gap_classes() const { return static_cast<int>(setup_.gap_classes.size()); }
    /// Of a gap that is one of them.
    int gap_class_of(double gap) const {
        return static_cast<int>(std::ranges::lower_bound(setup_.gap_classes, gap) - setup_.gap_classes.begin());
    }

    /// Whether some object stands that leaves no room for one of this gap class, or would leave it none: the gap is
    /// longer than the diagonal of the tray.
    bool excludes(int gap_class) const;

    /// How many positions per axis keep a mesh that reaches so far from its voxels' corner, mm, inside the container:
    /// positions are 0 .. count - 1; an empty extent when it does not fit. The voxels then lie in the grid.
    Extent candidates(const Vec3& reach) const;

    /// Voxels of dx that objects of one gap class reach into, without walls and keep-out.
    const BitGrid& occupied(int gap_class) const { return occupied_[static_cast<std::size_t>(gap_class)]; }
    /// Part `part` of the fine voxels of one gap class's objects (voxel/split.hpp). With s = 1: occupied().
    const BitGrid& occupied_part(int gap_class, int part) const {
        return setup_.detail == 1 ? occupied(gap_class)
                                  : parts_[static_cast<std::size_t>(gap_class * part_count(setup_.detail) + part)];
    }
    int detail() const { return setup_.detail; }
    /// Container mask and keep-out inside the grid; empty grid when all is free.
    const BitGrid& blocked() const { return setup_.blocked; }
    /// Omega_place within the grid: all classes and blocked().
    BitGrid omega_place() const;
    /// Omega_move within the grid, with object `without` taken out.
    BitGrid omega_move(std::optional<ObjectId> without = std::nullopt) const {
        return omega_move(whole(extent_), without);
    }
    /// Its voxels in `box`, whose lower corner becomes the grid's.
    BitGrid omega_move(const VoxelBox& box, std::optional<ObjectId> without) const;

    /// Throws InternalError for a gap class that the tray does not have, and for an object without fine voxels where
    /// s > 1.
    ObjectId add(TrayObject object);
    /// An object that stood in another tray once and is gone: it takes the next id, and nothing else.
    void add_gone(TrayObject object) { objects_.push_back({std::move(object), false}); }
    /// Voxels that other objects hold stay. Throws InternalError where `id` is not in the tray.
    void remove(ObjectId id);
    const TrayObject* find(ObjectId id) const;  ///< null when removed or never added
    /// Present and past objects: ids are 0 .. object_count() - 1.
    ObjectId object_count() const { return static_cast<ObjectId>(objects_.size()); }
    /// The object as it was added, also when it has been removed since.
    const TrayObject& object(ObjectId id) const { return objects_[static_cast<std::size_t>(id)].object; }

    /// Distinct for every tray of the process, copies included.
    std::uint64_t instance() const { return identity_.value(); }
    /// Ends with the tray, for engines that keep what they derived from it no longer.
    std::weak_ptr<const void> life() const { return identity_.life(); }
    std::uint64_t version() const { return changes_.size(); }  ///< grows by one per change
    /// Changes in order; entry i made version i + 1.
    const std::vector<TrayChange>& changes() const { return changes_; }

  private:
    struct Entry {
        TrayObject object;
        bool present = true;
    };

    void unite_parts(const TrayObject& object);

    TraySetup setup_;
    Extent extent_;
    int reference_layers_ = 0;
    TrayIdentity identity_;
    std::vector<BitGrid> occupied_;
    std::vector<BitGrid> parts_;  // by gap class and part; none with s = 1
    std::vector<Entry> objects_;
    std::vector<TrayChange> changes_;
};

}  // namespace spectralpack
