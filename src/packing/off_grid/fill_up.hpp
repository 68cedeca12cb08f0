#pragma once
/// What a greedy packing left over, tried off the grid.

#include "packing/off_grid/off_grid.hpp"
#include "packing/tray/greedy.hpp"

namespace spectralpack {

/// Puts what `result` has left over where it has room off the grid (OffGrid::put()), in order. Where copies are still
/// left over then, and a plain lattice of one size of box would hold more than the whole tray does, packs anew on top
/// of that lattice; this packing stays if it has all that stood before, of the lattice's parts as many at least, and
/// more. Not under caps. `wanted`: the tray's copies in order. The observer is told. Nothing changes once the context's
/// token stops it.
void fill_up(OffGrid& off_grid, PartSurfaces& surfaces, Tray& tray, const TrayContext& context,
             const std::vector<Copy>& wanted, GreedyResult& result);

/// The same for a tray filled in shares: further copies by share_out(); of a single part, the lattice where it holds
/// more.
void fill_up_in_shares(OffGrid& off_grid, PartSurfaces& surfaces, const TrayContext& context,
                       const std::vector<PartShare>& shares, GreedyResult& result);

}  // namespace spectralpack
