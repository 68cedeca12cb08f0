#pragma once
/// The base on which a packing of open height takes the box of least volume.

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>

#include "packing/job/trays_packer.hpp"

namespace spectralpack {

/// How good a packing is: less is better, lexicographically.
struct BoxScore {
    std::int64_t left_over = 0;  ///< copies
    double volume = 0;           ///< of the packing's own box

    auto operator<=>(const BoxScore&) const = default;
};

/// Packs on a base. None when stopped.
using PackOnBase = std::function<std::optional<BoxScore>(const BaseSize&)>;

/// Trays of that base instead of the job's.
FillOptions on_base(FillOptions options, const BaseSize& base);

/// Of the box about the placed copies' true meshes, mm^3.
double box_volume(const PackingJob& job, const std::vector<PlacedCopy>& placed);

/// Tries bases: first squares and oblongs (1:1, 1.4:1 and 2:1) about `side` voxels long, then, from the best of them,
/// each side made longer and shorter by 1/6, 1/12, 1/24 ... of it down to a voxel, as long as that helps. No base is
/// tried twice; all are within [`least`, `most`]. Ends when `pack` returns none. Deterministic; a few dozen calls. The
/// caller keeps the best packing: the first with the least score.
void search_bases(int side, const BaseSize& least, const BaseSize& most, const PackOnBase& pack);

/// Packs the job on one base after the other, `most` the largest, and keeps the packing whose own box is least. What a
/// stop cuts short counts only where there is nothing else. `packed` holds what there is when an exception leaves
/// this function. `observer` (may be null) is told of that, at the end.
void pack_in_least_box(TraysPacker& packer, const BaseSize& most, const StopToken& stop, const TellProgress& tell,
                       TrayObserver* observer, PackedJob& packed);

}  // namespace spectralpack
