#pragma once
/// Continuous refinement (section 3.2) as a step of packing: each copy slides off the grid towards its neighbours,
/// and the tray then holds the voxels of the mesh where it really stands.

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/parallel.hpp"
#include "packing/standing.hpp"
#include "refine/refiner.hpp"

namespace spectralpack {

/// The scaled mesh (mm, not turned) of a part, and what else packing needs of it.
struct RefinedPart {
    Mesh mesh;
    double gap = 0;
    const std::vector<Mat3>* orientations = nullptr;  ///< its set
    double volume = 0;                                ///< signed, mm^3
};

/// Whether a copy of the part may stand in an orientation with its turned mesh moved by `offset`.
using MayStand = std::function<bool(int part, int orientation, const Vec3& offset)>;

class Refinement {
  public:
    using PartOf = std::function<RefinedPart(int part)>;

    /// One per tray, which starts empty; `voxel_size` in mm and `detail` are the tray's. A copy stays on the grid where
    /// it may not stand refined.
    Refinement(const RefineSetup& setup, double voxel_size, int detail, PartOf part_of, MayStand may_stand,
               const Workers& workers);

    /// What already stands in the tray: a fixed copy, a wall.
    void stand(StandingCopy obstacle) { refiner_.add(std::move(obstacle)); }

    Standing settle(const PackItem& item, const Shape& shape, const BestPlacement& best);

    /// Least distance between the meshes of two copies, mm; none with fewer than two.
    std::optional<double> least_gap() const;

    double seconds() const { return seconds_; }  ///< spent in settle(), for the record

  private:
    /// A part in one orientation.
    struct Turned {
        Mesh mesh;
        std::shared_ptr<const Bvh> surface;
    };

    const Turned& turned(int part, int orientation);

    RefineSetup setup_;
    double voxel_size_;
    int detail_;
    PartOf part_of_;
    MayStand may_stand_;
    Workers workers_;
    Refiner refiner_;
    int part_ = -1;  // what the next three are of: copies of a part mostly come one after the other
    RefinedPart current_;
    std::unique_ptr<Bvh> surface_;
    std::map<int, Turned> turned_;
    double seconds_ = 0;
};

}  // namespace spectralpack
