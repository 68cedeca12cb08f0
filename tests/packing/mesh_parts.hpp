#pragma once
/// Parts made of meshes in code, as trays are filled with them: at voxels of 1 mm, without a gap.

#include <memory>
#include <vector>

#include "packing/tray/part_surfaces.hpp"
#include "search/shape.hpp"

namespace spectralpack::test {

/// Outlives what it hands out.
struct MeshParts {
    std::vector<Mesh> meshes;
    std::vector<Mat3> orientations{Mat3{}};

    const Mesh& mesh(int part) const { return meshes[static_cast<std::size_t>(part)]; }
    std::shared_ptr<const Shape> shape(int part) const {
        return std::make_shared<const Shape>(
            make_shape(static_cast<std::uint64_t>(part) + 1, mesh(part), orientations, 1, 1, 0, {0}, Workers(1)));
    }
    ScaledPart scaled(int part) const { return {std::make_shared<const Mesh>(mesh(part)), 0, &orientations, 0}; }
};

}  // namespace spectralpack::test
