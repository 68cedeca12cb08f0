#include "search/cpu/depths.hpp"

#include <algorithm>

#include "search/cpu/kernels.hpp"

namespace spectralpack {
namespace {

/// row[i] = min over j of row[j] + |i - j|, 0 beyond both ends; for values up to kDeepest. `spare` is for its use.
void lower_along_x(std::uint8_t* row, std::size_t count, std::vector<std::uint8_t>& spare) {
    constexpr std::size_t kMargin = kDeepest / 2 + 1;  // the farthest step
    spare.assign(count + 2 * kMargin, 0);
    std::uint8_t* middle = spare.data() + kMargin;
    for (std::size_t by = 1; by <= std::min(kMargin, count); by *= 2) {
        std::copy_n(row, count, middle);
        lower_bytes(row, middle - by, static_cast<std::uint8_t>(by), count);
        lower_bytes(row, middle + by, static_cast<std::uint8_t>(by), count);
    }
}

}  // namespace

Depths::Depths(const BitGrid& solid, const Runs& runs)
    : step_{1, solid.extent().x, static_cast<std::ptrdiff_t>(solid.extent().x) * solid.extent().y},
      depth_(static_cast<std::size_t>(solid.extent().count())) {
    const Extent& n = solid.extent();
    const auto width = static_cast<std::size_t>(n.x);
    const auto layer = static_cast<std::size_t>(step_[2]);
    const auto row_at = [this](int y, int z) { return depth_.data() + row(y, z); };

    // Along the runs' own axis each voxel's distance to the nearer end; then the other two axes, both ways.
    for (const Run& run : runs.runs) {
        std::uint8_t* voxel = row_at(run.start.y, run.start.z) + run.start.x;
        for (int i = 0; i < run.length; ++i, voxel += step_[runs.axis]) {
            *voxel = static_cast<std::uint8_t>(std::min({i + 1, run.length - i, kDeepest}));
        }
    }
    const std::vector<std::uint8_t> outside(layer, 0);
    const auto lower = [&](int y, int z, const std::uint8_t* from) { lower_bytes(row_at(y, z), from, 1, width); };
    if (runs.axis != 0) {
        std::vector<std::uint8_t> spare;
        for (std::size_t at = 0; at < depth_.size(); at += width) {
            lower_along_x(depth_.data() + at, width, spare);
        }
    }
    if (runs.axis != 1) {
        for (int z = 0; z < n.z; ++z) {
            for (int y = 0; y < n.y; ++y)
                lower(y, z, y > 0 ? row_at(y - 1, z) : outside.data());
            for (int y = n.y - 1; y >= 0; --y)
                lower(y, z, y + 1 < n.y ? row_at(y + 1, z) : outside.data());
        }
    }
    if (runs.axis != 2) {
        const auto lower_layer = [&](int z, int from) {
            lower_bytes(row_at(0, z), from >= 0 && from < n.z ? row_at(0, from) : outside.data(), 1, layer);
        };
        for (int z = 0; z < n.z; ++z)
            lower_layer(z, z - 1);
        for (int z = n.z - 1; z >= 0; --z)
            lower_layer(z, z + 1);
    }
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
