#include "search/cpu/depths.hpp"

#include <algorithm>

#include "search/cpu/kernels.hpp"

namespace spectralpack {

Depths::Depths(const BitGrid& solid, const Runs& runs)
    : extent_(solid.extent()),
      step_{1, extent_.x + 1, static_cast<std::ptrdiff_t>(extent_.x + 1) * extent_.y},
      depth_(static_cast<std::size_t>(2 * kMargin + step_[2] * extent_.z)) {
    // Along the runs' own axis each voxel's distance to the nearer end; then the other two axes, both ways.
    for (const Run& run : runs.runs) {
        std::uint8_t* voxel = depth_.data() + row(run.start.y, run.start.z) + run.start.x;
        for (int i = 0; i < run.length; ++i, voxel += step_[runs.axis]) {
            *voxel = static_cast<std::uint8_t>(std::min({i + 1, run.length - i, kDeepest}));
        }
    }
    if (runs.axis != 2) lower_from_neighbours(row(0, 0), step_[2], extent_.z, step_[2]);
    for (int z = 0; z < extent_.z; ++z) {
        if (runs.axis != 1) lower_from_neighbours(row(0, z), step_[1], extent_.y, extent_.x);
        if (runs.axis != 0) lower_along_x(z);
    }
}

/// By doubling, a layer at once. What is read from other rows is no less than a row's own end is far: no harm is done.
void Depths::lower_along_x(int z) {
    std::uint8_t* layer = depth_.data() + row(0, z);
    const auto count = static_cast<std::size_t>(step_[2]);
    std::uint8_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        most = std::max(most, layer[i]);
    }
    // What lies as far as the greatest value lowers nothing.
    for (int by = 1; by < most; by *= 2) {
        lower_bytes(layer, layer - by, static_cast<std::uint8_t>(by), count);
        lower_bytes(layer, layer + by, static_cast<std::uint8_t>(by), count);
    }
}

/// Of `count` rows or layers of `length` voxels, `step` apart, each from the one before it and the one behind it.
void Depths::lower_from_neighbours(std::ptrdiff_t first, std::ptrdiff_t step, int count, std::ptrdiff_t length) {
    const std::vector<std::uint8_t> outside(static_cast<std::size_t>(length), 0);
    const auto lower = [&](int i, int from) {
        const bool inside = from >= 0 && from < count;
        std::uint8_t* all = depth_.data() + first;
        lower_bytes(all + i * step, inside ? all + from * step : outside.data(), 1, static_cast<std::size_t>(length));
    };
    for (int i = 0; i < count; ++i)
        lower(i, i - 1);
    for (int i = count - 1; i >= 0; --i)
        lower(i, i + 1);
}

std::uint32_t Depths::sum(const Run& run, int axis) const {
    const std::uint8_t* voxel = depth_.data() + row(run.start.y, run.start.z) + run.start.x;
    std::uint32_t sum = 0;
    for (int i = 0; i < run.length; ++i, voxel += step_[axis]) {
        sum += *voxel;
    }
    return sum;
}

std::vector<std::uint32_t> Depths::sums(const Runs& runs) const {
    std::vector<std::uint32_t> sums;
    sums.reserve(runs.runs.size());
    for (const Run& run : runs.runs) {
        sums.push_back(sum(run, runs.axis));
    }
    return sums;
}

}  // namespace spectralpack
