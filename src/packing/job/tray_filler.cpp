#include "packing/job/tray_filler.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "core/stopwatch.hpp"
#include "packing/interlocking/final_plan.hpp"
#include "packing/off_grid/fill_up.hpp"
#include "packing/tray/decisions_fit.hpp"
#include "packing/tray/open_height.hpp"

namespace spectralpack {
namespace {

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
    : around_(std::move(options), context, std::move(part_of)) {
    for (const FixedCopy& copy : around_.options.fixed) {
        trays_with_fixed_ = std::max(trays_with_fixed_, copy.tray + 1);
    }
}

template <class Pack, class FillUp>
bool TrayFiller::fill_one(const TrayCopies& wanted, bool compacts, const std::vector<Copy>& copies, FilledTray& result,
                          const Pack& pack, const FillUp& fill_up) {
    const FillOptions& options = around_.options;
    const PackContext& context = around_.context;
    Decisions* const decisions = context.decisions;
    const auto orientations = [&](int part) {
        const std::vector<Mat3>* set = around_.part_of(part).orientations;
        return set ? set->size() : 0;
    };
    if (decisions) {
        decisions->begin_filling();
        if (std::optional<FilledTray> known = decisions->recall_filled()) {
            require_fit(*known, copies, orientations);
            if (known->plan) require_fit(*known->plan, known->placed.size(), options.fixed.size());
            result = std::move(*known);
            if (context.observer) tell_anew(*context.observer, wanted.number, result.placed);
            return false;
        }
    }
    StartedTray started(around_, wanted, options.refine);
    Tray& tray = started.tray();
    result.height_at = started.height_at();
    if (context.observer) context.observer->tray_begun(wanted.number);
    const TrayContext packing = started.context(started.search(), enough());
    std::optional<PackedTray> packed;
    if (decisions) packed = decisions->recall_packed();
    if (packed) {
        require_fit(packed->result, copies, orientations);
        require_fit_of_layers(packed->layers, tray, options.most_layers);
        if (tray.extent().z < packed->layers) tray = grown(tray, packed->layers);
        static_cast<GreedyResult&>(result) = packed->result;
        started.stand(result.placed, packing);
    } else {
        pack(started, packing);
        // Off the grid nothing tells of places that can be reached now. On part of the base what is left over says
        // that this part is too small.
        const bool may_move = started.refinement() && options.interlock != Interlock::place;
        if (may_move && tray.setup().ceiling == Ceiling::closed && !wanted.within) {
            OffGrid off_grid(options.container, options.wall_gap, tray, packing, *started.refinement(),
                             started.surfaces());
            fill_up(tray, packing, off_grid, started.surfaces());
        }
        if (compacts && may_move && started.height_at() == HeightAt::top && result.left_over.empty()) {
            started.compact(result.placed, packing);
        }
        refine_seconds_ += started.take_refine_seconds();
    }
    result.cut_short = !packed && enough().stopped();
    if (decisions && !packed && !result.cut_short) decisions->keep(PackedTray{tray.extent().z, result});
    if (options.interlock != Interlock::off && options.take_apart) {
        started.search().forget();  // planning takes memory of its own
        UntangleOptions untangling = untangle_options(wanted, result);
        untangling.surfaces = &started.surfaces();
        untangling.fixed = started.fixed();
        make_removable(tray, started.context(context.search, context.stop), untangling, result);
    }
    if (started.refinement()) {
        result.least_gap = result.report.changed ? result.report.least_gap : started.refinement()->least_gap();
    }
    if (decisions && !result.cut_short && !context.stop.stopped()) decisions->keep(result);
    return true;
}

UntangleOptions TrayFiller::untangle_options(const TrayCopies& wanted, const FilledTray& result) {
    const FillOptions& fill = around_.options;
    UntangleOptions options;
    options.voxel_size = fill.tray.voxel_size;
    options.wall_gap = fill.wall_gap;
    options.ray_spacing = fill.ray_spacing;
    options.walls = around_.physical ? &*around_.physical : nullptr;
    if (around_.avoids_links()) options.best = &around_.unlinked;
    options.take_out = fill.take_out;
    options.repair = fill.repair;
    options.measure_gap = fill.refine;
    options.order = wanted.copies;
    if (!wanted.next) options.waiting = result.left_over;
    options.waiting_had_no_room = fill.interlock == Interlock::post;
    options.left = fill.left;
    options.to_put_back = fill.to_put_back;
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
    result.plan = final_plan({options, around_.options.container, around_.options.unpack, around_.options.left}, tray,
                             result.placed, context, std::move(untangled.plan), result.report.counts);
    result.report.disassemble_seconds += ordering.seconds();
    untangle_seconds_ += result.report.disassemble_seconds + result.report.reinsert_seconds;
}

void TrayFiller::fill(const TrayCopies& wanted, const CopyDone& copy_done, FilledTray& result) {
    const bool packed = fill_one(
        wanted, true, wanted.copies, result,
        [&](StartedTray& started, const TrayContext& context) {
            Tray& tray = started.tray();
            context.shapes.start_tray(wanted.copies);
            if (around_.options.beam) {
                pack_in_beam(tray, *around_.options.beam, context, wanted.copies, copy_done, result);
            } else {
                pack_greedily(tray, context, wanted.copies, copy_done, result);
            }
        },
        [&](Tray& tray, const TrayContext& context, OffGrid& off_grid, PartSurfaces& surfaces) {
            fill_up(off_grid, surfaces, tray, context, wanted.copies, result);
        });
    if (!packed) copy_done(wanted.copies.size());
    if (around_.context.observer) around_.context.observer->tray_finished();
}

void TrayFiller::finish(const TrayCopies& wanted, const std::vector<PlacedCopy>& layout, bool is_compact,
                        FilledTray& result) {
    const std::vector<Copy> rest = without(wanted.copies, copies_in(layout));
    const bool compacts = around_.options.refine && !is_compact;
    fill_one(
        wanted, compacts, wanted.copies, result,
        [&](StartedTray& started, const TrayContext& context) {
            result.placed = layout;
            started.stand(result.placed, context);
            if (rest.empty()) return;
            if (compacts) started.compact(result.placed, context);
            context.shapes.start_tray(rest);
            pack_greedily(
                started.tray(), context, rest, [](std::size_t) {}, result);
        },
        [&](Tray& tray, const TrayContext& context, OffGrid& off_grid, PartSurfaces& surfaces) {
            fill_up(off_grid, surfaces, tray, context, wanted.copies, result);
        });
    if (around_.context.observer) around_.context.observer->tray_finished();
}

void TrayFiller::fill_in_shares(const std::vector<PartShare>& shares, const FirstCopies& first,
                                const CopyDone& copy_done, FilledTray& result) {
    std::vector<Copy> copies;
    for (const PartShare& share : shares) {
        copies.push_back({share.part, 0});
    }
    const bool packed = fill_one(
        {}, false, copies, result,
        [&](StartedTray& started, const TrayContext& context) {
            context.shapes.start_tray(copies);
            pack_in_shares(started.tray(), context, shares, first, copy_done, result);
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
        const double one = std::abs(around_.part_of(shares[i].part).volume);
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
        around_.context.search.forget();
        fill_in_shares(shares, first, copy_done, other);
        const bool better = !enough().stopped() && std::ranges::min(rounds_of(shares, other.placed)) >
                                                       std::ranges::min(rounds_of(shares, result.placed));
        const std::int64_t searches = result.searches + other.searches;
        if (better) {
            result = std::move(other);
        } else {
            if (around_.context.observer) tell_anew(*around_.context.observer, 0, result.placed);
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
    if (!around_.context.observer) return;
    if (renumbered) tell_anew(*around_.context.observer, 0, result.placed);
    around_.context.observer->tray_finished();
}

}  // namespace spectralpack
