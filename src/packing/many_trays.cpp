#include "packing/many_trays.hpp"

namespace spectralpack {

std::int64_t TraysResult::searches() const {
    std::int64_t sum = 0;
    for (const FilledTray& tray : trays) {
        sum += tray.searches;
    }
    return sum;
}

std::int64_t TraysResult::placed() const {
    std::size_t sum = 0;
    for (const FilledTray& tray : trays) {
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
        FilledTray& tray = result.trays.emplace_back();
        try {
            filler.fill(
                remaining, make_shapes, [&](std::size_t done) { item_done(tray, done); }, stop, tray);
        } catch (...) {
            result.left_over = tray.left_over;
            throw;
        }
        result.left_over = remaining = tray.left_over;
        // What was interlocked here may stand in the next tray; it goes first, as it is no smaller.
        remaining.insert(remaining.begin(), tray.interlocked.begin(), tray.interlocked.end());
        stopped = !tray.untried.empty();
    } while (!remaining.empty() && !stopped && static_cast<int>(result.trays.size()) < most);
}

}  // namespace spectralpack
