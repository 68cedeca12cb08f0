#include "packing/tray_filler.hpp"

#include <memory>
#include <utility>

#include "packing/reachable_search.hpp"

namespace spectralpack {
namespace {

// Section 3.2: moves of at most two voxels along an axis, three rounds of x, y and z.
constexpr double kLongestMove = 2;
constexpr int kRefineRounds = 3;

/// Adds its refinement's seconds to a sum, also when an exception ends the packing.
class TimedRefinement {
  public:
    TimedRefinement(std::unique_ptr<Refinement> refinement, double& seconds)
        : refinement_(std::move(refinement)), seconds_(seconds) {}
    ~TimedRefinement() {
        if (refinement_) seconds_ += refinement_->seconds();
    }
    TimedRefinement(const TimedRefinement&) = delete;
    TimedRefinement& operator=(const TimedRefinement&) = delete;

    Refinement* get() const { return refinement_.get(); }

  private:
    std::unique_ptr<Refinement> refinement_;
    double& seconds_;
};

}  // namespace

TrayFiller::TrayFiller(FillSetup setup, PlacementSearch& search, Refinement::PartOf part_of,
                       const Workers& workers)
    : setup_(std::move(setup)), search_(search), part_of_(std::move(part_of)), workers_(workers) {}

void TrayFiller::fill(const std::vector<PackItem>& items, const MakeShapeStore& make_shapes,
                      const ItemDone& item_done, const StopToken& stop, FilledTray& result) {
    Tray tray(setup_.tray);
    {
        ShapeStore shapes = make_shapes(items);
        fill(tray, items, shapes, item_done, stop, result);
    }
    if (setup_.interlock != Interlock::off) make_removable(tray, make_shapes, stop, result);
}

void TrayFiller::fill(Tray& tray, const std::vector<PackItem>& items, ShapeStore& shapes,
                      const ItemDone& item_done, const StopToken& stop, GreedyResult& result) {
    const double dx = setup_.tray.voxel_size;
    std::unique_ptr<Refinement> made;
    if (setup_.refine) {
        made = std::make_unique<Refinement>(
            RefineSetup{setup_.container, setup_.wall_gap, kLongestMove * dx, kRefineRounds},
            setup_.orientations, dx, part_of_, workers_);
    }
    const TimedRefinement refinement(std::move(made), refine_seconds_);
    const Settle settle = [&](const PackItem& item, const Shape& shape, const BestPlacement& best) {
        return refinement.get() ? refinement.get()->settle(item, shape, best)
                                : stand_on_grid(shape, best, dx, setup_.wall_gap);
    };
    ReachableSearch reachable(search_);
    PlacementSearch& search =
        setup_.interlock == Interlock::place ? static_cast<PlacementSearch&>(reachable) : search_;
    pack_greedily(tray, search, setup_.model, items, shapes, settle, item_done, stop, result);
}

void TrayFiller::make_removable(Tray& tray, const MakeShapeStore& make_shapes, const StopToken& stop,
                                FilledTray& result) {
    InterlockSetup setup;
    setup.voxel_size = setup_.tray.voxel_size;
    setup.wall_gap = setup_.wall_gap;
    setup.model = setup_.model;
    setup.orientations = setup_.orientations;
    setup.mesh_of = [this](int part) { return part_of_(part).mesh; };
    setup.make_shapes = make_shapes;
    setup.left = setup_.left;
    setup.workers = workers_;
    Untangled untangled = untangle(tray, search_, result.placed, setup, stop);
    result.plan = std::move(untangled.plan);
    result.interlocked = std::move(untangled.interlocked);
    result.report = untangled.report;
    untangle_seconds_ += result.report.disassemble_seconds + result.report.reinsert_seconds;
}

}  // namespace spectralpack
