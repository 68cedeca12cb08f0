#pragma once
/// The grid of a run, voxel size and orientations, where nobody says which.

#include <span>

#include "api/plan.hpp"

namespace spectralpack {

/// The plan of a job. `options` come to say what it is made for: what they gave of voxel size and rotations stays; else
/// it is the usual, or, where the packing is to be improved for ten seconds or more, the finest grid of which a pass is
/// expected to take at most a part of the time for that, and that memory holds: half the voxel size, and the turns of
/// the parts' smallest boxes. What is expected follows from job and options, not from how fast the machine is, so every
/// machine with enough memory takes the same grid. Throws as make_plan() does.
Plan choose_grid(const LoadedJob& loaded, const Container& container, std::span<const Printer> own_printers,
                 const Workers& workers, PackOptions& options);

}  // namespace spectralpack
