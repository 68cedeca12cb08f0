#include "geometry/box_index.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {

BoxIndex::BoxIndex(const Box& region) : origin_(region.min) {
    const Vec3 size = region.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (longest > 0) cell_ = longest / kCells;
    for (int axis = 0; axis < 3; ++axis) {
        count_[axis] = std::clamp(static_cast<int>(std::ceil(size[axis] / cell_)), 1, kCells);
    }
    cells_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
}

template <class Visit>
void BoxIndex::for_cells(const Box& box, Visit visit) const {
    if (box.empty()) return;
    int low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double last = count_[axis] - 1;
        const double from = std::floor((box.min[axis] - origin_[axis]) / cell_);
        const double to = std::floor((box.max[axis] - origin_[axis]) / cell_);
        low[axis] = static_cast<int>(std::clamp(from, 0.0, last));
        high[axis] = static_cast<int>(std::clamp(to, 0.0, last));
    }
    for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int x = low[0]; x <= high[0]; ++x) {
                visit(static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x));
            }
        }
    }
}

void BoxIndex::add(std::int64_t id, const Box& box) {
    for_cells(box, [&](std::size_t cell) { cells_[cell].push_back(id); });
}

void BoxIndex::remove(std::int64_t id, const Box& box) {
    for_cells(box, [&](std::size_t cell) { std::erase(cells_[cell], id); });
}

std::vector<std::int64_t> BoxIndex::near(const Box& box) const {
    std::vector<std::int64_t> ids;
    for_cells(box, [&](std::size_t cell) { ids.insert(ids.end(), cells_[cell].begin(), cells_[cell].end()); });
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

}  // namespace spectralpack
