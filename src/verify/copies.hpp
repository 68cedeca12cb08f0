#pragma once
/// The copies of a packing, ready to be compared: their solids and poses, and what is wrong with each by itself.

#include <memory>
#include <vector>

#include "verify/check.hpp"
#include "verify/overlap.hpp"

namespace spectralpack {

struct JudgedCopy {
    int placement = 0;  ///< index into its tray's placements
    PosedSolid posed;
    Box box;            ///< of the posed mesh
    double gap = 0;     ///< its part's, mm
    double volume = 0;  ///< signed, of the mesh at its part's scale, mm^3
};

struct Copies {
    std::vector<std::unique_ptr<const Solid>> solids;
    std::vector<std::vector<JudgedCopy>> by_tray;
    std::vector<Finding> findings;  ///< of kinds transform and outside
};

/// Share of the whole work that this is taken to be, for progress.
inline constexpr double kPreparing = 0.2;

/// One solid for each mesh and scale; one of its own for a copy whose transform is no rotation times scale. Skips
/// placements of parts that are not there and transforms that are not finite. None when stopped. Throws
/// InternalError where a placed part has no mesh.
std::optional<Copies> prepare_copies(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                                     const Workers& workers, Listener& listener, const StopToken& stop);

}  // namespace spectralpack
