#include "voxel/distance_field.hpp"

#include <algorithm>
#include <bit>
#include <vector>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// First voxel at or after `x` whose bit is `value`; nx where there is none.
int next_bit(const Word* row, int nx, int x, bool value) {
    while (x < nx) {
        const Word word = value ? row[x / BitGrid::kWordBits] : ~row[x / BitGrid::kWordBits];
        const Word rest = word >> (x % BitGrid::kWordBits);
        if (rest != 0) return std::min(nx, x + std::countr_zero(rest));
        x += BitGrid::kWordBits - x % BitGrid::kWordBits;
    }
    return nx;
}

/// Both sweeps along x at once: a run of free voxels climbs from both its ends, which are occupied
/// or walls.
void sweep_row(const Word* occupied, int nx, std::int32_t* row) {
    for (int x = 0; x < nx;) {
        const int begin = next_bit(occupied, nx, x, false);
        std::fill(row + x, row + begin, 0);
        const int end = next_bit(occupied, nx, begin, true);
        const int middle = begin + (end - begin + 1) / 2;
        for (int i = begin; i < middle; ++i) {
            row[i] = i - begin + 1;
        }
        for (int i = middle; i < end; ++i) {
            row[i] = end - i;
        }
        x = end;
    }
}

/// One step of a sweep along y or z: to = min(to, from + 1).
void step(std::int32_t* to, const std::int32_t* from, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
        to[i] = std::min(to[i], from[i] + 1);
    }
}

}  // namespace

Grid<std::int32_t> manhattan_distance(const BitGrid& occupied, Ceiling ceiling) {
    const Extent& n = occupied.extent();
    Grid<std::int32_t> phi(n);
    if (n.empty()) return phi;
    const std::int64_t layer = std::int64_t{n.x} * n.y;
    const std::vector<std::int32_t> wall(static_cast<std::size_t>(layer), 0);
    for (int z = 0; z < n.z; ++z) {
        std::int32_t* here = &phi.values()[static_cast<std::size_t>(z * layer)];
        for (int y = 0; y < n.y; ++y) {
            std::int32_t* row = here + std::int64_t{y} * n.x;
            sweep_row(occupied.row(y, z), n.x, row);
            step(row, y == 0 ? wall.data() : row - n.x, n.x);
        }
        for (int y = n.y; y-- > 0;) {
            std::int32_t* row = here + std::int64_t{y} * n.x;
            step(row, y + 1 == n.y ? wall.data() : row + n.x, n.x);
        }
        step(here, z == 0 ? wall.data() : here - layer, layer);
    }
    for (int z = n.z; z-- > 0;) {
        std::int32_t* here = &phi.values()[static_cast<std::size_t>(z * layer)];
        if (z + 1 < n.z) {
            step(here, here + layer, layer);
        } else if (ceiling == Ceiling::closed) {
            step(here, wall.data(), layer);
        }
    }
    return phi;
}

}  // namespace spectralpack
