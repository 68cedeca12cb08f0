#pragma once
/// The job that the packing room gets, from what was loaded and planned.

#include "api/load.hpp"
#include "api/plan.hpp"
#include "packing/job/packing_job.hpp"
#include "spectralpack/events.hpp"

namespace spectralpack {

struct JobSource {
    const LoadedJob& loaded;
    const Plan& plan;
    const Container& container;
    const PackOptions& options;
};

/// `listener` outlives the job and is told of disassembly and of putting back. Throws InputError or UsageError where no
/// voxel of the container is free.
PackingJob packing_job(const JobSource& source, Listener& listener, const Workers& workers);

}  // namespace spectralpack
