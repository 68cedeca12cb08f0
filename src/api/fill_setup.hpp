#pragma once
/// What trays start from, as a job and its plan have it.

#include "api/load.hpp"
#include "api/plan.hpp"
#include "packing/least_box.hpp"
#include "packing/tray_filler.hpp"
#include "spectralpack/events.hpp"

namespace spectralpack {

struct FillSource {
    const LoadedJob& loaded;
    const Plan& plan;
    const Container& container;
    const PackOptions& options;
};

/// `base`: of the grid, in voxels; counts with --minimise box. `listener` outlives the setup and is told of disassembly
/// and of putting back. Throws InputError or UsageError where no voxel of the container is free.
FillSetup fill_setup(const FillSource& source, const BaseSize& base, Listener& listener, const Workers& workers);

}  // namespace spectralpack
