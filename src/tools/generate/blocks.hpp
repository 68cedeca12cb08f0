#pragma once
/// Solids made of boxes, with exact coordinates: what generated brackets, frames and cases are made
/// of.

#include <vector>

#include "spectralpack/mesh.hpp"

namespace spectralpack::tools {

/// Boxes are added and cut away in the order of the calls.
class Blocks {
  public:
    Blocks& add(const Vec3& low, const Vec3& high);
    Blocks& cut(const Vec3& low, const Vec3& high);

    /// The surface of what is left: closed, outward, on the grid of all boxes' faces, so without
    /// T-junctions. An edge has more than two triangles where boxes meet along an edge alone.
    /// Time and memory by the cells of that grid, so cubic in the number of distinct faces.
    Mesh mesh() const;

  private:
    struct Step {
        Vec3 low, high;
        bool filled;
    };

    std::vector<Step> steps_;
};

}  // namespace spectralpack::tools
