#include "packing/tray_filler.hpp"

#include <algorithm>
#include <memory>
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

void TrayFiller::stand_fixed(int number, Tray& tray, Refinement* refinement) const {
    const Vec3 corner{setup_.wall_gap, setup_.wall_gap, setup_.wall_gap};
    const std::vector<double>& gaps = setup_.tray.gap_classes;
    const int detail = setup_.tray.detail;
    for (const FixedCopy& copy : setup_.fixed) {
        if (copy.tray != number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        StandingVoxels voxels = voxelize_at(mesh, bounding_box(mesh).min - corner,
                                            setup_.tray.voxel_size / detail, workers_);
        const auto gap_class = std::lower_bound(gaps.begin(), gaps.end(), copy.gap) - gaps.begin();
        TrayObject object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position,
                                        detail, static_cast<int>(gap_class));
        object.fixed = true;
        tray.add(std::move(object));
        if (refinement) refinement->stand({std::make_shared<const Bvh>(mesh), {}, copy.gap});
    }
}

template <class Pack>
void TrayFiller::fill_one(int number, const Pack& pack) {
    Tray tray(setup_.tray);
    const double dx = setup_.tray.voxel_size;
    const int detail = setup_.tray.detail;
    std::optional<Caps> caps;
    if (setup_.max_density || setup_.max_layer_fill) {
        caps.emplace(CapSetup{setup_.max_density, setup_.max_layer_fill, setup_.container.size,
                              setup_.wall_gap, dx},
                     CapParts{[&](int part) { return part_of_(part).volume; },
                              [&](int part, int orientation) {
                                  const RefinedPart wanted = part_of_(part);
                                  const auto i = static_cast<std::size_t>(orientation);
                                  return transformed(wanted.mesh, {(*wanted.orientations)[i], {}});
                              }});
    }
    std::unique_ptr<Refinement> refinement;
    if (setup_.refine) {
        refinement = std::make_unique<Refinement>(
            RefineSetup{setup_.container.size, setup_.wall_gap, kLongestMove * dx, kRefineRounds}, dx, detail,
            part_of_,
            [&](int part, int orientation, const Vec3& offset) {
                return !caps || caps->may_stand(part, orientation, offset);
            },
            workers_);
    }
    if (refinement) {
        for (const StandingCopy& wall : walls_) {
            refinement->stand(wall);
        }
    }
    stand_fixed(number, tray, refinement.get());
    double refining = 0;
    const Settle settle = [&](const PackItem& item, const Shape& shape, const BestPlacement& best) {
        if (!refinement) return stand_on_grid(shape, best, dx, detail, setup_.wall_gap);
        Standing standing = refinement->settle(item, shape, best);
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
        return standing;
    };
    pack(tray, settle, GreedyLimits{caps ? &*caps : nullptr, setup_.most_layers});
    if (refinement) {
        if (const auto gap = refinement->least_gap()) least_gap_ = std::min(*gap, least_gap_.value_or(*gap));
    }
    // Here the tray is full and holds what the result names (by ObjectId): the place for what looks at a whole
    // tray, such as disassembly.
}

void TrayFiller::fill(int number, const std::vector<PackItem>& items, ShapeStore& shapes, const ItemDone& item_done,
                      const StopToken& stop, GreedyResult& result) {
    shapes.start_tray(items);
    fill_one(number, [&](Tray& tray, const Settle& settle, const GreedyLimits& limits) {
        pack_greedily(tray, search_, setup_.model, items, shapes, settle, item_done, stop, result, limits);
    });
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, ShapeStore& shapes, const ItemDone& item_done,
                                const StopToken& stop, GreedyResult& result) {
    std::vector<PackItem> items;
    for (const PartShare& share : shares) {
        items.push_back({share.part, 0});
    }
    shapes.start_tray(items);
    fill_one(0, [&](Tray& tray, const Settle& settle, const GreedyLimits& limits) {
        pack_in_shares(tray, search_, setup_.model, shares, shapes, settle, item_done, stop, result, limits);
    });
}

}  // namespace spectralpack
