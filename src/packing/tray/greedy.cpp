#include "packing/tray/greedy.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "core/stopped.hpp"
#include "packing/tray/decisions_fit.hpp"
#include "packing/tray/open_height.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

void grow(Tray& tray, int enough, int most_layers) {
    const int layers = tray.extent().z;
    int wanted = std::max(enough, layers + layers / 2);
    if (most_layers > 0) {
        wanted = std::min(wanted, most_layers);
        if (wanted < enough || wanted <= layers) {
            throw ResourceError(
                "the packing grows beyond the height that memory allows; a larger base, coarser "
                "voxels or more memory would help");
        }
    }
    tray = grown(tray, wanted);
}

PlaceOutcome try_place(Tray& tray, const TrayContext& context, const Copy& copy, const ShapeOfCopy& shape_of,
                       GreedyResult& result) {
    if (context.stop.stopped()) return PlaceOutcome::stopped;
    Caps* const caps = context.limits.caps;
    if (caps) {
        const std::string why = caps->why_not(copy.part);
        if (!why.empty()) {
            result.why[copy.part] = why;
            return PlaceOutcome::no_place;
        }
    }
    const Shape& shape = shape_of();
    const SearchResult found = find_place(tray, context.search, context, copy, shape);
    if (found.stopped) return PlaceOutcome::stopped;
    ++result.searches;
    if (!found.best) {
        const std::string why = caps ? caps->no_layer_left() : "";
        if (!why.empty()) result.why[copy.part] = why;
        return PlaceOutcome::no_place;
    }
    if (context.stop.stopped()) return PlaceOutcome::stopped;  // the surfaces of a large mesh take seconds
    const OrientedShape& oriented = shape.orientations[static_cast<std::size_t>(found.best->index)];
    Settled settled = context.settle(copy, shape, *found.best);
    const ObjectId object = tray.add(std::move(settled.object));
    if (caps) caps->add(copy.part, oriented.orientation, settled.offset);
    result.placed.push_back(
        {copy, oriented.orientation, found.best->position, settled.offset, object, found.best->cost});
    if (context.observer) context.observer->copy_placed(result.placed.back());
    return PlaceOutcome::placed;
}

}  // namespace

namespace {

SearchResult search_place(Tray& tray, PlacementSearch& search, const TrayContext& context, const Copy& copy,
                          const Shape& shape) {
    Caps* const caps = context.limits.caps;
    for (;;) {
        CostModel allowed = context.model;
        if (caps) allowed.allowed = caps->allowed(copy.part, shape, tray.extent().z);
        SearchResult found = search.best_placement(tray, shape, allowed, context.stop);
        if (found.stopped || tray.setup().ceiling == Ceiling::closed) return found;
        if (found.best && holds_in_any_grid(tray, shape, allowed, *found.best)) return found;
        const int enough = layers_on_top(tray, shape);
        if (!found.best && tray.extent().z >= enough) return found;
        grow(tray, enough, context.limits.most_layers);
    }
}

}  // namespace

SearchResult find_place(Tray& tray, PlacementSearch& search, const TrayContext& context, const Copy& copy,
                        const Shape& shape) {
    if (tray.excludes(shape.gap_class)) return {};
    if (!context.decisions) return search_place(tray, search, context, copy, shape);
    if (const std::optional<FoundPlace> known = context.decisions->recall_place(copy)) {
        require_fit(*known, tray, shape, context.limits.most_layers);
        if (tray.extent().z < known->layers) tray = grown(tray, known->layers);
        return {known->best, false};
    }
    SearchResult found = search_place(tray, search, context, copy, shape);
    if (!found.stopped) context.decisions->keep(FoundPlace{copy, tray.extent().z, found.best});
    return found;
}

PlaceOutcome place_copy(Tray& tray, const TrayContext& context, const Copy& copy, const ShapeOfCopy& shape_of,
                        GreedyResult& result) {
    try {
        return try_place(tray, context, copy, shape_of, result);
    } catch (const Stopped&) {  // while its voxels were made
        return PlaceOutcome::stopped;
    }
}

void pack_greedily(Tray& tray, const TrayContext& context, const std::vector<Copy>& copies, const CopyDone& copy_done,
                   GreedyResult& result) {
    ShapeStore& shapes = context.shapes;
    std::unordered_set<int> hopeless;  // parts that found no place
    const auto most_hopeless = static_cast<std::size_t>(context.limits.give_up_after);
    for (std::size_t i = 0; i < copies.size(); ++i) {
        if (most_hopeless > 0 && hopeless.size() >= most_hopeless) return;
        const Copy& copy = copies[i];
        bool placed = false;
        if (hopeless.contains(copy.part)) {
            result.left_over.push_back(copy);
        } else {
            const auto outcome = place_copy(
                tray, context, copy, [&]() -> const Shape& { return shapes.at(i); }, result);
            if (outcome == PlaceOutcome::stopped) {
                result.untried.assign(copies.begin() + static_cast<std::ptrdiff_t>(i), copies.end());
                return;
            }
            placed = outcome == PlaceOutcome::placed;
            if (!placed) {
                hopeless.insert(copy.part);
                result.left_over.push_back(copy);
            }
        }
        shapes.release(i, placed);
        copy_done(i + 1);
    }
}

void share_out(const std::vector<PartShare>& shares, std::vector<int>& placed,
               const std::function<PlaceOutcome(std::size_t index, const Copy& copy)>& place) {
    std::vector<std::size_t> open(shares.size());  // parts that still find a place
    std::iota(open.begin(), open.end(), std::size_t{0});
    while (!open.empty()) {
        std::int64_t copies = 0, all = 0;
        for (const std::size_t i : open) {
            copies += placed[i];
            all += shares[i].share;
        }
        // What a part lacks once there is one copy more: share / all * (copies + 1) - its own, times `all`.
        const auto lacks = [&](std::size_t i) {
            return static_cast<double>(shares[i].share) * static_cast<double>(copies + 1) -
                   static_cast<double>(placed[i]) * static_cast<double>(all);
        };
        const auto next = std::ranges::max_element(open, {}, lacks);
        const PlaceOutcome outcome = place(*next, {shares[*next].part, placed[*next]});
        if (outcome == PlaceOutcome::stopped) return;
        if (outcome == PlaceOutcome::placed) {
            ++placed[*next];
        } else {
            open.erase(next);
        }
    }
}

void pack_in_shares(Tray& tray, const TrayContext& context, const std::vector<PartShare>& shares,
                    const FirstCopies& first, const CopyDone& copy_done, GreedyResult& result) {
    ShapeStore& shapes = context.shapes;
    std::vector<int> placed(shares.size(), 0);
    const auto place = [&](std::size_t i, const Copy& copy) {
        const PlaceOutcome outcome = place_copy(
            tray, context, copy, [&]() -> const Shape& { return shapes.at(i); }, result);
        if (outcome != PlaceOutcome::stopped) copy_done(result.placed.size());
        return outcome;
    };
    while (first.count > 0 && placed[first.index] < first.count) {
        const Copy copy{shares[first.index].part, placed[first.index]};
        const PlaceOutcome outcome = place(first.index, copy);
        if (outcome == PlaceOutcome::stopped) return;
        if (outcome == PlaceOutcome::no_place) break;
        ++placed[first.index];
    }
    share_out(shares, placed, [&](std::size_t i, const Copy& copy) {
        const PlaceOutcome outcome = place(i, copy);
        if (outcome == PlaceOutcome::no_place) shapes.release(i, true);
        return outcome;
    });
}

}  // namespace spectralpack
