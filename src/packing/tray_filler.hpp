#pragma once
/// One tray from empty to done: what stands in it from the start, the greedy packing on top of that, and where each
/// copy comes to stand.

#include <vector>

#include "core/parallel.hpp"
#include "packing/greedy.hpp"
#include "packing/refinement.hpp"

namespace spectralpack {

/// What all trays of a job have in common.
struct FillSetup {
    TraySetup tray;                  ///< the container's grid; every tray starts from it
    Vec3 container;                  ///< size, mm
    double wall_gap = 0;             ///< mm
    CostModel model;
    std::vector<Mat3> orientations;  ///< the job's set
    bool refine = false;             ///< continuous refinement (section 3.2)
};

class TrayFiller {
  public:
    /// `search` outlives the filler and answers for every tray. `part_of`: the meshes that refinement moves.
    TrayFiller(FillSetup setup, PlacementSearch& search, Refinement::PartOf part_of, const Workers& workers);

    /// Fills one new tray with what finds a place of `items`, tried in this order; `shapes` holds their voxels.
    /// `result` as in pack_greedily().
    void fill(const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
              const StopToken& stop, GreedyResult& result);

    double refine_seconds() const { return refine_seconds_; }  ///< over all trays, for the record

  private:
    void fill(Tray& tray, const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
              const StopToken& stop, GreedyResult& result);

    FillSetup setup_;
    PlacementSearch& search_;
    Refinement::PartOf part_of_;
    Workers workers_;
    double refine_seconds_ = 0;
};

}  // namespace spectralpack
