#pragma once
/// Ways with fewer moves. A flood fill finds its way among voxels, with a corner wherever they have one; on the meshes
/// many of those are not needed.

#include <cstddef>
#include <optional>
#include <vector>

#include "disassembly/subassembly.hpp"
#include "spectralpack/disassembly.hpp"

namespace spectralpack {

/// A way for `members` of what stands that ends where `path` does, or further out straight from one of its corners; of
/// no more moves, each swept exactly. `path` is such a way, its moves along the axes.
Subassembly::Path smoothed(const Subassembly& standing, const Subassembly::Members& members, Subassembly::Path path);

/// Smooths the ways of all steps of a plan for `bodies`, named by their index. `walls`: the one among them that stands
/// in the way of those steps alone that do not go through it. Stopped, the rest stays as it is.
void smooth(const DisassemblyOptions& options, const std::vector<Body>& bodies, std::optional<std::size_t> walls,
            Disassembly& plan);

}  // namespace spectralpack
