#include "packing/job/tray_filler.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "packing/containers/walls.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/tray/measure.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

// Section 3.2: moves of at most two voxels along an axis, three rounds of x, y and z.
constexpr double kLongestMove = 2;
constexpr int kRefineRounds = 3;

CapSetup cap_setup(const FillSetup& setup) {
    const Container& container = setup.container;
    CapSetup caps;
    caps.density = setup.max_density;
    caps.layer_fill = setup.max_layer_fill;
    caps.volume = volume_of(container);
    caps.base = container.size.x * container.size.y;
    if (container.mesh) caps.sections = section_areas(*container.mesh->surface, setup.tray.voxel_size);
    caps.wall_gap = setup.wall_gap;
    caps.voxel_size = setup.tray.voxel_size;
    return caps;
}

}  // namespace

TrayFiller::TrayFiller(FillSetup setup, PlacementSearch& search, PartSurfaces::PartOf part_of, const Workers& workers)
    : setup_(std::move(setup)), search_(search), unlinked_(search), part_of_(std::move(part_of)), workers_(workers) {
    if (setup_.container.physical && setup_.interlock != Interlock::off) {
        physical_ = physical_walls(setup_.container, finest_setup(setup_.tray), setup_.wall_gap, workers_);
    }
    if (setup_.refine) walls_ = wall_surfaces(setup_.container, setup_.wall_gap);
    for (const FixedCopy& copy : setup_.fixed) {
        trays_with_fixed_ = std::max(trays_with_fixed_, copy.tray + 1);
    }
}

std::vector<StandingPart> TrayFiller::stand_fixed(int number, Tray& tray, Refinement* refinement, Caps* caps) const {
    std::vector<StandingPart> standing;
    const Vec3 corner{setup_.wall_gap, setup_.wall_gap, setup_.wall_gap};
    const std::vector<double>& gaps = setup_.tray.gap_classes;
    const int detail = setup_.tray.detail;
    for (const FixedCopy& copy : setup_.fixed) {
        if (copy.tray != number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        StandingVoxels voxels =
            voxelize_at(mesh, bounding_box(mesh).min - corner, setup_.tray.voxel_size / detail, workers_);
        const auto gap_class = std::lower_bound(gaps.begin(), gaps.end(), copy.gap) - gaps.begin();
        TrayObject object = fine_object(std::make_shared<const BitGrid>(std::move(voxels.solid)), voxels.position,
                                        detail, static_cast<int>(gap_class));
        object.fixed = true;
        const ObjectId id = tray.add(std::move(object));
        const auto surface = std::make_shared<const Bvh>(mesh);
        if (refinement) refinement->stand({surface, {}, copy.gap});
        if (caps) caps->add_fixed(mesh);
        standing.push_back({surface, {}, tray.object(id)});
    }
    return standing;
}

template <class Pack>
void TrayFiller::fill_one(const TrayItems& wanted, ShapeStore& shapes, const StopToken& stop, FilledTray& result,
                          const Pack& pack) {
    Tray tray(setup_.tray);
    const double dx = setup_.tray.voxel_size;
    const int detail = setup_.tray.detail;
    PartSurfaces surfaces(part_of_, workers_);
    std::optional<Caps> caps;
    if (setup_.max_density || setup_.max_layer_fill) {
        caps.emplace(cap_setup(setup_),
                     CapParts{[&](int part) { return surfaces.part(part).volume; },
                              [&](int part, int orientation) { return surfaces.turned_mesh(part, orientation); }});
    }
    std::unique_ptr<Refinement> refinement;
    if (setup_.refine) {
        refinement = std::make_unique<Refinement>(
            RefineSetup{setup_.container.size, setup_.wall_gap, kLongestMove * dx, kRefineRounds}, dx, detail, surfaces,
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
    std::vector<StandingPart> fixed = stand_fixed(wanted.number, tray, refinement.get(), caps ? &*caps : nullptr);
    double refining = 0;
    const Settle settle = [&](const PackItem& item, const Shape& shape, const BestPlacement& best) {
        if (!refinement) return stand_on_grid(shape, best, dx, detail, setup_.wall_gap);
        Standing standing = refinement->settle(item, shape, best);
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
        return standing;
    };
    const GreedyLimits limits{caps ? &*caps : nullptr, setup_.most_layers, wanted.give_up_after};
    ReachableSearch reachable(search_, physical_ ? &*physical_ : nullptr);
    PlacementSearch& search = setup_.interlock == Interlock::place ? static_cast<PlacementSearch&>(reachable)
                              : avoids_links()                     ? static_cast<PlacementSearch&>(unlinked_)
                                                                   : search_;
    pack(tray, search, settle, limits);
    if (setup_.interlock != Interlock::off) {
        search.forget();  // planning takes memory of its own
        make_removable(wanted, tray, std::move(fixed), surfaces, shapes, limits, stop, result);
    }
    if (!refinement) return;
    const std::optional<double> gap = result.report.changed ? result.report.least_gap : refinement->least_gap();
    if (gap && *gap < least_gap_.value_or(Box::kInfinity)) least_gap_ = gap;
}

void TrayFiller::make_removable(const TrayItems& wanted, Tray& tray, std::vector<StandingPart> fixed,
                                PartSurfaces& surfaces, ShapeStore& shapes, const GreedyLimits& limits,
                                const StopToken& stop, FilledTray& result) {
    InterlockSetup setup;
    setup.voxel_size = setup_.tray.voxel_size;
    setup.wall_gap = setup_.wall_gap;
    setup.ray_spacing = setup_.ray_spacing;
    setup.model = setup_.model;
    setup.surfaces = &surfaces;
    setup.fixed = std::move(fixed);
    setup.walls = physical_ ? &*physical_ : nullptr;
    if (avoids_links()) setup.best = &unlinked_;
    setup.shapes = &shapes;
    setup.limits = limits;
    setup.take_out = setup_.take_out;
    setup.measure_gap = setup_.refine;
    setup.order = wanted.items;
    if (!wanted.next) setup.waiting = result.left_over;
    setup.waiting_had_no_room = setup_.interlock == Interlock::post;
    setup.left = setup_.left;
    setup.to_put_back = setup_.to_put_back;
    setup.workers = workers_;
    Untangled untangled = untangle(tray, search_, result.placed, setup, stop);
    result.plan = std::move(untangled.plan);
    result.interlocked = std::move(untangled.interlocked);
    result.report = untangled.report;
    untangle_seconds_ += result.report.disassemble_seconds + result.report.reinsert_seconds;
}

void TrayFiller::fill(const TrayItems& wanted, ShapeStore& shapes, const ItemDone& item_done, const StopToken& stop,
                      FilledTray& result) {
    const std::vector<PackItem>& items = wanted.items;
    shapes.start_tray(items);
    fill_one(wanted, shapes, stop, result,
             [&](Tray& tray, PlacementSearch& search, const Settle& settle, const GreedyLimits& limits) {
                 if (setup_.beam) {
                     pack_in_beam(tray, *setup_.beam, setup_.model, items, shapes, settle, item_done, stop, result,
                                  limits.most_layers);
                 } else {
                     pack_greedily(tray, search, setup_.model, items, shapes, settle, item_done, stop, result, limits);
                 }
             });
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, ShapeStore& shapes, const ItemDone& item_done,
                                const StopToken& stop, FilledTray& result) {
    std::vector<PackItem> items;
    for (const PartShare& share : shares) {
        items.push_back({share.part, 0});
    }
    shapes.start_tray(items);
    fill_one({}, shapes, stop, result,
             [&](Tray& tray, PlacementSearch& search, const Settle& settle, const GreedyLimits& limits) {
                 pack_in_shares(tray, search, setup_.model, shares, shapes, settle, item_done, stop, result, limits);
             });
    std::map<int, int> copies;  // by part: what was interlocked left gaps in their numbers
    for (PlacedItem& placed : result.placed) {
        placed.item.copy = copies[placed.item.part]++;
    }
    result.interlocked.clear();
}

}  // namespace spectralpack
