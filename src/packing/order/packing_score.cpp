#include "packing/order/packing_score.hpp"

#include <algorithm>
#include <map>

namespace spectralpack {

PackingScore score_packing(const std::vector<PackItem>& items, const std::vector<const std::vector<PlacedItem>*>& trays,
                           const PackingMeasures& measures) {
    std::map<int, std::int64_t> missing;  // copies by part
    for (const PackItem& item : items) {
        ++missing[item.part];
    }
    PackingScore score;
    for (const std::vector<PlacedItem>* tray : trays) {
        score.top = 0;
        ++score.trays;
        for (const PlacedItem& placed : *tray) {
            --missing[placed.item.part];
            score.top = std::max(score.top, measures.top(placed));
        }
    }
    for (const auto& [part, copies] : missing) {
        score.copies += copies;
        score.left_over += static_cast<double>(copies) * std::max(0.0, measures.volume(part));
    }
    return score;
}

}  // namespace spectralpack
