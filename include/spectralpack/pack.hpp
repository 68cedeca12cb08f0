#pragma once
/// Packing: from a job to a packing, in memory.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/grid.hpp"
#include "spectralpack/job.hpp"
#include "spectralpack/journal.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/printers.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct PackResult {
    Packing packing;
    PartMeshes meshes;
    std::vector<InputError> unusable;       ///< inputs that could not be used; the rest was packed
    StopReason stopped = StopReason::none;  ///< ended early: `packing` is the best so far
    std::optional<Error> failure;           ///< ran out of memory or engines disagreed; `packing` is what was done
    std::optional<JournalUse> journal;      ///< where one was kept
};

/// What a run would take, known before it starts.
struct Estimate {
    Vec3 container;    ///< size, mm
    Extent grid;       ///< voxels of the tray
    double voxel = 0;  ///< their size, mm
    int orientations = 0;
    int parts = 0;                       ///< that have copies to pack
    std::int64_t copies = 0;             ///< to pack: none that stand fixed, are too large or of a file without a mesh
    std::int64_t left_over = 0;          ///< copies of files that cannot be used and of parts that are too large
    std::int64_t searches = 0;           ///< at most: one per copy
    std::int64_t memory = 0;             ///< bytes at peak, about
    std::int64_t memory_limit = 0;       ///< --memory, or what the machine has free
    double box_ratio = 0;                ///< boxes of those copies / container
    double volume_ratio = 0;             ///< volumes of those copies / container
    double height_penalty = 0;           ///< p as it would be used
    std::vector<std::string> too_large;  ///< parts that fit in no orientation
    std::vector<InputError> unusable;
    StopReason stopped = StopReason::none;  ///< ended early: the rest says nothing
};

/// Loads, voxelises and packs. The same job gives the same placements on any machine and number of threads.
/// Inputs that cannot be used are reported and the rest is packed. Throws UsageError for options that make no
/// sense or are not built, ResourceError when the memory plan does not fit (with the bytes needed and the voxel
/// size that would fit), InputError when nothing at all is usable, for a container or keep-out mesh that cannot be one
/// and for fixed copies that overlap or stick out, and as Resume::must says. A packing that goes on from a journal is
/// judged by check() before it is returned.
PackResult pack(const Job& job, const Control& control = {}, const JournalOptions& journal = {});

/// Loads the inputs and plans, without packing. Throws as pack() does, but not for memory.
Estimate estimate(const Job& job, const Control& control = {});

/// The estimate as JSON text (docs/format.md), with the seconds that the run would take where they are known.
std::string estimate_json(const Estimate& estimate, std::optional<double> seconds);

}  // namespace spectralpack
