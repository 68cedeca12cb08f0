#pragma once
/// Whether keep-outs make sense in their container.

#include "core/parallel.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/packing.hpp"
#include "voxel/bit_grid.hpp"

namespace spectralpack {

/// Warns of keep-outs that lie outside the container's box, where they keep nothing free.
void warn_of_keep_outs(const Container& container, Listener& listener);

/// Throws UsageError where no voxel of the tray is free between the keep-outs, InputError where none is in the mesh
/// that is the container. `blocked` are those that are not free, or an empty grid where all are.
void require_free(const BitGrid& blocked, const Container& container, const PackOptions& options);

}  // namespace spectralpack
