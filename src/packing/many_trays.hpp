#pragma once
/// Several trays, one after the other (appendix A.3, Algorithm 5).

#include <functional>
#include <vector>

#include "packing/tray_filler.hpp"

namespace spectralpack {

struct TraysResult {
    std::vector<FilledTray> trays;
    std::vector<PackItem> left_over;  ///< found no place in the last tray either; what else is not placed was interlocked there or not tried

    std::int64_t searches() const;
    std::int64_t placed() const;
};

/// Called after each item with the tray it was tried in and how many of that tray's items are done.
using TrayItemDone = std::function<void(const FilledTray& tray, std::size_t items_done)>;

/// Fills at most `most` trays with `items`, which come in the order to try; what found no place in one tray is tried
/// in the next. `result` is filled as it goes, so that it holds what was done when an exception leaves this function.
void fill_trays(const std::vector<PackItem>& items, int most, TrayFiller& filler,
                const MakeShapeStore& make_shapes, const TrayItemDone& item_done, const StopToken& stop,
                TraysResult& result);

}  // namespace spectralpack
