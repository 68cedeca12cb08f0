#pragma once
/// A copy of a part: as it waits for a place, and where it stands once it has one, on the grid or refined off it.

#include <compare>
#include <functional>

#include "search/placement_search.hpp"

namespace spectralpack {

/// One instance of a part.
struct Copy {
    int part = 0;    ///< index into Packing::parts
    int number = 0;  ///< among the copies of that part, from 0

    auto operator<=>(const Copy&) const = default;
};

struct PlacedCopy {
    Copy copy;
    int orientation = 0;  ///< index in the orientation set
    VoxelIndex position;
    Vec3 offset;          ///< mm by which the turned mesh is moved to where the copy stands
    ObjectId object = 0;  ///< in the tray
    Cost cost;

    bool operator==(const PlacedCopy&) const = default;
};

/// Where a copy comes to stand.
struct Settled {
    Vec3 offset;        ///< mm by which the turned and scaled mesh is moved; the container's corner is the origin
    TrayObject object;  ///< what the tray holds of it
};

/// Decides that once its place on the grid is found.
using Settle = std::function<Settled(const Copy&, const Shape&, const BestPlacement&)>;

/// On the grid, whose lower corner is `wall_gap` inside the container.
Settled settle_on_grid(const Shape& shape, const BestPlacement& best, double voxel_size, int detail, double wall_gap);

}  // namespace spectralpack
