#pragma once
/// One tray from empty to done: what stands in it from the start, the greedy packing on top of that, and where each
/// copy comes to stand.

#include <vector>

#include "core/parallel.hpp"
#include "model/options.hpp"
#include "packing/greedy.hpp"
#include "packing/interlocking.hpp"
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
    Interlock interlock = Interlock::off;  ///< section 4
    Disassembler::Left left;         ///< told how many copies still stand, while the tray is taken apart
};

/// The voxels of `items`, asked for in this order.
using MakeShapeStore = std::function<ShapeStore(const std::vector<PackItem>& items)>;

/// What became of one tray.
struct FilledTray : GreedyResult {
    std::vector<PackItem> interlocked;  ///< taken out again: they could not be taken out of the finished packing
    std::optional<Disassembly> plan;    ///< by index into `placed`; none where interlocking was not looked at
    InterlockReport report;
};

class TrayFiller {
  public:
    /// `search` outlives the filler and answers for every tray. `part_of`: the meshes that refinement moves.
    TrayFiller(FillSetup setup, PlacementSearch& search, Refinement::PartOf part_of, const Workers& workers);

    /// Fills one new tray with what finds a place of `items`, tried in this order. `result` as in pack_greedily(); in
    /// the end it is a packing that comes apart, unless interlocking is off.
    void fill(const std::vector<PackItem>& items, const MakeShapeStore& make_shapes, const ItemDone& item_done,
              const StopToken& stop, FilledTray& result);

    double refine_seconds() const { return refine_seconds_; }  ///< over all trays, for the record
    double untangle_seconds() const { return untangle_seconds_; }

  private:
    void fill(Tray& tray, const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
              const StopToken& stop, GreedyResult& result);
    void make_removable(Tray& tray, const MakeShapeStore& make_shapes, const StopToken& stop, FilledTray& result);

    FillSetup setup_;
    PlacementSearch& search_;
    Refinement::PartOf part_of_;
    Workers workers_;
    double refine_seconds_ = 0, untangle_seconds_ = 0;
};

}  // namespace spectralpack
