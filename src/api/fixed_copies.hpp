#pragma once
/// Copies that stand in their trays before anything is packed.

#include "api/load.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// Adds the parts and copies of job.onto and job.fixed to `loaded`, which has no parts yet. Throws InputError for files
/// that cannot be used and for transforms that are not a rotation times a scale, Stopped once `stop` is requested.
void load_fixed(const Job& job, LoadedJob& loaded, const StopToken& stop);

/// Lets those copies of `keep` stand that the job's parts, all of which are loaded, ask for. The others are warned of.
void keep_copies(const Scene& keep, LoadedJob& loaded, Listener& listener);

/// The fixed copies of every tray; `trays` of them at least.
std::vector<TrayPacking> fixed_trays(const LoadedJob& loaded);

/// Throws InputError naming the copies where fixed copies overlap or leave the container by more than the tolerance of
/// `check`. Those that are merely nearer to each other than their gap are told as a warning.
void require_sound(const LoadedJob& loaded, const Container& container, const PackOptions& options,
                   const Workers& workers, Listener& listener, const StopToken& stop);

}  // namespace spectralpack
