#pragma once
/// The picture of spectralpack/render.hpp, by given workers.

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "render/stage.hpp"
#include "render/tile_painter.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/render.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// The picture of a stage whose meshes are there. What is left of it once `hurry` is requested is painted plainly: one
/// sample per pixel, no shadows. Throws Stopped once the workers are asked to stop.
Picture paint(const Stage& stage, const RayMeshes& meshes, int samples, const Workers& workers,
              const StopToken& hurry = {});

/// `meshes`: by part; null for parts without placements. Throws as render(Scene) does, and Stopped where the time is
/// over.
Image render(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
             const RenderOptions& options, const Workers& workers, const DrawingTime& time = {});

}  // namespace spectralpack
