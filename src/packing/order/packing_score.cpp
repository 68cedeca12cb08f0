#include "packing/order/packing_score.hpp"

#include <algorithm>
#include <map>

namespace spectralpack {

PackingScore score_packing(const std::vector<Copy>& copies, const std::vector<const std::vector<PlacedCopy>*>& trays,
                           const PackingMeasures& measures) {
    std::map<int, std::int64_t> missing;  // copies by part
    for (const Copy& copy : copies) {
        ++missing[copy.part];
    }
    PackingScore score;
    for (const std::vector<PlacedCopy>* tray : trays) {
        score.top = 0;
        ++score.trays;
        for (const PlacedCopy& placed : *tray) {
            --missing[placed.copy.part];
            score.top = std::max(score.top, measures.top(placed));
        }
    }
    for (const auto& [part, count] : missing) {
        score.copies += count;
        score.left_over += static_cast<double>(count) * std::max(0.0, measures.volume(part));
    }
    return score;
}

}  // namespace spectralpack
