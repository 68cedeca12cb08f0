#pragma once
/// Tree of axis-aligned boxes over the triangles of a mesh: what distance and slide queries walk
/// on. A surface only: it knows nothing of inside and outside but which way its triangles face.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "spectralpack/mesh.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

using Corners = std::array<Vec3, 3>;  ///< of one triangle, in its order

inline Box bounding_box(const Corners& t) { return {min(t[0], min(t[1], t[2])), max(t[0], max(t[1], t[2]))}; }

/// Immutable and shareable. About 45 bytes a triangle, 33 where a tree was turned from another and both are kept.
class Bvh {
  public:
    /// An inner node's left child is the next node, its right child is `first`; a leaf holds the
    /// triangles first .. first + count - 1. Two fit a cache line: boxes are in single precision, rounded outwards.
    struct Node {
        std::array<float, 3> min, max;
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< 0: inner node

        bool leaf() const { return count > 0; }
        Box box() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
    };

    static constexpr std::size_t kLeafTriangles = 4;  ///< 8 is slower, 1 and 2 are larger and no faster

    /// Splits at the median centroid along the longest axis: O(n log n), depth about log2 n, the
    /// same tree on every machine. Preconditions: finite coordinates, indices in range.
    /// `faces_outwards`: it is known that they do, though the mesh is not closed. Throws Stopped once `stop` is
    /// requested.
    explicit Bvh(const Mesh& mesh, bool faces_outwards = false, const StopToken& stop = {});

    /// The tree of transformed(mesh, {linear, 0}): same shape, boxes fitted anew. O(n).
    Bvh turned(const Mat3& linear) const;

    std::span<const Node> nodes() const { return nodes_; }  ///< the root first; empty without triangles
    std::size_t triangle_count() const { return triangles_->size(); }
    Corners corners(std::size_t i) const {
        const Triangle& t = (*triangles_)[i];
        return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    }
    const Box& box() const { return box_; }  ///< exact

    /// The triangles face outwards: the mesh is closed and its signed volume is positive, or it was said so.
    bool faces_outwards() const { return faces_outwards_; }

    /// With the triangles, which trees turned from each other share.
    std::int64_t bytes() const;
    /// What bytes() of the mesh's tree is at most: a leaf holds more than half of kLeafTriangles, unless it is the
    /// root.
    static std::int64_t most_bytes(const Mesh& mesh);

  private:
    Bvh() = default;
    void refit();

    std::vector<Vec3> vertices_;
    std::shared_ptr<const std::vector<Triangle>> triangles_;  // in the order of the leaves
    std::vector<Node> nodes_;
    Box box_;
    bool faces_outwards_ = false;
};

}  // namespace spectralpack
