#include "core/checked.hpp"
#include "search/reference/reference_search.hpp"
#include "search/reference/transform.hpp"

namespace spectralpack {
namespace {

std::int64_t buffer_bytes(const Extent& grid, bool single_precision) {
    return single_precision ? FourierBuffer<float>::bytes(grid) : FourierBuffer<double>::bytes(grid);
}

/// Of a bit grid, without making it.
std::int64_t bit_bytes(const Extent& e) {
    const int words = (e.x + BitGrid::kWordBits - 1) / BitGrid::kWordBits;
    return checked_product({static_cast<std::int64_t>(sizeof(BitGrid::Word)), words, e.y, e.z});
}

}  // namespace

std::int64_t reference_memory(const ReferenceMemory& need) {
    const Extent grid = transform_extent(need.tray, need.overhang);
    const std::int64_t buffers = 2 * need.lanes + need.gap_classes + (need.blocked ? 1 : 0) + 1;
    return buffers * buffer_bytes(grid, need.single_precision) +
           checked_product({sizeof(std::int32_t), need.tray.count()}) + need.lanes * bit_bytes(need.tray);
}

std::int64_t reference_free_memory(const Extent& tray, const Extent& object, bool single_precision) {
    const VoxelIndex more{object.x - 1, object.y - 1, object.z - 1};
    return 3 * buffer_bytes(transform_extent(tray, more), single_precision) + bit_bytes(tray);
}

}  // namespace spectralpack
