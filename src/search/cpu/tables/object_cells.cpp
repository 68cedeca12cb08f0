#include "search/cpu/tables/object_cells.hpp"

#include <algorithm>

#include "search/cpu/tuning.hpp"

namespace spectralpack {

void ObjectCells::add(ObjectId id, const VoxelBox& object, const VoxelBox& fell) {
    // Voxels that it shares with others did not fall.
    cells_.push_back({id, object, hull(object, fell), ++added_, true});
}

void ObjectCells::remove(const std::vector<ObjectId>& ids, const std::vector<VoxelBox>& reaches) {
    std::erase_if(cells_, [&](const Cell& cell) { return std::ranges::find(ids, cell.id) != ids.end(); });
    for (Cell& cell : cells_) {
        // What becomes a cell's lies in a reach, and so do the ways from there to the object as far as they do not lie
        // in its box already.
        const VoxelBox around{cell.box.lo - VoxelIndex{1, 1, 1}, cell.box.hi + VoxelIndex{1, 1, 1}};
        cell.valid = cell.valid && std::ranges::all_of(reaches, [&](const VoxelBox& reach) {
                         return intersection(around, reach).empty();
                     });
    }
}

std::vector<VoxelBox> ObjectCells::of_newer(ObjectId first, const DistanceGrid& phi) {
    std::vector<VoxelBox> boxes;
    for (auto cell = std::ranges::lower_bound(cells_, first, {}, &Cell::id); cell != cells_.end(); ++cell) {
        // Cells shrink as others come.
        if (!cell->valid || added_ - cell->added >= tuning::kAdditionsPerCell) {
            cell->box = phi.reach_of(cell->object);
            cell->added = added_;
            cell->valid = true;
        }
        boxes.push_back(cell->box);
    }
    return boxes;
}

}  // namespace spectralpack
