#pragma once
/// Packing: from mesh files to a Packing.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/listener.hpp"
#include "core/stop.hpp"
#include "model/options.hpp"
#include "model/packing.hpp"
#include "model/printer.hpp"
#include "spectralpack/inputs.hpp"
#include "spectralpack/scene.hpp"
#include "voxel/grid.hpp"

namespace spectralpack {

struct Job {
    std::vector<PartSource> parts;
    double unit = 1;  ///< millimetres per unit for files that do not say
    PackOptions options;
    ContainerSource container;       ///< where it is a mesh, its size takes the place of options.tray
    std::vector<FixedSource> fixed;  ///< copies that stand in the first tray and stay there
    /// Ends a search for an order (restarts, beam), whose best is then packed in; none: only pack()'s own token does.
    /// Who has one requests it whenever he requests that.
    std::optional<StopToken> enough_orders;
    std::optional<Scene> onto;  ///< its copies stand where they are; those placed come on top, tray by tray
};

struct PackResult {
    Packing packing;
    PartMeshes meshes;
    std::vector<InputError> unusable;       ///< inputs that could not be used; the rest was packed
    StopReason stopped = StopReason::none;  ///< ended early: `packing` is the best so far
    std::optional<Error> failure;           ///< ran out of memory or engines disagreed; `packing` is what was done
};

/// What a run would take, known before it starts.
struct Estimate {
    Vec3 container;  ///< size, mm
    Extent grid;     ///< voxels of the tray
    int orientations = 0;
    int parts = 0;
    std::int64_t copies = 0;
    std::int64_t searches = 0;           ///< at most: one per copy
    std::int64_t memory = 0;             ///< bytes at peak, about
    std::int64_t memory_limit = 0;       ///< --memory, or what the machine has free
    double box_ratio = 0;                ///< boxes of all copies / container
    double volume_ratio = 0;             ///< volumes of all copies / container
    double height_penalty = 0;           ///< p as it would be used
    std::vector<std::string> too_large;  ///< parts that fit in no orientation
    std::vector<InputError> unusable;
};

/// Loads, voxelises and packs. The same job gives the same placements on any machine and number of threads.
/// Inputs that cannot be used are reported and the rest is packed. Throws UsageError for options that make no
/// sense or are not built, ResourceError when the memory plan does not fit (with the bytes needed and the voxel
/// size that would fit), InputError when nothing at all is usable, for a container or keep-out mesh that cannot be one
/// and for fixed copies that overlap or stick out.
PackResult pack(const Job& job, Listener& listener, const StopToken& stop);

/// Loads the inputs and plans, without packing. Throws as pack() does, but not for memory.
Estimate estimate(const Job& job, Listener& listener);

}  // namespace spectralpack
