#include "search/cpu/shapes/depths.hpp"

#include <algorithm>

#include "search/cpu/tables/kernels.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

/// delta of every voxel of a solid's grid.
class DepthGrid {
  public:
    DepthGrid(const BitGrid& solid, const Runs& runs)
        : extent_(solid.extent()),
          step_{1, extent_.x + 1, static_cast<std::ptrdiff_t>(extent_.x + 1) * extent_.y},
          depth_(static_cast<std::size_t>(2 * kMargin + step_[2] * extent_.z)) {
        // Along the runs' own axis each voxel's distance to the nearer end; then the other two axes, both ways.
        for (const Run& run : runs.runs) {
            std::uint8_t* voxel = depth_.data() + place(run.start.y, run.start.z) + run.start.x;
            for (int i = 0; i < run.length; ++i, voxel += step_[runs.axis]) {
                *voxel = static_cast<std::uint8_t>(std::min({i + 1, run.length - i, kDeepest}));
            }
        }
        if (runs.axis != 2) lower_from_neighbours(place(0, 0), step_[2], extent_.z, step_[2]);
        for (int z = 0; z < extent_.z; ++z) {
            if (runs.axis != 1) lower_from_neighbours(place(0, z), step_[1], extent_.y, extent_.x);
            if (runs.axis != 0) lower_along_x(z);
        }
    }

    const std::uint8_t* row(int y, int z) const { return depth_.data() + place(y, z); }

  private:
    /// Of voxel (0, y, z), in depth_.
    std::ptrdiff_t place(int y, int z) const { return kMargin + step_[2] * z + step_[1] * y; }

    /// By doubling, a layer at once. What is read from other rows is no less than a row's own end is far: no harm is
    /// done.
    void lower_along_x(int z) {
        std::uint8_t* layer = depth_.data() + place(0, z);
        const auto count = static_cast<std::size_t>(step_[2]);
        std::uint8_t most = 0;
        for (std::size_t i = 0; i < count; ++i) {
            most = std::max(most, layer[i]);
        }
        // What lies as far as the greatest value lowers nothing.
        for (int by = 1; by < most; by *= 2) {
            kernels().lower_bytes(layer, layer - by, static_cast<std::uint8_t>(by), count);
            kernels().lower_bytes(layer, layer + by, static_cast<std::uint8_t>(by), count);
        }
    }

    /// Of `count` rows or layers of `length` voxels, `step` disjoint, each from the one before it and the one behind
    /// it.
    void lower_from_neighbours(std::ptrdiff_t first, std::ptrdiff_t step, int count, std::ptrdiff_t length) {
        const std::vector<std::uint8_t> outside(static_cast<std::size_t>(length), 0);
        const auto lower = [&](int i, int from) {
            const bool inside = from >= 0 && from < count;
            std::uint8_t* all = depth_.data() + first;
            kernels().lower_bytes(all + i * step, inside ? all + from * step : outside.data(), 1,
                                  static_cast<std::size_t>(length));
        };
        for (int i = 0; i < count; ++i)
            lower(i, i - 1);
        for (int i = count - 1; i >= 0; --i)
            lower(i, i + 1);
    }

    static constexpr std::ptrdiff_t kMargin = 32;  // the farthest that is looked along x at once

    Extent extent_;
    std::ptrdiff_t step_[3];  // from a voxel to the next along each axis
    // Rows have a 0 behind their end, and there are zeros before the first and behind the last.
    std::vector<std::uint8_t> depth_;
};

}  // namespace

Depths::Depths(const BitGrid& solid, const Runs& runs) : padded_(solid.extent()) {
    const Extent& n = solid.extent();
    ++padded_[runs.axis];
    VoxelIndex next;
    next[runs.axis] = 1;
    step_ = place(next);
    before_.assign(static_cast<std::size_t>(padded_.count()), 0);
    const DepthGrid depth(solid, runs);
    for (int z = 0; z < n.z; ++z) {
        for (int y = 0; y < n.y; ++y) {
            const std::uint8_t* delta = depth.row(y, z);
            std::uint32_t* before = before_.data() + place(0, y, z);
            for (int x = 0; x < n.x; ++x) {
                before[static_cast<std::size_t>(x) + step_] = before[x] + delta[x];
            }
        }
    }
}

Depths depths_of(const OrientedShape& shape, const Runs& solid, int detail) {
    if (detail == 1) return Depths(*shape.solid, solid);
    const BitGrid core = filled_voxels(*shape.fine, {}, detail).voxels;
    return Depths(core, runs_along(core, solid.axis));
}

std::vector<std::uint32_t> Depths::sums(const Runs& runs) const {
    std::vector<std::uint32_t> sums;
    sums.reserve(runs.runs.size());
    for (const Run& run : runs.runs) {
        sums.push_back(sum(run));
    }
    return sums;
}

}  // namespace spectralpack
