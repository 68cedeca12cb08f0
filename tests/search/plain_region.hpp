#pragma once
/// Positions from which outside can be reached, by plain breadth-first search over free positions.

#include <deque>

#include "search/placement_search.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {

/// Where `solid` does not meet `still`, with a rim outside of it.
inline FreePositions free_beside(const BitGrid& still, const BitGrid& solid) {
    const Extent &n = still.extent(), &a = solid.extent();
    FreePositions result{{-a.x, -a.y, -a.z}, BitGrid({n.x + a.x + 1, n.y + a.y + 1, n.z + a.z + 1})};
    for_each_voxel(result.free.extent(), [&](int x, int y, int z) {
        result.free.set(x, y, z, !intersects(still, solid, result.origin + VoxelIndex{x, y, z}));
    });
    return result;
}

/// Of the same grid as `free`, whose rim lies wholly outside the tray.
inline BitGrid plain_region(const FreePositions& free) {
    const Extent& e = free.free.extent();
    BitGrid region(e);
    std::deque<VoxelIndex> open;
    const auto reach = [&](const VoxelIndex& q) {
        if (!e.contains(q) || !free.free.get(q.x, q.y, q.z) || region.get(q.x, q.y, q.z)) return;
        region.set(q.x, q.y, q.z);
        open.push_back(q);
    };
    for (int z = 0; z < e.z; ++z) {
        for (int y = 0; y < e.y; ++y) {
            for (int x = 0; x < e.x; ++x) {
                const bool rim = x == 0 || y == 0 || z == 0 || x == e.x - 1 || y == e.y - 1 || z == e.z - 1;
                if (rim) reach({x, y, z});
            }
        }
    }
    while (!open.empty()) {
        const VoxelIndex at = open.front();
        open.pop_front();
        for (int move = 0; move < 6; ++move) {
            VoxelIndex next = at;
            next[move / 2] += move % 2 == 0 ? 1 : -1;
            reach(next);
        }
    }
    return region;
}

}  // namespace spectralpack::test
