#include "packing/many_trays.hpp"

namespace spectralpack {

std::int64_t TraysResult::searches() const {
    std::int64_t sum = 0;
    for (const GreedyResult& tray : trays) {
        sum += tray.searches;
    }
    return sum;
}

std::int64_t TraysResult::placed() const {
    std::size_t sum = 0;
    for (const GreedyResult& tray : trays) {
        sum += tray.placed.size();
    }
    return static_cast<std::int64_t>(sum);
}

void fill_trays(const std::vector<PackItem>& items, int most, TrayFiller& filler,
                const MakeShapeStore& make_shapes, const TrayItemDone& item_done, const StopToken& stop,
                TraysResult& result) {
    std::vector<PackItem> remaining = items;
    bool stopped = false;
    do {
        GreedyResult& tray = result.trays.emplace_back();
        ShapeStore shapes = make_shapes(remaining);
        try {
            filler.fill(
                remaining, shapes, [&](std::size_t done) { item_done(tray, done); }, stop, tray);
        } catch (...) {
            result.left_over = tray.left_over;
            throw;
        }
        result.left_over = remaining = tray.left_over;
        stopped = !tray.untried.empty();
    } while (!remaining.empty() && !stopped && static_cast<int>(result.trays.size()) < most);
}

}  // namespace spectralpack
