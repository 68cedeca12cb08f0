#pragma once
/// Where a copy stands that no way out was found for: it has none as long as nobody leaves who has voxels there.

#include "search/tray.hpp"
#include "voxel/bit_grid.hpp"
#include "voxel/voxel_box.hpp"

namespace spectralpack {

class ClosedRegion {
  public:
    /// All of this box.
    explicit ClosedRegion(const VoxelBox& box) : box_(box) {}
    /// The voxels that `solid` fills at some of these positions; of wide ranges of them the box around. O(words of the
    /// box around, log positions).
    ClosedRegion(const BitGrid& solid, const VoxelBox& positions);

    /// Whether the object, of the same grid, has voxels in it. O(words where their boxes meet).
    bool touches(const TrayObject& object) const;

  private:
    VoxelBox box_;
    BitGrid voxels_;  // from box_.lo on; none: all of the box
};

}  // namespace spectralpack
