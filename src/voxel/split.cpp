#include "voxel/split.hpp"

#include <algorithm>
#include <bit>

namespace spectralpack {
namespace {

using Word = BitGrid::Word;
constexpr int kWordBits = BitGrid::kWordBits;

/// How fine voxels lie in coarse ones.
struct Layout {
    VoxelIndex offset;  ///< coarse voxel of the grid's voxel (0,0,0)
    VoxelIndex rest;    ///< fine voxels from its lower corner to there
    Extent extent;      ///< coarse voxels that the grid touches
};

Layout layout_of(const Extent& fine, const VoxelIndex& at, int detail) {
    Layout layout;
    for (int axis = 0; axis < 3; ++axis) {
        layout.offset[axis] = floor_div(at[axis], detail);
        layout.rest[axis] = at[axis] - detail * layout.offset[axis];
        layout.extent[axis] = ceil_div(layout.rest[axis] + fine[axis], detail);
    }
    return layout;
}

/// Sets the coarse voxels whose fine ones, combined by `combine` (| or &), are all set.
template <class Combine>
CoarseVoxels pooled(const BitGrid& fine, const VoxelIndex& at, int detail, const Combine& combine) {
    const Layout layout = layout_of(fine.extent(), at, detail);
    CoarseVoxels result{BitGrid(layout.extent), layout.offset};
    const auto words = static_cast<std::size_t>(fine.words_per_row());
    const std::vector<Word> outside(words, 0);
    std::vector<Word> row(words);
    for (int z = 0; z < layout.extent.z; ++z) {
        for (int y = 0; y < layout.extent.y; ++y) {
            for (int i = 0; i < detail * detail; ++i) {
                const int fy = detail * y + i % detail - layout.rest.y;
                const int fz = detail * z + i / detail - layout.rest.z;
                const bool inside = fy >= 0 && fy < fine.extent().y && fz >= 0 && fz < fine.extent().z;
                const Word* from = inside ? fine.row(fy, fz) : outside.data();
                for (std::size_t w = 0; w < words; ++w) {
                    row[w] = i == 0 ? from[w] : combine(row[w], from[w]);
                }
            }
            Word* to = result.voxels.row(y, z);
            for (int x = 0; x < layout.extent.x; ++x) {
                Word all = 0;
                for (int i = 0; i < detail; ++i) {
                    const int fx = detail * x + i - layout.rest.x;
                    const bool inside = fx >= 0 && fx < fine.extent().x;
                    const Word bit = inside ? row[static_cast<std::size_t>(fx / kWordBits)] >> (fx % kWordBits) & 1 : 0;
                    all = i == 0 ? bit : combine(all, bit);
                }
                to[x / kWordBits] |= all << (x % kWordBits);
            }
        }
    }
    return result;
}

}  // namespace

SplitVoxels split(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {{fine}, at};
    const Layout layout = layout_of(fine.extent(), at, detail);
    SplitVoxels result{{static_cast<std::size_t>(part_count(detail)), BitGrid(layout.extent)}, layout.offset};
    for (int z = 0; z < fine.extent().z; ++z) {
        for (int y = 0; y < fine.extent().y; ++y) {
            const int fy = y + layout.rest.y, fz = z + layout.rest.z;
            const int first = (fz % detail * detail + fy % detail) * detail;
            const Word* row = fine.row(y, z);
            for (int w = 0; w < fine.words_per_row(); ++w) {
                for (Word bits = row[w]; bits != 0; bits &= bits - 1) {
                    const int fx = kWordBits * w + std::countr_zero(bits) + layout.rest.x;
                    result.parts[static_cast<std::size_t>(first + fx % detail)].set(fx / detail, fy / detail,
                                                                                   fz / detail);
                }
            }
        }
    }
    return result;
}

CoarseVoxels reached_voxels(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {fine, at};
    return pooled(fine, at, detail, [](Word a, Word b) { return a | b; });
}

CoarseVoxels filled_voxels(const BitGrid& fine, const VoxelIndex& at, int detail) {
    if (detail == 1) return {fine, at};
    return pooled(fine, at, detail, [](Word a, Word b) { return a & b; });
}

}  // namespace spectralpack
