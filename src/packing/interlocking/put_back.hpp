#pragma once
/// Copies put into a packing that comes apart, where it still does: those that were taken out of it, and others that
/// had found no place.

#include <set>
#include <vector>

#include "packing/interlocking/placed_bodies.hpp"
#include "packing/interlocking/untangle.hpp"

namespace spectralpack {

/// A tray in repair. `bodies` are those of `placed`, which `tray` holds.
struct TrayRepair {
    Tray& tray;
    std::vector<PlacedCopy>& placed;
    const TrayContext& context;
    const UntangleOptions& options;
    PlacedBodies& bodies;
};

/// What is to be put in.
struct PutBackWish {
    std::vector<Copy> copies;
    std::set<Copy> taken_out;        ///< those of them that stood before
    std::vector<VoxelBox> freed;     ///< where copies were taken out
    std::vector<RemovalStep> steps;  ///< by which what stands comes apart
};

struct PutBackResult {
    std::vector<RemovalStep> steps;  ///< by which all comes apart now
    std::vector<Copy> interlocked;   ///< taken out, and found no place that they come out from
    int put_back = 0, added = 0;
    int fills = 0;  ///< flood fills
};

/// Puts in the copies of the wish in the order of the options, each at the best place from which it comes out once its
/// turn comes, of the first few that are not in the same hole, or else at the best that is reachable now.
PutBackResult put_back(const TrayRepair& repair, PutBackWish wish);

}  // namespace spectralpack
