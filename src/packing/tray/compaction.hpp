#pragma once
/// Compaction: the copies of a finished layout sink as far as they can, on their true meshes. Each slides straight down
/// from the lowest on, sweep after sweep; then also sideways where that lets it sink. Paths are free throughout, as in
/// refinement, so what could be taken apart before can be taken apart after, but for what voxels see of it: the plan is
/// made afterwards.

#include <vector>

#include "packing/tray/caps.hpp"
#include "packing/tray/part_surfaces.hpp"
#include "packing/tray/placed_copy.hpp"
#include "refine/refiner.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct CompactionOptions {
    RefineOptions refine;                 ///< container, wall gap and longest move; rounds as there
    std::vector<PlacedSurface> standing;  ///< what stays where it is: walls, fixed copies
    int sweeps = 3;                       ///< straight down, at most; fewer once nothing sinks
    int sideways = 2;  ///< likewise, sideways and down, of copies in the upper half; sweeps straight down follow each
};

/// Moves the offsets of `placed`, which keep their gaps. A copy stays where `caps` (null: none; else it holds what is
/// placed, and follows) would be broken. True where some copy moved. Ends early when stopped: what has moved by then
/// stands well. Deterministic. A sweep takes about as long as refining all copies once, sideways twice that.
bool compact(const CompactionOptions& options, PartSurfaces& surfaces, Caps* caps, std::vector<PlacedCopy>& placed,
             const Workers& workers, const StopToken& stop);

/// Upper end of the copies, mm; 0 without any.
double top_of(const std::vector<PlacedCopy>& placed, PartSurfaces& surfaces);

}  // namespace spectralpack
