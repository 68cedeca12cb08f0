#pragma once
/// The orders in which lists are walked, and what lists take.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "spectralpack/grid.hpp"

namespace spectralpack {

/// The bits of i + 1 reversed, given those of i; both are below `size`, a power of two. 0 after the last one.
inline std::size_t after_reversed(std::size_t reversed, std::size_t size) {
    std::size_t bit = size / 2;
    for (; reversed & bit; bit /= 2) {
        reversed ^= bit;
    }
    return reversed | bit;
}

/// Calls visit(i), until it answers false, once for each i in [0, count): every n-th in ascending order, then every
/// n-th from another start, so that each stretch of about `stretch` is spread over all and yet walks memory in one
/// direction. True if it never did.
template <class Visit>
bool for_each_spread(std::size_t count, std::size_t stretch, const Visit& visit) {
    const std::size_t strides = (count + stretch - 1) / stretch;
    std::size_t size = 1;
    while (size < strides)
        size *= 2;
    std::size_t start = 0;  // i with its bits reversed: consecutive starts lie far apart
    for (std::size_t i = 0; i < size; ++i, start = after_reversed(start, size)) {
        if (start >= strides) continue;
        for (std::size_t k = start; k < count; k += strides) {
            if (!visit(k)) return false;
        }
    }
    return true;
}

/// Indices of `items`: what `level` rates highest comes first (levels 0 .. levels - 1); among equals, bunches of
/// `bunch` neighbours, as for_each_spread() spreads them.
template <class T, class Level>
std::vector<std::uint32_t> by_level(const std::vector<T>& items, std::size_t levels, std::size_t stretch,
                                    std::size_t bunch, const Level& level) {
    const auto shelf_of = [&](const T& item) { return levels - 1 - static_cast<std::size_t>(level(item)); };
    std::vector<std::size_t> end(levels + 1, 0);
    for (const T& item : items) {
        ++end[shelf_of(item) + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint32_t> shelved(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        shelved[end[shelf_of(items[i])]++] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::uint32_t> result(items.size());
    std::uint32_t* next = result.data();
    for (std::size_t shelf = 0, begin = 0; shelf < levels; begin = end[shelf++]) {
        const std::uint32_t* const from = shelved.data() + begin;
        const std::size_t count = end[shelf] - begin;
        for_each_spread((count + bunch - 1) / bunch, stretch, [&](std::size_t i) {
            for (std::size_t k = i * bunch; k < std::min(count, (i + 1) * bunch); ++k) {
                *next++ = from[k];
            }
            return true;
        });
    }
    return result;
}

/// Indices of voxels by z, y, x, none of which is negative: what asks for them then walks memory in one direction. Of
/// those that have the axes from `first` on in common the order is right already. By counting, an axis at a time:
/// O(voxels + extents).
inline std::vector<std::uint32_t> by_place(const std::vector<VoxelIndex>& voxels, int first) {
    std::vector<std::uint32_t> order(voxels.size()), before(voxels.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::uint32_t> begin;
    for (int axis = first; axis < 3; ++axis) {
        int VoxelIndex::*const along = axis == 0 ? &VoxelIndex::x : axis == 1 ? &VoxelIndex::y : &VoxelIndex::z;
        int last = 0;
        for (const VoxelIndex& voxel : voxels) {
            last = std::max(last, voxel.*along);
        }
        begin.assign(static_cast<std::size_t>(last) + 2, 0);
        for (const VoxelIndex& voxel : voxels) {
            ++begin[static_cast<std::size_t>(voxel.*along) + 1];
        }
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        before.swap(order);
        for (const std::uint32_t i : before) {
            order[begin[static_cast<std::size_t>(voxels[i].*along)]++] = i;
        }
    }
    return order;
}

/// What a list holds, in bytes.
template <class T>
std::int64_t bytes_of(const std::vector<T>& list) {
    return static_cast<std::int64_t>(list.capacity() * sizeof(T));
}

}  // namespace spectralpack
