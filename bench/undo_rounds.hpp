#pragma once
/// How long searches take while a tray is packed over and over: round after round the copies that were placed last are
/// taken out and placed anew in another order, as a search over orders does.

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "packing/tray/greedy.hpp"
#include "query_times.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

/// How many copies are taken out in a round.
struct CopiesOut {
    int least = 10, most = 50;
};

/// Of the processor, on all threads.
struct UndoRounds {
    QueryTimes first;  ///< searches right after some were taken out
    QueryTimes later;  ///< the others
    double costs = 0;  ///< of all places found

    void print() const {
        std::printf("taken out and placed anew (costs %.9g):\n", costs);
        first.print("the first search of a round");
        later.print("the others");
        QueryTimes all = first;
        all.ms.insert(all.ms.end(), later.ms.begin(), later.ms.end());
        all.print("all of them");
    }
};

/// Takes the last copies, as many as `counts` says, out of `tray`, and places those that find a place by `context`,
/// `rounds` times. `placed` are all that stand in it, in their order.
inline UndoRounds repack_last(Tray& tray, std::vector<PlacedCopy> placed, const TrayContext& context,
                              const std::function<const Shape&(const Copy&)>& shape_of, int rounds,
                              const CopiesOut& counts) {
    UndoRounds result;
    RandomStream random(1);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Copy> out;
        const auto span = static_cast<std::uint64_t>(counts.most - counts.least + 1);
        for (auto left = counts.least + static_cast<int>(random.below(span)); left > 0 && !placed.empty(); --left) {
            tray.remove(placed.back().object);
            out.push_back(placed.back().copy);
            placed.pop_back();
        }
        for (std::size_t i = 0; i < out.size(); ++i) {
            std::swap(out[i], out[i + random.below(out.size() - i)]);
            const Shape& shape = shape_of(out[i]);
            SearchResult found;
            const std::clock_t begin = std::clock();
            found = context.search.best_placement(tray, shape, context.model, {});
            (i == 0 ? result.first : result.later)
                .ms.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
            if (!found.best) continue;
            const int orientation = shape.orientations[static_cast<std::size_t>(found.best->index)].orientation;
            Settled settled = context.settle(out[i], shape, *found.best);
            const ObjectId object = tray.add(std::move(settled.object));
            placed.push_back({out[i], orientation, found.best->position, settled.offset, object, found.best->cost});
            result.costs += found.best->cost.primary;
        }
    }
    return result;
}

}  // namespace spectralpack
