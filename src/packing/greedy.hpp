#pragma once
/// Greedy packing (Algorithm 2): copies in order, each at its best placement among those already placed.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/stop.hpp"
#include "packing/order.hpp"
#include "packing/shape_store.hpp"
#include "packing/standing.hpp"
#include "search/placement_search.hpp"

namespace spectralpack {

struct PlacedItem {
    PackItem item;
    int orientation = 0;  ///< index in the orientation set
    VoxelIndex position;
    Vec3 offset;          ///< mm by which the turned mesh is moved to where the copy stands
    ObjectId object = 0;  ///< in the tray
    Cost cost;
};

/// Called after each item with how many are done.
using ItemDone = std::function<void(std::size_t items_done)>;

struct GreedyResult {
    std::vector<PlacedItem> placed;   ///< in the order placed
    std::vector<PackItem> left_over;  ///< no free candidate was left for them, in the order tried
    std::vector<PackItem> untried;    ///< the stop token came first
    std::int64_t searches = 0;        ///< copies really searched for
};

/// Packs `items` into `tray` on top of what stands there; `shapes` has been told of them (start_tray). A copy whose
/// part has already found no place is left over without a search: the tray only fills up. `settle` decides where a
/// copy stands once its place is found. `result` is filled as it goes, so that it holds what was done when an
/// exception (out of memory, two engines that disagree) leaves this function.
void pack_greedily(Tray& tray, PlacementSearch& search, const CostModel& model,
                   const std::vector<PackItem>& items, ShapeStore& shapes, const Settle& settle,
                   const ItemDone& item_done, const StopToken& stop, GreedyResult& result);

}  // namespace spectralpack
