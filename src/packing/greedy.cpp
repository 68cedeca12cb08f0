#include "packing/greedy.hpp"

#include <unordered_set>
#include <utility>

namespace spectralpack {

void pack_greedily(Tray& tray, PlacementSearch& search, const CostModel& model,
                   const std::vector<PackItem>& items, ShapeStore& shapes, const Settle& settle,
                   const ItemDone& item_done, const StopToken& stop, GreedyResult& result) {
    std::unordered_set<int> hopeless;  // parts that found no place
    for (std::size_t i = 0; i < items.size(); ++i) {
        const PackItem& item = items[i];
        bool placed = false;
        if (hopeless.contains(item.part)) {
            result.left_over.push_back(item);
        } else {
            if (stop.stopped()) {
                result.untried.assign(items.begin() + static_cast<std::ptrdiff_t>(i), items.end());
                return;
            }
            const Shape& shape = shapes.at(i);
            const SearchResult found = search.best_placement(tray, shape, model, stop);
            if (found.stopped) {
                result.untried.assign(items.begin() + static_cast<std::ptrdiff_t>(i), items.end());
                return;
            }
            ++result.searches;
            placed = found.best.has_value();
            if (placed) {
                const OrientedShape& oriented =
                    shape.orientations[static_cast<std::size_t>(found.best->index)];
                Standing standing = settle(item, shape, *found.best);
                const ObjectId object = tray.add(std::move(standing.object));
                result.placed.push_back({item, oriented.orientation, found.best->position,
                                         standing.offset, object, found.best->cost});
            } else {
                hopeless.insert(item.part);
                result.left_over.push_back(item);
            }
        }
        shapes.release(i, placed);
        item_done(i + 1);
    }
}

}  // namespace spectralpack
