#pragma once
/// Uses the time that the user gives to make a finished packing better. What it starts from stays until something is
/// better, comes apart and is whole; so it may end at any time.

#include <cstdint>
#include <optional>

#include "packing/job/trays_packer.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

struct ImprovementOptions {
    Goal goal = Goal::fair;
    std::int64_t most_steps = 0;  ///< orders tried; 0: until `enough`
    std::uint64_t seed = 0;
    StopToken stop;    ///< ends all
    StopToken enough;  ///< ends the search for something better; what was found is still made to come apart
};

/// What is told of a run that improves after so many steps of its own; `most_steps` as in ImprovementOptions.
Progress improving(const Improved& improved, std::int64_t steps, std::int64_t most_steps);

/// Replaces the trays in `packed` where something better was found; `observer` (may be null) is told of that, anew. One
/// tray that holds all becomes lower; one that overflows comes to hold more of what the goal says; of several the last
/// comes to hold less, or there are fewer (fewest_trays.hpp). `packed` holds the best so far when an exception leaves
/// this function.
void improve(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell, TrayObserver* observer,
             PackedJob& packed);

/// The same for one of the trays in `packed`, which holds all that was wanted in it: it becomes lower, with the same
/// copies. `packed.improvement` comes to tell of that alone. There is memory for the voxels of all parts at once.
void lower_tray(TraysPacker& packer, const ImprovementOptions& options, const TellProgress& tell,
                TrayObserver* observer, PackedJob& packed, int number);

}  // namespace spectralpack
