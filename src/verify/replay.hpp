#pragma once
/// Replays a tray's disassembly plan on the exact meshes (spectralpack/disassembly.hpp says what it means).

#include <functional>
#include <vector>

#include "verify/check.hpp"
#include "verify/copies.hpp"

namespace spectralpack {

struct Replay {
    PlanReport report;
    std::vector<Finding> findings;  ///< of kind plan, in step order
    bool stopped = false;
};

/// Every step's copies go their way, move by move, past each copy that is left of their subassembly; they must touch
/// nothing deeper than the tolerance and end wholly outside the bounding box of that. Two findings a step at most: the
/// deepest penetration (the one met first, of equals) and where it ends. The placements' order of `copies` is that of
/// the tray; copies that are not among them are not there. `walls`: what else stands in the tray and never moves, its
/// placement -1; in the way of those steps alone that the plan says it is in the way of (all in a physical container).
/// Precondition: the tray has a plan. Time: pairs of copies, and a sweep for each whose boxes meet on the way.
/// `tell(done, total)` steps; the result does not depend on the number of threads.
Replay replay_plan(const Packing& packing, int tray, const std::vector<JudgedCopy>& copies,
                   const std::vector<JudgedCopy>& walls, const Workers& workers, const StopToken& stop,
                   const std::function<void(std::size_t, std::size_t)>& tell);

}  // namespace spectralpack
