#include "packing/tray_filler.hpp"

#include <algorithm>
#include <utility>

#include "packing/walls.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

// Section 3.2: moves of at most two voxels along an axis, three rounds of x, y and z.
constexpr double kLongestMove = 2;
constexpr int kRefineRounds = 3;

}  // namespace

TrayFiller::TrayFiller(FillSetup setup, PlacementSearch& search, Refinement::PartOf part_of,
                       const Workers& workers)
    : setup_(std::move(setup)), search_(search), part_of_(std::move(part_of)), workers_(workers) {
    if (setup_.refine) walls_ = wall_surfaces(setup_.container, setup_.wall_gap);
    for (const FixedCopy& copy : setup_.fixed) {
        trays_with_fixed_ = std::max(trays_with_fixed_, copy.tray + 1);
    }
}

void TrayFiller::fill(int number, const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
                      const StopToken& stop, GreedyResult& result) {
    Tray tray(setup_.tray);
    const std::unique_ptr<Refinement> refinement = this->refinement();
    stand_fixed(number, tray, refinement.get());
    double refining = 0;
    const Settle settle = [&](const PackItem& item, const Shape& shape, const BestPlacement& best) {
        if (!refinement) return stand_on_grid(shape, best, setup_.tray.voxel_size, setup_.wall_gap);
        Standing standing = refinement->settle(item, shape, best);
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
        return standing;
    };
    shapes.start_tray(items);
    pack_greedily(tray, search_, setup_.model, items, shapes, settle, item_done, stop, result);
    // Here the tray is full and holds what result.placed names (by ObjectId): the place for what looks at a whole
    // tray, such as disassembly.
}

std::unique_ptr<Refinement> TrayFiller::refinement() const {
    if (!setup_.refine) return nullptr;
    const double dx = setup_.tray.voxel_size;
    auto refinement = std::make_unique<Refinement>(
        RefineSetup{setup_.container.size, setup_.wall_gap, kLongestMove * dx, kRefineRounds}, setup_.orientations,
        dx, part_of_, workers_);
    for (const StandingCopy& wall : walls_) {
        refinement->stand(wall);
    }
    return refinement;
}

void TrayFiller::stand_fixed(int number, Tray& tray, Refinement* refinement) const {
    const Vec3 corner{setup_.wall_gap, setup_.wall_gap, setup_.wall_gap};
    const std::vector<double>& gaps = setup_.tray.gap_classes;
    for (const FixedCopy& copy : setup_.fixed) {
        if (copy.tray != number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        StandingVoxels voxels =
            voxelize_at(mesh, bounding_box(mesh).min - corner, setup_.tray.voxel_size, workers_);
        const auto gap_class = std::lower_bound(gaps.begin(), gaps.end(), copy.gap) - gaps.begin();
        tray.add({std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position,
                  static_cast<int>(gap_class), true});
        if (refinement) refinement->stand({std::make_shared<const Bvh>(mesh), {}, copy.gap});
    }
}

}  // namespace spectralpack
