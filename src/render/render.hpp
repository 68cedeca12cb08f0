#pragma once
/// The picture of spectralpack/render.hpp, by given workers.

#include <memory>
#include <vector>

#include "core/parallel.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/render.hpp"

namespace spectralpack {

/// `meshes`: by part; null for parts without placements. Throws as render(Scene) does.
Image render(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes,
             const RenderOptions& options, const Workers& workers);

}  // namespace spectralpack
