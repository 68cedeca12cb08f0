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

CapOptions cap_options(const FillOptions& options) {
    const Container& container = options.container;
    CapOptions caps;
    caps.density = options.max_density;
    caps.layer_fill = options.max_layer_fill;
    caps.volume = volume_of(container);
    caps.base = container.size.x * container.size.y;
    if (container.mesh) caps.sections = section_areas(*container.mesh->surface, options.tray.voxel_size);
    caps.wall_gap = options.wall_gap;
    caps.voxel_size = options.tray.voxel_size;
    return caps;
}

}  // namespace

TrayFiller::TrayFiller(FillOptions options, PlacementSearch& search, PartSurfaces::PartOf part_of,
                       const Workers& workers)
    : options_(std::move(options)),
      search_(search),
      unlinked_(search),
      part_of_(std::move(part_of)),
      workers_(workers) {
    if (options_.container.physical && options_.interlock != Interlock::off) {
        physical_ = physical_walls(options_.container, finest_setup(options_.tray), options_.wall_gap, workers_);
    }
    if (options_.refine) walls_ = wall_surfaces(options_.container, options_.wall_gap);
    for (const FixedCopy& copy : options_.fixed) {
        trays_with_fixed_ = std::max(trays_with_fixed_, copy.tray + 1);
    }
}

std::vector<Body> TrayFiller::stand_fixed(int number, Tray& tray, Refinement* refinement, Caps* caps) const {
    std::vector<Body> standing;
    const Vec3 corner{options_.wall_gap, options_.wall_gap, options_.wall_gap};
    const std::vector<double>& gaps = options_.tray.gap_classes;
    const int detail = options_.tray.detail;
    for (const FixedCopy& copy : options_.fixed) {
        if (copy.tray != number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        StandingVoxels voxels =
            voxelize_at(mesh, bounding_box(mesh).min - corner, options_.tray.voxel_size / detail, workers_);
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
void TrayFiller::fill_one(const TrayCopies& wanted, ShapeStore& shapes, const StopToken& stop, FilledTray& result,
                          const Pack& pack) {
    Tray tray(options_.tray);
    const double dx = options_.tray.voxel_size;
    const int detail = options_.tray.detail;
    PartSurfaces surfaces(part_of_, workers_);
    std::optional<Caps> caps;
    if (options_.max_density || options_.max_layer_fill) {
        caps.emplace(cap_options(options_),
                     CapParts{[&](int part) { return surfaces.part(part).volume; },
                              [&](int part, int orientation) { return surfaces.turned_mesh(part, orientation); }});
    }
    std::unique_ptr<Refinement> refinement;
    if (options_.refine) {
        refinement = std::make_unique<Refinement>(
            RefineOptions{options_.container.size, options_.wall_gap, kLongestMove * dx, kRefineRounds}, dx, detail,
            surfaces,
            [&](int part, int orientation, const Vec3& offset) {
                return !caps || caps->may_stand(part, orientation, offset);
            },
            workers_);
    }
    if (refinement) {
        for (const PlacedSurface& wall : walls_) {
            refinement->stand(wall);
        }
    }
    std::vector<Body> fixed = stand_fixed(wanted.number, tray, refinement.get(), caps ? &*caps : nullptr);
    double refining = 0;
    const Settle settle = [&](const Copy& copy, const Shape& shape, const BestPlacement& best) {
        if (!refinement) return settle_on_grid(shape, best, dx, detail, options_.wall_gap);
        Settled standing = refinement->settle(copy, shape, best);
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
        return standing;
    };
    const PlaceLimits limits{caps ? &*caps : nullptr, options_.most_layers, wanted.give_up_after};
    ReachableSearch reachable(search_, physical_ ? &*physical_ : nullptr);
    PlacementSearch& search = options_.interlock == Interlock::place ? static_cast<PlacementSearch&>(reachable)
                              : avoids_links()                       ? static_cast<PlacementSearch&>(unlinked_)
                                                                     : search_;
    pack(tray, search, settle, limits);
    if (options_.interlock != Interlock::off) {
        search.forget();  // planning takes memory of its own
        make_removable(wanted, tray, std::move(fixed), surfaces, shapes, limits, stop, result);
    }
    if (!refinement) return;
    const std::optional<double> gap = result.report.changed ? result.report.least_gap : refinement->least_gap();
    if (gap && *gap < least_gap_.value_or(Box::kInfinity)) least_gap_ = gap;
}

void TrayFiller::make_removable(const TrayCopies& wanted, Tray& tray, std::vector<Body> fixed, PartSurfaces& surfaces,
                                ShapeStore& shapes, const PlaceLimits& limits, const StopToken& stop,
                                FilledTray& result) {
    UntangleOptions options;
    options.voxel_size = options_.tray.voxel_size;
    options.wall_gap = options_.wall_gap;
    options.ray_spacing = options_.ray_spacing;
    options.model = options_.model;
    options.surfaces = &surfaces;
    options.fixed = std::move(fixed);
    options.walls = physical_ ? &*physical_ : nullptr;
    if (avoids_links()) options.best = &unlinked_;
    options.shapes = &shapes;
    options.limits = limits;
    options.take_out = options_.take_out;
    options.measure_gap = options_.refine;
    options.order = wanted.copies;
    if (!wanted.next) options.waiting = result.left_over;
    options.waiting_had_no_room = options_.interlock == Interlock::post;
    options.left = options_.left;
    options.to_put_back = options_.to_put_back;
    options.workers = workers_;
    Untangled untangled = untangle(tray, search_, result.placed, options, stop);
    result.plan = std::move(untangled.plan);
    result.interlocked = std::move(untangled.interlocked);
    result.report = untangled.report;
    untangle_seconds_ += result.report.disassemble_seconds + result.report.reinsert_seconds;
}

void TrayFiller::fill(const TrayCopies& wanted, ShapeStore& shapes, const CopyDone& copy_done, const StopToken& stop,
                      FilledTray& result) {
    const std::vector<Copy>& copies = wanted.copies;
    shapes.start_tray(copies);
    fill_one(wanted, shapes, stop, result,
             [&](Tray& tray, PlacementSearch& search, const Settle& settle, const PlaceLimits& limits) {
                 if (options_.beam) {
                     pack_in_beam(tray, *options_.beam, options_.model, copies, shapes, settle, copy_done, stop, result,
                                  limits.most_layers);
                 } else {
                     pack_greedily(tray, search, options_.model, copies, shapes, settle, copy_done, stop, result,
                                   limits);
                 }
             });
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, ShapeStore& shapes, const CopyDone& copy_done,
                                const StopToken& stop, FilledTray& result) {
    std::vector<Copy> copies;
    for (const PartShare& share : shares) {
        copies.push_back({share.part, 0});
    }
    shapes.start_tray(copies);
    fill_one({}, shapes, stop, result,
             [&](Tray& tray, PlacementSearch& search, const Settle& settle, const PlaceLimits& limits) {
                 pack_in_shares(tray, search, options_.model, shares, shapes, settle, copy_done, stop, result, limits);
             });
    std::map<int, int> counts;  // by part: what was interlocked left gaps in their numbers
    for (PlacedCopy& placed : result.placed) {
        placed.copy.number = counts[placed.copy.part]++;
    }
    result.interlocked.clear();
}

}  // namespace spectralpack
