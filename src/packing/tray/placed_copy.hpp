#pragma once
/// Where a copy really stands once its place on the grid is found: on the grid, or refined off it.

#include <functional>

#include "packing/order/order.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

struct Standing {
    Vec3 offset;        ///< mm by which the turned and scaled mesh is moved; the container's corner is the origin
    TrayObject object;  ///< what the tray holds of it
};

using Settle = std::function<Standing(const PackItem&, const Shape&, const BestPlacement&)>;

/// On the grid, whose lower corner is `wall_gap` inside the container.
Standing stand_on_grid(const Shape& shape, const BestPlacement& best, double voxel_size, int detail, double wall_gap);

}  // namespace spectralpack
