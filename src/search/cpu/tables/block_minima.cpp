#include "search/cpu/tables/block_minima.hpp"

#include <algorithm>
#include <limits>

#include "search/cpu/tables/kernels.hpp"

namespace spectralpack {

BlockLayout::BlockLayout(const Extent& grid, int block)
    : blocks_{(grid.x + block - 1) / block, (grid.y + block - 1) / block, (grid.z + block - 1) / block},
      block_(block) {}

BlockMinima::BlockMinima(const Extent& grid, int block)
    : BlockLayout(grid, block), values_(static_cast<std::size_t>(blocks_.count() + 2 * blocks_.x) + kOverrun, 0) {}

void BlockMinima::update(const DistanceGrid& phi, const VoxelBox& changed, const Workers& workers) {
    const VoxelBox box = intersection(changed, whole(phi.extent()));
    if (box.empty()) return;
    const int first = box.lo.x / block_;
    const int last = (box.hi.x - 1) / block_;
    const int begin_z = box.lo.z / block_;
    const int count_z = (box.hi.z - 1) / block_ + 1 - begin_z;
    const int lo = first * block_;
    const int hi = std::min(phi.extent().x, (last + 1) * block_);
    workers.for_ranges(count_z, 4, [&](std::int64_t begin, std::int64_t end) {
        std::vector<std::uint16_t> least(static_cast<std::size_t>(hi - lo));
        for (int bz = begin_z + static_cast<int>(begin); bz < begin_z + static_cast<int>(end); ++bz) {
            for (int by = box.lo.y / block_; by <= (box.hi.y - 1) / block_; ++by) {
                std::ranges::fill(least, std::numeric_limits<std::uint16_t>::max());
                for (int z = bz * block_; z < std::min(phi.extent().z, (bz + 1) * block_); ++z) {
                    for (int y = by * block_; y < std::min(phi.extent().y, (by + 1) * block_); ++y) {
                        kernels().min_rows(least.data(), least.data(), phi.row(y, z) + lo, least.size());
                    }
                }
                std::uint16_t* out = values_.data() + offset({0, by, bz});
                for (int bx = first; bx <= last; ++bx) {
                    const auto from = least.begin() + (bx - first) * block_;
                    out[bx] = *std::min_element(from, std::min(from + block_, least.end()));
                }
            }
        }
    });
}

}  // namespace spectralpack
