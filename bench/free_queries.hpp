#pragma once
/// How long it takes to ask where a copy of a packed tray could be (sections 4.1 and 4.3): of each copy in turn, taken
/// out, free positions padded by one, in three ways.

#include <algorithm>
#include <cstdio>
#include <vector>

#include "disassembly/ways/reachable_region.hpp"
#include "packing/tray/greedy.hpp"
#include "query_times.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

struct FreeQueries {
    QueryTimes walks;  ///< a walk from where the copy stands over positions asked for as it goes, until it is outside
    QueryTimes all;    ///< all positions
    QueryTimes plain;  ///< all positions by transforms
    int ways = 0;      ///< walks that came outside
    int differ = 0;    ///< of the plain method's answers, from the engine's

    void print() const {
        std::printf("free positions, one copy out:\n");
        walks.print("a walk from the copy to outside, lazily");
        all.print("all of them");
        plain.print("all of them, plain (transforms)");
        std::printf("  %d of %zu walks came outside; %d plain answers differ\n", ways, walks.ms.size(), differ);
    }
};

/// Asks of `engine` about all of `placed`, for all positions about every `every`-th, of which as many as `samples` of
/// `plain` (null: none) as well.
inline FreeQueries ask_free_positions(const Tray& tray, const std::vector<PlacedCopy>& placed, PlacementSearch& engine,
                                      PlacementSearch* plain, int samples) {
    FreeQueries queries;
    const std::size_t every = std::max<std::size_t>(1, placed.size() / static_cast<std::size_t>(std::max(1, samples)));
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PlacedCopy& copy = placed[i];
        const TrayObject& object = tray.object(copy.object);
        VoxelBox rest;
        for (const PlacedCopy& other : placed) {
            if (other.object != copy.object) rest = hull(rest, tray.object(other.object).box());
        }
        const FreeQuery query{.without = copy.object};
        queries.walks.time([&] {
            const auto tiles = engine.free_tiles(tray, object.solid, query);
            ReachableRegion region(*tiles, object.solid->extent(), rest, {});
            queries.ways += region.contains(object.position - tiles->origin());
        });
        if (i % every != every / 2) continue;
        Shape shape;
        shape.orientations.emplace_back().solid = object.solid;  // of which alone is asked
        FreePositions of_engine, of_plain;
        queries.all.time([&] { of_engine = engine.free_positions(tray, shape, 0, query); });
        if (plain == nullptr) continue;
        queries.plain.time([&] { of_plain = plain->free_positions(tray, shape, 0, query); });
        queries.differ += of_engine.origin != of_plain.origin || of_engine.free != of_plain.free;
    }
    return queries;
}

}  // namespace spectralpack
