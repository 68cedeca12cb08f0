#pragma once
/// Where objects are what is nearest: what phi owes to those that came since some time, and so where it can have fallen
/// since then, whatever else came and went.
///
/// Invariant, for every object that stands and came since these began: its box holds all voxels whose nearest occupied
/// one is its own and none of an object that came before it. If phi(v) is less than when an object last stood alone
/// among the older ones, the first come of the objects nearest to v is newer, and v lies in its box.

#include <cstddef>
#include <vector>

#include "search/cpu/tables/distance_grid.hpp"
#include "search/tray.hpp"

namespace spectralpack {

class ObjectCells {
  public:
    /// An object came, newer than all others; phi fell within `fell`.
    void add(ObjectId id, const VoxelBox& object, const VoxelBox& fell);
    /// These went; `reaches` are the boxes in which phi may have risen or the nearest object be another
    /// (DistanceGrid::reach_of()).
    void remove(const std::vector<ObjectId>& ids, const std::vector<VoxelBox>& reaches);
    /// The boxes of objects from `first` on, for phi as it is.
    std::vector<VoxelBox> of_newer(ObjectId first, const DistanceGrid& phi);

  private:
    struct Cell {
        ObjectId id;
        VoxelBox object, box;
        std::size_t added;  // objects there had been when the box was worked out
        bool valid;
    };

    std::vector<Cell> cells_;  // by ascending id
    std::size_t added_ = 0;
};

}  // namespace spectralpack
