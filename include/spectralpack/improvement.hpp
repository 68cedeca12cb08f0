#pragma once
/// What `--improve` did to a packing.

#include <cstdint>

namespace spectralpack {

/// What a run makes better once its first packing is done.
enum class Improves {
    height,   ///< mm, of a tray that holds all that is wanted in it: less is better
    density,  ///< share of the container that is filled, as are the next two more is better
    copies,   ///< placed
    value,    ///< of the copies placed, summed
    trays,    ///< that are used, of the last only the share that is filled: less is better
    box,      ///< mm^3, the packing's own: less is better
};

struct Improved {
    Improves what = Improves::height;
    double before = 0, now = 0;  ///< of the first packing, and of the best so far
    std::int64_t steps = 0;      ///< orders tried: --improve-steps with this number repeats it on the same grid
    int starts = 0;              ///< of orders far from each other
    double seconds = 0;          ///< spent

    bool operator==(const Improved&) const = default;
};

}  // namespace spectralpack
