#pragma once
/// Makes a packed tray one that comes apart (section 4): plans its disassembly, takes out what is interlocked, and puts
/// that back where it can be taken out again.

#include <vector>

#include "disassembly/disassembler.hpp"
#include "packing/interlocking/placed_bodies.hpp"
#include "packing/tray/filled_tray.hpp"
#include "spectralpack/disassembly.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

struct UntangleOptions : BodyOptions {
    double voxel_size = 2;            ///< mm
    PlacementSearch* best = nullptr;  ///< tells where copies are tried first; null: the one that all else is asked of
    TakeOut take_out = TakeOut::thinnest;
    bool repair = true;                ///< else what was taken out stays out
    bool measure_gap = false;          ///< between copies in the end, where something changed
    std::vector<Copy> order;           ///< in which copies are put back
    std::vector<Copy> waiting;         ///< had found no place; are tried again where others were taken out
    bool waiting_had_no_room = false;  ///< collided everywhere, or was linked there; not merely out of reach
    Disassembler::Left left;           ///< told while planning
    /// Told how many copies are still to be tried, while letting them back where they stood, then anew while putting
    /// them back elsewhere.
    Disassembler::Left to_put_back;
};

struct Untangled {
    Disassembly plan;               ///< by index into `placed`
    std::vector<Copy> interlocked;  ///< taken out for good
    InterlockReport report;
};

/// Disassembles what `placed` and `tray` hold. While something is stuck, takes out of each stuck set what the rule says
/// and goes on; then lets stand what need not go after all, lighter copies instead of heavier ones. Then puts back what
/// was taken out, and puts in what had found no place, in the order of the job: each at its best placement if it comes
/// out from there when its turn comes, or else at the best in some other holes, or at its best reachable one, on the
/// grid. Without a ceiling all is packed anew where that made the packing higher, and the lower one stays. `placed` and
/// `tray` end as the packing that the plan is of. When stopped, the plan is complete only if all that stands had been
/// planned by then, and what has been found interlocked until then is out; what had not been tried by then is not among
/// `interlocked`. The context's observer is told of what changes in the end: what may stay after all, and a packing
/// that is given up again, are no change. (docs/algorithm/interlocking.md)
Untangled untangle(Tray& tray, std::vector<PlacedCopy>& placed, const TrayContext& context,
                   const UntangleOptions& options);

}  // namespace spectralpack
