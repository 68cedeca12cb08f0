#pragma once
/// What packing needs besides the tray that is packed, handed down as one. All that is referred to outlives it.

#include "core/parallel.hpp"
#include "packing/tray/caps.hpp"
#include "packing/tray/decisions.hpp"
#include "packing/tray/shape_store.hpp"
#include "packing/tray/tray_observer.hpp"
#include "search/placement_search.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// The same for all trays.
struct PackContext {
    PlacementSearch& search;  ///< answers for every tray
    ShapeStore& shapes;
    Workers workers;
    StopToken stop = {};
    TrayObserver* observer = nullptr;  ///< null: nobody is told
    Decisions* decisions = nullptr;    ///< null: none are known, and nobody keeps them
};

/// What else decides whether a copy is placed.
struct PlaceLimits {
    Caps* caps = nullptr;   ///< of this tray; null: none
    int most_layers = 0;    ///< without a ceiling: how high the grid may grow; 0: as it needs
    int give_up_after = 0;  ///< parts that find no place; the rest is not tried then. 0: never
};

/// For one tray.
struct TrayContext : PackContext {
    int number = 0;  ///< of the tray, from 0
    CostModel model = {};
    PlaceLimits limits = {};
    Settle settle = {};  ///< where copies come to stand that are packed (not those that are put back)
};

}  // namespace spectralpack
