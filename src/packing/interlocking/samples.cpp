#include "packing/interlocking/samples.hpp"

#include <algorithm>

#include "voxel/split.hpp"

namespace spectralpack {

BitGrid row_sample(const BitGrid& solid, int rows_along) {
    const Extent& n = solid.extent();
    const int step = std::max(1, std::max({n.x, n.y, n.z}) / rows_along);
    BitGrid sample(n);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            if ((y + z) % step == 0) std::copy_n(solid.row(y, z), solid.words_per_row(), sample.row(y, z));
        }
    }
    return sample;
}

BitGrid sample_in_cells(const BitGrid& sample) {
    const Extent& n = sample.extent();
    BitGrid cells({n.x, (n.y + 1) / 2, (n.z + 1) / 2});
    for (int z = 0; z < cells.extent().z; ++z) {
        for (int y = 0; y < cells.extent().y; ++y) {
            std::copy_n(sample.row(2 * y, 2 * z), cells.words_per_row(), cells.row(y, z));
        }
    }
    return cells;
}

BitGrid object_in_cells(const BitGrid& object) {
    const Extent& n = object.extent();
    BitGrid cells({n.x, std::max(1, n.y / 2), std::max(1, n.z / 2)});
    for (int z = 0; z < n.z / 2; ++z) {
        for (int y = 0; y < n.y / 2; ++y) {
            const BitGrid::Word* const rows[] = {object.row(2 * y, 2 * z), object.row(2 * y + 1, 2 * z),
                                                 object.row(2 * y, 2 * z + 1), object.row(2 * y + 1, 2 * z + 1)};
            for (int w = 0; w < cells.words_per_row(); ++w) {
                cells.row(y, z)[w] = rows[0][w] & rows[1][w] & rows[2][w] & rows[3][w];
            }
        }
    }
    return cells;
}

VoxelIndex cell_of(const VoxelIndex& position) {
    return {position.x, floor_div(position.y, 2), floor_div(position.z, 2)};
}

}  // namespace spectralpack
