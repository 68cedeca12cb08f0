#pragma once
/// Plans of packings that are done.

#include "spectralpack/events.hpp"
#include "spectralpack/pack.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

/// In a build that was topped up, what stood there before did not move while new copies were packed; on the machine it
/// is dug out like those. Where all of a tray comes out, that is its plan; else the plan that it has, of new copies
/// alone, stays. Stopped meanwhile, the latter.
void plan_what_stood_before(Packing& packing, const PartMeshes& meshes, int threads, const Control& control);

}  // namespace spectralpack
