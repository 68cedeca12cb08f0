#pragma once
/// What a picture shows and from where: trays set out on a floor, the camera fitted to them.

#include <memory>
#include <utility>
#include <vector>

#include "render/camera.hpp"
#include "render/render.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/packing.hpp"

namespace spectralpack {

struct StagedCopy {
    int mesh = 0;    ///< index into Stage::meshes
    Transform pose;  ///< from the mesh's own coordinates to the stage
    Vec3 colour;     ///< linear sRGB
};

/// Lengths are in stage units: everything shown fits a sphere of radius 1 round the origin,
/// whatever its size in millimetres, so that single precision and fixed tolerances serve for a ring
/// as for a bridge.
struct Stage {
    std::vector<std::shared_ptr<const Mesh>> meshes;  ///< distinct ones
    std::vector<StagedCopy> copies;                   ///< tray by tray, in packing order
    std::vector<Box> containers;                      ///< the trays' boxes
    std::vector<Box> outlined;                        ///< to be drawn as lines: containers and keep-outs that are boxes
    std::vector<std::pair<Vec3, Vec3>> edges;         ///< likewise: those of meshes
    double floor = 0;                                 ///< z
    Camera camera;
};

/// Several trays stand side by side as the camera sees them, first tray front left, in as many rows
/// as let them be largest in the picture. Copies that stick out of their container are in the
/// picture too; a copy that its transform flattens is left out. Throws UsageError for a tray that
/// is not there, or a packing that places a part without a mesh.
Stage set_stage(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                const RenderOptions& options);

}  // namespace spectralpack
