#include "packing/job/started_tray.hpp"

#include <algorithm>
#include <utility>

#include "core/stopwatch.hpp"
#include "packing/containers/walls.hpp"
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

TraySetup setup_for(const FillOptions& options, const TrayCopies& wanted) {
    TraySetup setup = options.tray;
    setup.size = wanted.within.value_or(setup.size);
    return setup;
}

}  // namespace

TraySurroundings::TraySurroundings(FillOptions fill, const PackContext& pack, PartSurfaces::PartOf parts)
    : options(std::move(fill)), context(pack), part_of(std::move(parts)), unlinked(pack.search) {
    if (options.container.physical && options.interlock != Interlock::off) {
        physical = physical_walls(options.container, finest_setup(options.tray), options.wall_gap,
                                  context.workers.stopping_with(enough()));
    }
    if (options.refine) walls = wall_surfaces(options.container, options.wall_gap, enough());
}

RefineOptions TraySurroundings::refining(const TrayCopies& wanted) const {
    const double wall = 2 * options.wall_gap;
    const Vec3 room = wanted.within ? *wanted.within + Vec3{wall, wall, wall} : options.container.size;
    return {room, options.wall_gap, kLongestMove * options.tray.voxel_size, kRefineRounds};
}

StartedTray::StartedTray(TraySurroundings& around, const TrayCopies& wanted, bool refine)
    : around_(around),
      wanted_(wanted),
      model_(around.options.model),
      tray_(setup_for(around.options, wanted)),
      surfaces_(around.part_of, around.context.workers),
      reachable_(around.context.search, around.physical ? &*around.physical : nullptr) {
    model_.height_at = wanted.height_at.value_or(model_.height_at);
    if (around.options.max_density || around.options.max_layer_fill) make_caps();
    if (refine) make_refinement();
    for (const PlacedSurface& wall : around.walls) {
        stand(wall);
    }
    stand_fixed_copies();
}

void StartedTray::make_caps() {
    caps_.emplace(cap_options(around_.options),
                  CapParts{[this](int part) { return surfaces_.part(part).volume; },
                           [this](int part, int orientation) { return surfaces_.turned_mesh(part, orientation); }});
}

void StartedTray::make_refinement() {
    refinement_ = std::make_unique<Refinement>(
        around_.refining(wanted_), tray_.voxel_size(), tray_.detail(), surfaces_,
        [this](int part, int orientation, const Vec3& offset) {
            return !caps_ || caps_->may_stand(part, orientation, offset);
        },
        around_.context.workers);
}

void StartedTray::stand_fixed_copies() {
    const FillOptions& options = around_.options;
    for (const FixedCopy& copy : options.fixed) {
        if (copy.tray != wanted_.number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        fixed_.push_back(stand_fixed(mesh, copy.gap, tray_, options.wall_gap,
                                     around_.context.workers.stopping_with(around_.enough())));
        stand({fixed_.back().surface, {}, copy.gap});
        if (caps_) caps_->add_fixed(mesh);
    }
}

void StartedTray::stand(const PlacedSurface& obstacle) {
    standing_.push_back(obstacle);
    if (refinement_) refinement_->stand(obstacle);
}

PlacementSearch& StartedTray::search() {
    if (around_.options.interlock == Interlock::place) return reachable_;
    if (around_.avoids_links()) return around_.unlinked;
    return around_.context.search;
}

TrayContext StartedTray::context(PlacementSearch& search, const StopToken& stop) {
    const PackContext& of = around_.context;
    of.shapes.stop_with(stop);
    return {
        {search, of.shapes, of.workers, stop, of.observer, of.decisions},
        wanted_.number,
        model_,
        {caps(), around_.options.most_layers, wanted_.give_up_after},
        [this](const Copy& copy, const Shape& shape, const BestPlacement& best) { return settle(copy, shape, best); }};
}

double StartedTray::take_refine_seconds() {
    const double seconds = (refinement_ ? refinement_->seconds() : 0) + compacting_;
    return seconds - std::exchange(refining_, seconds);
}

Settled StartedTray::settle(const Copy& copy, const Shape& shape, const BestPlacement& best) {
    if (!refinement_) {
        return settle_on_grid(shape, best, tray_.voxel_size(), tray_.detail(), around_.options.wall_gap);
    }
    Decisions* const decisions = around_.context.decisions;
    std::optional<SettledCopy> known;
    if (decisions) known = decisions->recall_settled(copy);
    const int orientation = shape.orientations[static_cast<std::size_t>(best.index)].orientation;
    Settled settled = known ? refinement_->stand_at(copy, orientation, known->offset, shape.gap_class)
                            : refinement_->settle(copy, shape, best, around_.enough());
    if (decisions && !known) decisions->keep(SettledCopy{copy, settled.offset});
    return settled;
}

Settled StartedTray::settle_again(const PlacedCopy& placed) {
    const int gap_class = tray_.gap_class_of(around_.part_of(placed.copy.part).gap);
    return refinement_->stand_at(placed.copy, placed.orientation, placed.offset, gap_class);
}

void StartedTray::stand(std::vector<PlacedCopy>& placed, const TrayContext& context) {
    if (!refinement_) context.shapes.start_tray(order_of(placed));
    for (std::size_t i = 0; i < placed.size(); ++i) {
        PlacedCopy& copy = placed[i];
        if (refinement_) {
            copy.object = tray_.add(settle_again(copy).object);
        } else {
            copy.object = add_on_grid(copy, context.shapes.at(i));
            context.shapes.release(i, true);
        }
        if (caps_) caps_->add(copy.copy.part, copy.orientation, copy.offset);
        if (context.observer) context.observer->copy_placed(copy);
    }
}

ObjectId StartedTray::add_on_grid(const PlacedCopy& placed, const Shape& shape) {
    const auto oriented = std::ranges::find(shape.orientations, placed.orientation, &OrientedShape::orientation);
    BestPlacement place;
    place.index = static_cast<int>(oriented - shape.orientations.begin());
    place.position = placed.position;
    return tray_.add(settle_on_grid(shape, place, tray_.voxel_size(), tray_.detail(), around_.options.wall_gap).object);
}

void StartedTray::compact(std::vector<PlacedCopy>& placed, const TrayContext& context) {
    const Stopwatch watch;
    const CompactionOptions options{around_.refining(wanted_), standing_};
    const std::vector<PlacedCopy> before = placed;
    const bool moved = spectralpack::compact(options, surfaces_, caps(), placed, context.workers, context.stop);
    compacting_ += watch.seconds();
    if (!moved) return;
    refinement_->restart();
    for (std::size_t i = 0; i < placed.size(); ++i) {
        PlacedCopy& copy = placed[i];
        if (copy.offset == before[i].offset) {
            refinement_->stand_still(copy);
            continue;
        }
        tray_.remove(copy.object);
        copy.object = tray_.add(settle_again(copy).object);
        if (context.observer) context.observer->copy_moved(copy);
    }
}

}  // namespace spectralpack
