#pragma once
/// Continuous refinement (section 3.2) as a step of packing: each copy slides off the grid towards its neighbours,
/// and the tray then holds the voxels of the mesh where it really stands.

#include <map>
#include <memory>
#include <utility>

#include "core/parallel.hpp"
#include "packing/standing.hpp"
#include "refine/refiner.hpp"

namespace spectralpack {

/// The scaled mesh (mm, not turned) and gap of a part.
struct RefinedPart {
    Mesh mesh;
    double gap = 0;
};

class Refinement {
  public:
    using PartOf = std::function<RefinedPart(int part)>;

    /// One per tray, which starts empty. `orientations`: the job's set; `voxel_size` in mm.
    Refinement(const RefineSetup& setup, const std::vector<Mat3>& orientations, double voxel_size, PartOf part_of,
               const Workers& workers);

    /// What already stands in the tray: a fixed copy, a wall.
    void stand(StandingCopy obstacle) { refiner_.add(std::move(obstacle)); }

    Standing settle(const PackItem& item, const Shape& shape, const BestPlacement& best);

    double seconds() const { return seconds_; }  ///< spent in settle(), for the record

  private:
    /// A part in one orientation.
    struct Turned {
        Mesh mesh;
        std::shared_ptr<const Bvh> surface;
    };

    const Turned& turned(int part, int orientation);

    RefineSetup setup_;
    std::vector<Mat3> orientations_;
    double voxel_size_;
    PartOf part_of_;
    Workers workers_;
    Refiner refiner_;
    int part_ = -1;  // what the next three are of: copies of a part mostly come one after the other
    RefinedPart current_;
    std::unique_ptr<Bvh> surface_;
    std::map<int, Turned> turned_;
    double seconds_ = 0;
};

}  // namespace spectralpack
