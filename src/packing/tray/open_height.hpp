#pragma once
/// Packing without a ceiling: the grid is as high as it has to be, and its height never shows in the answer.

#include "search/placement_search.hpp"

namespace spectralpack {

/// True when no position above the grid could beat `best`, so that it is the answer in a grid of any height. Height
/// at the top: the object ends below the grid's top layer (its upper neighbour then lies in the grid, too). Height at
/// the bottom: sigma is below the height penalty alone of the first layer that was not looked at.
bool holds_in_any_grid(const Tray& tray, const Shape& shape, const CostModel& model, const BestPlacement& best);

/// Layers in which `shape`, on top of all that stands in the tray, has a place that holds_in_any_grid() at the top.
int layers_on_top(const Tray& tray, const Shape& shape);

/// A tray of `layers` layers, more than `tray` has, with the same objects under the same ids. For trays without a
/// container mask.
Tray grown(const Tray& tray, int layers);

}  // namespace spectralpack
