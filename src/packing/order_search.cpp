#include "packing/order_search.hpp"

#include <set>
#include <utility>

#include "core/random.hpp"

namespace spectralpack {
namespace {

/// The best of several packings of the same copies.
class Best {
  public:
    Best(const std::vector<PackItem>& items, const PackingMeasures& measures) : items_(items), measures_(measures) {}

    /// `order`: what `trays` were packed in.
    void consider(const std::vector<PackItem>& order, TraysResult trays) {
        searches_ += trays.searches();
        ++packings_;
        std::vector<const std::vector<PlacedItem>*> placed;
        for (const FilledTray& tray : trays.trays) {
            placed.push_back(&tray.placed);
        }
        const PackingScore score = score_packing(items_, placed, measures_);
        if (packings_ > 1 && !(score < score_)) return;
        score_ = score;
        order_ = order;
        trays_ = std::move(trays);
    }

    FoundOrder found() && {
        FoundOrder found;
        std::set<PackItem> placed;
        for (const FilledTray& tray : trays_.trays) {
            for (const PlacedItem& copy : tray.placed) {
                found.items.push_back(copy.item);
                placed.insert(copy.item);
            }
        }
        const std::vector<PackItem> rest = without(order_, placed);
        found.items.insert(found.items.end(), rest.begin(), rest.end());
        if (!trays_.trays.empty()) trays_.trays.front().searches += searches_ - trays_.searches();
        found.trays = std::move(trays_);
        found.packings = packings_;
        return found;
    }

  private:
    const std::vector<PackItem>& items_;
    const PackingMeasures& measures_;
    std::vector<PackItem> order_;
    TraysResult trays_;
    PackingScore score_;
    std::int64_t searches_ = 0;
    int packings_ = 0;
};

}  // namespace

FoundOrder find_order(const std::vector<PackItem>& items, const OrderSearch& search, const PackInOrder& pack,
                      const StopToken& stop) {
    Best best(items, search.measures);
    const auto attempt = [&](const std::vector<PackItem>& order, bool beam) {
        std::optional<TraysResult> trays = pack(order, beam);
        if (trays) best.consider(order, std::move(*trays));
    };
    attempt(items, false);
    if (search.beam > 1 && !stop.stopped()) attempt(items, true);
    RandomStream random(search.seed);
    for (int i = 1; i < search.restarts && !stop.stopped(); ++i) {
        attempt(perturbed(items, search.ranks, random), false);
    }
    return std::move(best).found();
}

}  // namespace spectralpack
