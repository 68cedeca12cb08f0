#include "packing/off_grid/fill_up.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "packing/off_grid/lattice.hpp"

namespace spectralpack {
namespace {

constexpr int kMostInLattice = 100'000;  // copies of a part that fills a tray by itself

/// Of those left over.
void put_what_has_room(OffGrid& off_grid, const StopToken& stop, GreedyResult& result, TrayObserver* observer) {
    std::vector<Copy> still;
    for (const Copy& copy : std::exchange(result.left_over, {})) {
        if (stop.stopped() || !off_grid.put(copy, result.placed)) {
            still.push_back(copy);
        } else if (observer) {
            observer->copy_placed(result.placed.back());
        }
    }
    result.left_over = std::move(still);
}

void stand(OffGrid& off_grid, const Lattice& lattice, std::vector<PlacedCopy>& placed) {
    for (const LatticeCopy& copy : lattice.copies) {
        off_grid.put_at(copy.copy, copy.turned, copy.corner, placed);
    }
}

/// All but the lattice's parts stand in it, of those as many as before, and more copies in all.
bool surpasses(const std::vector<PlacedCopy>& now, const std::vector<PlacedCopy>& before, const Lattice& lattice) {
    std::set<Copy> standing;
    for (const PlacedCopy& copy : now) {
        standing.insert(copy.copy);
    }
    const auto of_lattice = [&](const PlacedCopy& copy) { return lattice.parts.contains(copy.copy.part); };
    return now.size() > before.size() &&
           std::ranges::count_if(now, of_lattice) >= std::ranges::count_if(before, of_lattice) &&
           std::ranges::all_of(
               before, [&](const PlacedCopy& copy) { return of_lattice(copy) || standing.contains(copy.copy); });
}

GreedyResult packed_on(const Lattice& lattice, OffGrid& off_grid, Tray& tray, const TrayContext& context,
                       const std::vector<Copy>& wanted) {
    GreedyResult result;
    stand(off_grid, lattice, result.placed);
    std::set<Copy> in_lattice;
    for (const LatticeCopy& copy : lattice.copies) {
        in_lattice.insert(copy.copy);
    }
    const std::vector<Copy> rest = without(wanted, in_lattice);
    context.shapes.start_tray(rest);
    TrayContext unobserved = context;
    unobserved.observer = nullptr;
    pack_greedily(
        tray, unobserved, rest, [](std::size_t) {}, result);
    put_what_has_room(off_grid, context.stop, result, nullptr);
    return result;
}

}  // namespace

void fill_up(OffGrid& off_grid, PartSurfaces& surfaces, Tray& tray, const TrayContext& context,
             const std::vector<Copy>& wanted, GreedyResult& result) {
    if (result.left_over.empty() || context.stop.stopped()) return;
    put_what_has_room(off_grid, context.stop, result, context.observer);
    if (result.left_over.empty() || context.limits.caps || context.stop.stopped()) return;
    const std::optional<Lattice> lattice = find_lattice(off_grid, surfaces, wanted, result.placed, result.left_over);
    if (!lattice) return;
    std::vector<PlacedCopy> before = result.placed;
    off_grid.clear(result.placed);
    context.search.forget();  // what engines know while objects are only added
    result.placed = before;
    GreedyResult anew = packed_on(*lattice, off_grid, tray, context, wanted);
    result.searches += anew.searches;
    if (context.stop.stopped() || !surpasses(anew.placed, before, *lattice)) {
        off_grid.clear(anew.placed);
        context.search.forget();
        result.placed.clear();
        for (const PlacedCopy& copy : before) {
            off_grid.put_again(copy, result.placed);
        }
        return;
    }
    anew.searches = result.searches;
    result = std::move(anew);
    if (context.observer) tell_anew(*context.observer, context.number, result.placed);
}

void fill_up_in_shares(OffGrid& off_grid, PartSurfaces& surfaces, const TrayContext& context,
                       const std::vector<PartShare>& shares, GreedyResult& result) {
    const auto put = [&](std::size_t, const Copy& copy) {
        if (context.stop.stopped()) return PlaceOutcome::stopped;
        if (!off_grid.put(copy, result.placed)) return PlaceOutcome::no_place;
        if (context.observer) context.observer->copy_placed(result.placed.back());
        return PlaceOutcome::placed;
    };
    std::map<int, int> counts;
    for (const PlacedCopy& placed : result.placed) {
        ++counts[placed.copy.part];
    }
    std::vector<int> placed;
    for (const PartShare& share : shares) {
        placed.push_back(counts[share.part]);
    }
    share_out(shares, placed, put);
    if (shares.size() != 1 || context.limits.caps || context.stop.stopped()) return;
    std::vector<Copy> more;
    for (int number = 0; number < kMostInLattice; ++number) {
        more.push_back({shares.front().part, number});
    }
    const std::optional<Lattice> lattice =
        find_lattice(off_grid, surfaces, more, result.placed, {{shares.front().part, 0}});
    if (!lattice) return;
    off_grid.clear(result.placed);
    context.search.forget();
    stand(off_grid, *lattice, result.placed);
    if (context.observer) tell_anew(*context.observer, context.number, result.placed);
    placed.front() = static_cast<int>(result.placed.size());
    share_out(shares, placed, put);
}

}  // namespace spectralpack
