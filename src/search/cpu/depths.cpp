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
    const std::vector<std::uint8_t> outside(static_cast<std::size_t>(step_[2]), 0);
    if (runs.axis != 2) lower_along_z(outside);
    for (int z = 0; z < extent_.z; ++z) {
        if (runs.axis != 1) lower_along_y(z, outside);
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

void Depths::lower_along_y(int z, const std::vector<std::uint8_t>& outside) {
    std::uint8_t* layer = depth_.data() + row(0, z);
    const auto lower = [&](int y, int from) {
        const bool inside = from >= 0 && from < extent_.y;
        lower_bytes(layer + y * step_[1], inside ? layer + from * step_[1] : outside.data(), 1,
                    static_cast<std::size_t>(extent_.x));
    };
    for (int y = 0; y < extent_.y; ++y)
        lower(y, y - 1);
    for (int y = extent_.y - 1; y >= 0; --y)
        lower(y, y + 1);
}

void Depths::lower_along_z(const std::vector<std::uint8_t>& outside) {
    const auto lower = [&](int z, int from) {
        const bool inside = from >= 0 && from < extent_.z;
        lower_bytes(depth_.data() + row(0, z), inside ? depth_.data() + row(0, from) : outside.data(), 1,
                    static_cast<std::size_t>(step_[2]));
    };
    for (int z = 0; z < extent_.z; ++z)
        lower(z, z - 1);
    for (int z = extent_.z - 1; z >= 0; --z)
        lower(z, z + 1);
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
