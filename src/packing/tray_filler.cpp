#include "packing/tray_filler.hpp"

#include <algorithm>
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

template <class Pack>
void TrayFiller::fill_one(const Pack& pack) {
    Tray tray(setup_.tray);
    const double dx = setup_.tray.voxel_size;
    const int detail = setup_.tray.detail;
    std::optional<Caps> caps;
    if (setup_.max_density || setup_.max_layer_fill) {
        caps.emplace(CapSetup{setup_.max_density, setup_.max_layer_fill, setup_.container, setup_.wall_gap, dx},
                     CapParts{[&](int part) { return part_of_(part).volume; },
                              [&](int part, int orientation) {
                                  const RefinedPart wanted = part_of_(part);
                                  const auto i = static_cast<std::size_t>(orientation);
                                  return transformed(wanted.mesh, {(*wanted.orientations)[i], {}});
                              }});
    }
    std::unique_ptr<Refinement> made;
    if (setup_.refine) {
        made = std::make_unique<Refinement>(
            RefineSetup{setup_.container, setup_.wall_gap, kLongestMove * dx, kRefineRounds}, dx, detail, part_of_,
            [&](int part, int orientation, const Vec3& offset) {
                return !caps || caps->may_stand(part, orientation, offset);
            },
            workers_);
    }
    const TimedRefinement refinement(std::move(made), refine_seconds_);
    const Settle settle = [&](const PackItem& item, const Shape& shape, const BestPlacement& best) {
        return refinement.get() ? refinement.get()->settle(item, shape, best)
                                : stand_on_grid(shape, best, dx, detail, setup_.wall_gap);
    };
    pack(tray, settle, GreedyLimits{caps ? &*caps : nullptr, setup_.most_layers});
    if (refinement.get()) {
        if (const auto gap = refinement.get()->least_gap()) least_gap_ = std::min(*gap, least_gap_.value_or(*gap));
    }
    // Here the tray is full and holds what the result names (by ObjectId): the place for what looks at a whole
    // tray, such as disassembly.
}

void TrayFiller::fill(const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
                      const StopToken& stop, GreedyResult& result) {
    fill_one([&](Tray& tray, const Settle& settle, const GreedyLimits& limits) {
        pack_greedily(tray, search_, setup_.model, items, shapes, settle, item_done, stop, result, limits);
    });
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, ShapeStore& shapes, const ItemDone& item_done,
                                const StopToken& stop, GreedyResult& result) {
    fill_one([&](Tray& tray, const Settle& settle, const GreedyLimits& limits) {
        pack_in_shares(tray, search_, setup_.model, shares, shapes, settle, item_done, stop, result, limits);
    });
}

}  // namespace spectralpack
