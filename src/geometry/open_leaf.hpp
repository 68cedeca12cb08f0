#pragma once
/// The triangles of one leaf of a Bvh (mm, as its mesh), ready to be compared with another's. Walks over pairs of
/// leaves often come to the same one again at once, so it stays open until the next.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "geometry/bvh.hpp"

namespace spectralpack {

/// Outline: what is known of a triangle before its corners are asked, a box for instance.
template <class Outline>
class OpenLeaf {
  public:
    /// The leaf's triangles moved by `offset` (mm); outline_of(corners) is asked for each. Always of the same tree and
    /// offset.
    template <class OutlineOf>
    void open(const Bvh& bvh, const Bvh::Node& leaf, const Vec3& offset, const OutlineOf& outline_of) {
        if (first_ == leaf.first) return;
        first_ = leaf.first;
        for (std::size_t i = 0; i < leaf.count; ++i) {
            corners_[i] = bvh.corners(leaf.first + i);
            for (Vec3& corner : corners_[i]) {
                corner = corner + offset;
            }
            outlines_[i] = outline_of(corners_[i]);
        }
    }
    /// Of its i-th triangle, in the tree's order.
    const Corners& corners(std::size_t i) const { return corners_[i]; }
    const Outline& outline(std::size_t i) const { return outlines_[i]; }

  private:
    std::uint32_t first_ = std::numeric_limits<std::uint32_t>::max();
    std::array<Corners, Bvh::kLeafTriangles> corners_;
    std::array<Outline, Bvh::kLeafTriangles> outlines_;
};

}  // namespace spectralpack
