#include "packing/tray_filler.hpp"

#include <memory>
#include <utility>

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

void TrayFiller::fill(const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
                      const StopToken& stop, GreedyResult& result) {
    Tray tray(setup_.tray);
    fill(tray, items, shapes, item_done, stop, result);
    // Here the tray is full and holds what result.placed names (by ObjectId): the place for what looks at a whole
    // tray, such as disassembly.
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
    pack_greedily(tray, search_, setup_.model, items, shapes, settle, item_done, stop, result);
}

}  // namespace spectralpack
