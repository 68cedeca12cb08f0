#pragma once
/// What a picture shows and from where: trays set out on a floor, the camera fitted to them.

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/camera.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/render.hpp"

namespace spectralpack {

enum class Backdrop { floor, white };  ///< a floor that takes shadows, or nothing: for print

enum class Look { strong, pale, gone };

/// A picture, and what the operator's sheet wants of it besides.
struct View {
    RenderOptions options;
    Lens lens = Lens::perspective;
    double margin = kMargin;  ///< of a parallel lens
    Backdrop backdrop = Backdrop::floor;
    bool outlines = true;                                ///< of containers and keep-outs; these are hatched either way
    std::optional<std::pair<double, double>> slab = {};  ///< mm: only what lies between these heights
    std::vector<Look> looks = {};                        ///< by placement of the one tray shown; empty: all strong
};

struct StagedCopy {
    int mesh = 0;    ///< index into Stage::meshes
    Transform pose;  ///< from the mesh's own coordinates to the stage
    Vec3 colour;     ///< linear sRGB
    int number = 0;  ///< of CopyNumbers
    int placement = 0;
    bool fixed = false;
    Look look = Look::strong;
};

/// What is shown: the rest of the stage, on both sides, is cut away.
struct Kept {
    int axis = 2;
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// Lengths are in stage units: everything shown fits a sphere of radius 1 round the origin,
/// whatever its size in millimetres, so that single precision and fixed tolerances serve for a ring
/// as for a bridge.
struct Stage {
    std::vector<std::shared_ptr<const Mesh>> meshes;  ///< distinct ones
    std::vector<StagedCopy> copies;                   ///< tray by tray, in packing order
    std::vector<StagedCopy> keep_outs;                ///< hatched; they hide nothing
    std::vector<Box> containers;                      ///< the trays' boxes
    std::vector<Box> outlined;                        ///< to be drawn as lines: containers and keep-outs that are boxes
    std::vector<std::pair<Vec3, Vec3>> edges;         ///< likewise: those of meshes
    std::vector<double> layers;                       ///< drawn apart: z of their floors, from the lowest up
    double floor = 0;                                 ///< z
    double millimetre = 1;                            ///< how long one is
    Backdrop backdrop = Backdrop::floor;
    std::optional<Kept> kept;
    bool hatched_cuts = false;  ///< what `kept` cuts through
    Camera camera;
};

/// Several trays stand side by side as the camera sees them, first tray front left, in as many rows
/// as let them be largest in the picture. Copies that stick out of their container are in the
/// picture too; a copy that its transform flattens is left out. Throws UsageError for a tray that
/// is not there, or a packing that places a part without a mesh.
Stage set_stage(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes, const View& view);

/// One part by itself, on white.
Stage set_part_stage(const std::shared_ptr<const Mesh>& mesh, const Vec3& colour, int width, int height);

}  // namespace spectralpack
