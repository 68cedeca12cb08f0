#include "packing/job/tray_filler.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "core/stopwatch.hpp"
#include "packing/containers/walls.hpp"
#include "packing/interlocking/final_plan.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/off_grid/fill_up.hpp"
#include "packing/tray/decisions_fit.hpp"
#include "packing/tray/measure.hpp"
#include "packing/tray/open_height.hpp"
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

/// Of each part, how many times its share is placed.
std::vector<double> rounds_of(const std::vector<PartShare>& shares, const std::vector<PlacedCopy>& placed) {
    std::map<int, int> counts;
    for (const PlacedCopy& copy : placed) {
        ++counts[copy.copy.part];
    }
    std::vector<double> rounds;
    for (const PartShare& share : shares) {
        rounds.push_back(static_cast<double>(counts[share.part]) / share.share);
    }
    return rounds;
}

}  // namespace

TrayFiller::TrayFiller(FillOptions options, const PackContext& context, PartSurfaces::PartOf part_of)
    : options_(std::move(options)), context_(context), unlinked_(context.search), part_of_(std::move(part_of)) {
    if (options_.container.physical && options_.interlock != Interlock::off) {
        physical_ = physical_walls(options_.container, finest_setup(options_.tray), options_.wall_gap,
                                   context_.workers.stopping_with(enough()));
    }
    if (options_.refine) walls_ = wall_surfaces(options_.container, options_.wall_gap, enough());
    for (const FixedCopy& copy : options_.fixed) {
        trays_with_fixed_ = std::max(trays_with_fixed_, copy.tray + 1);
    }
}

std::vector<Body> TrayFiller::stand_fixed_copies(int number, Tray& tray, Refinement* refinement, Caps* caps) const {
    std::vector<Body> standing;
    for (const FixedCopy& copy : options_.fixed) {
        if (copy.tray != number) continue;
        const Mesh mesh = transformed(*copy.mesh, copy.transform);
        standing.push_back(
            stand_fixed(mesh, copy.gap, tray, options_.wall_gap, context_.workers.stopping_with(enough())));
        if (refinement) refinement->stand({standing.back().surface, {}, copy.gap});
        if (caps) caps->add_fixed(mesh);
    }
    return standing;
}

Vec3 TrayFiller::room_for_moves(const TrayCopies& wanted) const {
    const double wall = 2 * options_.wall_gap;
    return wanted.within ? *wanted.within + Vec3{wall, wall, wall} : options_.container.size;
}

/// Stands in the tray what a run before had packed. The context's observer is told of it.
void TrayFiller::stand_again(const PackedTray& known, Tray& tray, const TrayContext& context, Refinement* refinement,
                             FilledTray& result) const {
    require_fit_of_layers(known.layers, tray, options_.most_layers);
    if (tray.extent().z < known.layers) tray = grown(tray, known.layers);
    static_cast<GreedyResult&>(result) = known.result;
    std::vector<Copy> copies;
    for (const PlacedCopy& placed : result.placed) {
        copies.push_back(placed.copy);
    }
    if (!refinement) context.shapes.start_tray(copies);
    for (std::size_t i = 0; i < copies.size(); ++i) {
        PlacedCopy& placed = result.placed[i];
        const auto& [part, number] = placed.copy;
        if (refinement) {
            const int gap_class = tray.gap_class_of(part_of_(part).gap);
            placed.object =
                tray.add(refinement->stand_at(placed.copy, placed.orientation, placed.offset, gap_class).object);
        } else {
            const Shape& shape = context.shapes.at(i);
            const auto oriented =
                std::ranges::find(shape.orientations, placed.orientation, &OrientedShape::orientation);
            BestPlacement place;
            place.index = static_cast<int>(oriented - shape.orientations.begin());
            place.position = placed.position;
            placed.object =
                tray.add(settle_on_grid(shape, place, tray.voxel_size(), tray.detail(), options_.wall_gap).object);
            context.shapes.release(i, true);
        }
        if (Caps* caps = context.limits.caps) caps->add(part, placed.orientation, placed.offset);
        if (context.observer) context.observer->copy_placed(placed);
    }
}

template <class Pack, class FillUp>
bool TrayFiller::fill_one(const TrayCopies& wanted, const std::vector<Copy>& copies, FilledTray& result,
                          const Pack& pack, const FillUp& fill_up) {
    Decisions* const decisions = context_.decisions;
    const auto orientations = [&](int part) {
        const std::vector<Mat3>* set = part_of_(part).orientations;
        return set ? set->size() : 0;
    };
    if (decisions) {
        decisions->begin_filling();
        if (std::optional<FilledTray> known = decisions->recall_filled()) {
            require_fit(*known, copies, orientations);
            if (known->plan) require_fit(*known->plan, known->placed.size(), options_.fixed.size());
            result = std::move(*known);
            if (context_.observer) tell_anew(*context_.observer, wanted.number, result.placed);
            return false;
        }
    }
    TraySetup setup = options_.tray;
    setup.size = wanted.within.value_or(setup.size);
    Tray tray(setup);
    const double dx = options_.tray.voxel_size;
    const int detail = options_.tray.detail;
    PartSurfaces surfaces(part_of_, context_.workers);
    std::optional<Caps> caps;
    if (options_.max_density || options_.max_layer_fill) {
        caps.emplace(cap_options(options_),
                     CapParts{[&](int part) { return surfaces.part(part).volume; },
                              [&](int part, int orientation) { return surfaces.turned_mesh(part, orientation); }});
    }
    std::unique_ptr<Refinement> refinement;
    if (options_.refine) {
        refinement = std::make_unique<Refinement>(
            RefineOptions{room_for_moves(wanted), options_.wall_gap, kLongestMove * dx, kRefineRounds}, dx, detail,
            surfaces,
            [&](int part, int orientation, const Vec3& offset) {
                return !caps || caps->may_stand(part, orientation, offset);
            },
            context_.workers);
    }
    if (refinement) {
        for (const PlacedSurface& wall : walls_) {
            refinement->stand(wall);
        }
    }
    std::vector<Body> fixed = stand_fixed_copies(wanted.number, tray, refinement.get(), caps ? &*caps : nullptr);
    double refining = 0;
    const Settle settle = [&](const Copy& copy, const Shape& shape, const BestPlacement& best) {
        if (!refinement) return settle_on_grid(shape, best, dx, detail, options_.wall_gap);
        std::optional<SettledCopy> known;
        if (decisions) known = decisions->recall_settled(copy);
        const int orientation = shape.orientations[static_cast<std::size_t>(best.index)].orientation;
        Settled settled = known ? refinement->stand_at(copy, orientation, known->offset, shape.gap_class)
                                : refinement->settle(copy, shape, best, enough());
        if (decisions && !known) decisions->keep(SettledCopy{copy, settled.offset});
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
        return settled;
    };
    ReachableSearch reachable(context_.search, physical_ ? &*physical_ : nullptr);
    PlacementSearch& search = options_.interlock == Interlock::place ? static_cast<PlacementSearch&>(reachable)
                              : avoids_links()                       ? static_cast<PlacementSearch&>(unlinked_)
                                                                     : context_.search;
    CostModel model = options_.model;
    model.height_at = wanted.height_at.value_or(model.height_at);
    result.height_at = model.height_at;
    const auto with = [&](PlacementSearch& asked, const StopToken& stop) {
        context_.shapes.stop_with(stop);
        return TrayContext{{asked, context_.shapes, context_.workers, stop, context_.observer, decisions},
                           wanted.number,
                           model,
                           {caps ? &*caps : nullptr, options_.most_layers, wanted.give_up_after},
                           settle};
    };
    if (context_.observer) context_.observer->tray_begun(wanted.number);
    const TrayContext packing = with(search, enough());
    std::optional<PackedTray> packed;
    if (decisions) packed = decisions->recall_packed();
    if (packed) {
        require_fit(packed->result, copies, orientations);
        stand_again(*packed, tray, packing, refinement.get(), result);
    } else {
        pack(tray, packing);
    }
    // Off the grid nothing tells of places that can be reached now. On part of the base what is left over says that
    // this part is too small.
    if (!packed && refinement && tray.setup().ceiling == Ceiling::closed && options_.interlock != Interlock::place &&
        !wanted.within) {
        OffGrid off_grid(options_.container, options_.wall_gap, tray, packing, *refinement, surfaces);
        fill_up(tray, packing, off_grid, surfaces);
        refine_seconds_ += refinement->seconds() - std::exchange(refining, refinement->seconds());
    }
    result.cut_short = !packed && enough().stopped();
    if (decisions && !packed && !result.cut_short) decisions->keep(PackedTray{tray.extent().z, result});
    if (options_.interlock != Interlock::off) {
        search.forget();  // planning takes memory of its own
        UntangleOptions options = untangle_options(wanted, result);
        options.surfaces = &surfaces;
        options.fixed = std::move(fixed);
        make_removable(tray, with(context_.search, context_.stop), options, result);
    }
    if (refinement) result.least_gap = result.report.changed ? result.report.least_gap : refinement->least_gap();
    if (decisions && !result.cut_short && !context_.stop.stopped()) decisions->keep(result);
    return true;
}

UntangleOptions TrayFiller::untangle_options(const TrayCopies& wanted, const FilledTray& result) {
    UntangleOptions options;
    options.voxel_size = options_.tray.voxel_size;
    options.wall_gap = options_.wall_gap;
    options.ray_spacing = options_.ray_spacing;
    options.walls = physical_ ? &*physical_ : nullptr;
    if (avoids_links()) options.best = &unlinked_;
    options.take_out = options_.take_out;
    options.measure_gap = options_.refine;
    options.order = wanted.copies;
    if (!wanted.next) options.waiting = result.left_over;
    options.waiting_had_no_room = options_.interlock == Interlock::post;
    options.left = options_.left;
    options.to_put_back = options_.to_put_back;
    return options;
}

void TrayFiller::make_removable(Tray& tray, const TrayContext& context, const UntangleOptions& options,
                                FilledTray& result) {
    if (context.stop.stopped() &&
        !result.placed.empty()) {  // nothing would be found out, of large meshes after seconds
        result.plan.emplace();
        return;
    }
    Untangled untangled = untangle(tray, result.placed, context, options);
    result.interlocked = std::move(untangled.interlocked);
    result.report = untangled.report;
    const Stopwatch ordering;
    result.plan = final_plan({options, options_.container, options_.unpack, options_.left}, tray, result.placed,
                             context, std::move(untangled.plan), result.report.counts);
    result.report.disassemble_seconds += ordering.seconds();
    untangle_seconds_ += result.report.disassemble_seconds + result.report.reinsert_seconds;
}

void TrayFiller::fill(const TrayCopies& wanted, const CopyDone& copy_done, FilledTray& result) {
    const bool packed = fill_one(
        wanted, wanted.copies, result,
        [&](Tray& tray, const TrayContext& context) {
            context.shapes.start_tray(wanted.copies);
            if (options_.beam) {
                pack_in_beam(tray, *options_.beam, context, wanted.copies, copy_done, result);
            } else {
                pack_greedily(tray, context, wanted.copies, copy_done, result);
            }
        },
        [&](Tray& tray, const TrayContext& context, OffGrid& off_grid, PartSurfaces& surfaces) {
            fill_up(off_grid, surfaces, tray, context, wanted.copies, result);
        });
    if (!packed) copy_done(wanted.copies.size());
    if (context_.observer) context_.observer->tray_finished();
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, const FirstCopies& first,
                                const CopyDone& copy_done, FilledTray& result) {
    std::vector<Copy> copies;
    for (const PartShare& share : shares) {
        copies.push_back({share.part, 0});
    }
    const bool packed = fill_one(
        {}, copies, result,
        [&](Tray& tray, const TrayContext& context) {
            context.shapes.start_tray(copies);
            pack_in_shares(tray, context, shares, first, copy_done, result);
        },
        [&](Tray&, const TrayContext& context, OffGrid& off_grid, PartSurfaces& surfaces) {
            fill_up_in_shares(off_grid, surfaces, context, shares, result);
            copy_done(result.placed.size());
        });
    if (!packed) copy_done(result.placed.size());
}

/// The part that has least of its share, where it is a whole round behind some other; and so many of it as there would
/// be if what is placed, by volume, were in the shares. None where that is no more than there is.
FirstCopies TrayFiller::lagging(const std::vector<PartShare>& shares, const std::vector<PlacedCopy>& placed) const {
    const std::vector<double> rounds = rounds_of(shares, placed);
    const auto [least, most] = std::ranges::minmax_element(rounds);
    if (rounds.empty() || *most - *least < 1) return {};
    double volume = 0, of_round = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double one = std::abs(part_of_(shares[i].part).volume);
        volume += rounds[i] * shares[i].share * one;
        of_round += shares[i].share * one;
    }
    const auto index = static_cast<std::size_t>(least - rounds.begin());
    const double enough = of_round > 0 ? std::floor(volume / of_round) * shares[index].share : 0;
    if (enough <= *least * shares[index].share) return {};
    return {index, static_cast<int>(enough)};
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, const CopyDone& copy_done, FilledTray& result) {
    fill_in_shares(shares, {}, copy_done, result);
    const FirstCopies first = lagging(shares, result.placed);
    if (first.count > 0 && !enough().stopped()) {
        FilledTray other;
        context_.search.forget();
        fill_in_shares(shares, first, copy_done, other);
        const bool better = !enough().stopped() && std::ranges::min(rounds_of(shares, other.placed)) >
                                                       std::ranges::min(rounds_of(shares, result.placed));
        const std::int64_t searches = result.searches + other.searches;
        if (better) {
            result = std::move(other);
        } else {
            if (context_.observer) tell_anew(*context_.observer, 0, result.placed);
        }
        result.searches = searches;
    }
    std::map<int, int> counts;  // by part: what was interlocked left gaps in their numbers
    bool renumbered = false;
    for (PlacedCopy& placed : result.placed) {
        const int number = counts[placed.copy.part]++;
        renumbered = std::exchange(placed.copy.number, number) != number || renumbered;
    }
    result.interlocked.clear();
    if (!context_.observer) return;
    if (renumbered) tell_anew(*context_.observer, 0, result.placed);
    context_.observer->tray_finished();
}

}  // namespace spectralpack
