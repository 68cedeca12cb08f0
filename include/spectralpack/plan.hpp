#pragma once
/// Taking packings apart: a disassembly plan for any packing, also one from elsewhere (section 4 of the paper).

#include <optional>
#include <vector>

#include <string>
#include "spectralpack/disassembly.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct PlanOptions {
    std::optional<double> voxel =
        {};  ///< of the flood fill, mm; none: that of the packing's collisions, voxel / detail
    std::optional<double> ray_spacing = {};  ///< mm; none: that of the packing's options, or else four voxels
    std::optional<Unpack> unpack = {};       ///< none: that of the packing's options, or else as `pack` chooses
    int threads = 0;                         ///< 0: all the machine has
};

/// One plan for each tray: how its copies come apart, or which sets of them hold each other. Nothing is taken out of
/// the packing. Whatever a plan says was confirmed on the meshes; that a set is interlocked is as sure as the voxels
/// are fine: no single copy of it leaves through voxels of this size, no group that the blocking graphs suggest leaves
/// along an axis, and none leaves by the plan that the packing has already. A plan is incomplete without interlocked
/// sets where `control.stop` came first.
std::vector<Disassembly> plan_packing(const Scene& scene, const PlanOptions& options, const Control& control = {});

/// The plans as JSON text (docs/format.md).
std::string plans_json(const Scene& scene, const std::vector<Disassembly>& plans);

}  // namespace spectralpack
