#pragma once
/// Ways out of a subassembly for one of its copies, if no straight one is free: found by flood fill through voxels,
/// each move then confirmed by an exact sweep (sections 4.1 and 4.2).

#include <optional>

#include "disassembly/subassembly.hpp"
#include "disassembly/ways/closed_region.hpp"

namespace spectralpack {

struct Flooded {
    std::optional<Subassembly::Path> path;
    std::optional<ClosedRegion> closed_region{};  ///< where there is none
    bool began = false;                           ///< some position near where it stands is free
};

/// Any way out, in few moves, for the copy that `flood` is of. Where the subassembly's token has stopped it, there is
/// none and the closed region says nothing. Several threads may ask for different copies.
Flooded way_out(const Subassembly& subassembly, Subassembly::Flood& flood);

/// A straight one, or else any, for copy `i`.
std::optional<Subassembly::Path> any_way_out(const Subassembly& subassembly, std::size_t i);

/// A way of two moves that voxels need not see: one of a voxel's length, then straight on. For copies that stand off
/// the grid so near to others that a flood fill has nowhere to begin.
std::optional<Subassembly::Path> way_beside_the_grid(const Subassembly& subassembly, std::size_t i);

}  // namespace spectralpack
