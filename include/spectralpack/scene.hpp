#pragma once
/// A packing in memory.

#include <memory>
#include <vector>

#include "geometry/mesh.hpp"
#include "model/packing.hpp"

namespace spectralpack {

/// Meshes of a packing's parts by part index, in the mesh file's own coordinates. Null for unusable parts.
using PartMeshes = std::vector<std::shared_ptr<const Mesh>>;

/// A packing with the meshes it places.
struct Scene {
    Packing packing;
    PartMeshes meshes;  ///< by part; null for parts without placements
};

}  // namespace spectralpack
