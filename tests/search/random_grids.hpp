#pragma once
/// Small random grids of bits and what else is drawn for tests. Everything follows from the RandomStream, so a seed
/// names a grid on every machine. Grids are non-cubic, widened grids have negative offsets.

#include <algorithm>

#include "core/random.hpp"
#include "voxel/axis_turn.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/widen.hpp"

namespace spectralpack::test {

/// True with probability 1 / n.
inline bool one_in(RandomStream& random, int n) { return random.below(static_cast<std::uint64_t>(n)) == 0; }

/// Uniform in [low, high].
inline int between(RandomStream& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

inline Extent random_extent(RandomStream& random, const Extent& least, const Extent& most) {
    Extent extent;
    for (int axis = 0; axis < 3; ++axis) {
        extent[axis] = between(random, least[axis], most[axis]);
    }
    return extent;
}

/// Calls visit(x, y, z) for every voxel, x fastest.
template <class Visit>
void for_each_voxel(const Extent& extent, const Visit& visit) {
    for (int z = 0; z < extent.z; ++z) {
        for (int y = 0; y < extent.y; ++y) {
            for (int x = 0; x < extent.x; ++x) {
                visit(x, y, z);
            }
        }
    }
}

/// Each voxel set with probability 1 / n.
inline BitGrid random_bits(RandomStream& random, const Extent& extent, int n) {
    BitGrid bits(extent);
    for_each_voxel(extent, [&](int x, int y, int z) { bits.set(x, y, z, one_in(random, n)); });
    return bits;
}

/// Never empty: a full box, a hollow box, a tube, a comb (teeth along x), sparse or dense noise.
inline BitGrid random_solid(RandomStream& random, const Extent& e) {
    BitGrid bits(e);
    const int kind = between(random, 0, 5);
    const auto inside = [](int i, int n) { return i > 0 && i < n - 1; };
    if (kind >= 4) {
        bits = random_bits(random, e, kind == 4 ? 2 : 6);
        const Extent any = random_extent(random, {0, 0, 0}, {e.x - 1, e.y - 1, e.z - 1});
        bits.set(any.x, any.y, any.z);
        return bits;
    }
    for_each_voxel(e, [&](int x, int y, int z) {
        bool solid = true;
        if (kind == 1) solid = !(inside(x, e.x) && inside(y, e.y) && inside(z, e.z));
        if (kind == 2) solid = !(inside(x, e.x) && inside(z, e.z));
        if (kind == 3) solid = y == 0 || x % 2 == 0;
        bits.set(x, y, z, solid);
    });
    return bits;
}

/// Contains `solid`, reaches up to `reach` voxels further on each side (each side its own), rough
/// outside.
inline WidenedVoxels random_widened(RandomStream& random, const BitGrid& solid, int reach) {
    const Extent none{0, 0, 0}, most{reach, reach, reach};
    const Extent low = random_extent(random, none, most), high = random_extent(random, none, most);
    const Extent& a = solid.extent();
    BitGrid voxels = random_bits(random, {a.x + low.x + high.x, a.y + low.y + high.y, a.z + low.z + high.z}, 3);
    unite(voxels, solid, {low.x, low.y, low.z});
    return {LazyGrid(std::move(voxels)), {-low.x, -low.y, -low.z}};
}

/// Exchanges, and where `reverses` reverses, some axes.
inline AxisTurn random_turn(RandomStream& random, bool reverses) {
    AxisTurn turn;
    for (int k = between(random, 0, 5); k > 0; --k)
        std::ranges::next_permutation(turn.order);
    for (bool& reversed : turn.reversed) {
        reversed = reverses && one_in(random, 2);
    }
    return turn;
}

}  // namespace spectralpack::test
