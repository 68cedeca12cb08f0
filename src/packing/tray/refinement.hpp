#pragma once
/// Continuous refinement (section 3.2) as a step of packing: each copy slides off the grid towards its neighbours,
/// and the tray then holds the voxels of the mesh where it really stands.

#include <functional>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "packing/tray/part_surfaces.hpp"
#include "packing/tray/placed_copy.hpp"
#include "refine/refiner.hpp"

namespace spectralpack {

/// Whether a copy of the part may stand in an orientation with its turned mesh moved by `offset`.
using MayStand = std::function<bool(int part, int orientation, const Vec3& offset)>;

class Refinement {
  public:
    /// One per tray, which starts empty; `voxel_size` in mm and `detail` are the tray's. A copy stays on the grid where
    /// it may not stand refined.
    Refinement(const RefineOptions& options, double voxel_size, int detail, PartSurfaces& surfaces, MayStand may_stand,
               const Workers& workers);

    /// What already stands in the tray: a fixed copy, a wall.
    void stand(PlacedSurface obstacle) {
        from_start_.push_back(obstacle);
        refiner_.add(std::move(obstacle));
    }
    const std::vector<PlacedSurface>& from_start() const { return from_start_; }

    /// Throws Stopped, and then the copy does not stand, where `stop` is requested before its surface is there.
    Settled settle(const Copy& copy, const Shape& shape, const BestPlacement& best, const StopToken& stop);

    /// The copy comes to stand with its turned mesh moved by `offset`, as it is.
    Settled stand_at(const Copy& copy, int orientation, const Vec3& offset, int gap_class);

    /// The copy stands where it does; the tray holds its voxels there already.
    void stand_still(const PlacedCopy& placed);

    /// What stood in the tray from the start is all that stands in it.
    void restart();

    /// Least distance between the meshes of two copies, mm; none with fewer than two.
    std::optional<double> least_gap() const { return refiner_.least_gap(workers_); }

    double seconds() const { return seconds_; }  ///< spent on settling copies, for the record

  private:
    void take_mesh(int part, int orientation, const StopToken& stop = {});
    Settled put(PlacedSurface standing, int gap_class);

    RefineOptions options_;
    double voxel_size_;
    int detail_;
    PartSurfaces& surfaces_;
    MayStand may_stand_;
    Workers workers_;
    Refiner refiner_;
    std::vector<PlacedSurface> from_start_;
    static constexpr TurnedPart kNone{-1, 0};

    TurnedPart last_ = kNone;  // whose mesh that is: copies of a part mostly come one after the other
    Mesh mesh_;
    bool closed_ = false;  // it is, in whatever orientation
    double seconds_ = 0;
};

}  // namespace spectralpack
