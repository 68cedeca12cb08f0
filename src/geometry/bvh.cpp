#include "geometry/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/stopped.hpp"
#include "geometry/mesh_edges.hpp"

namespace spectralpack {

namespace {

class Builder {
  public:
    Builder(const Mesh& mesh, const StopToken& stop) : order(mesh.triangles.size()), stop_(stop) {
        std::iota(order.begin(), order.end(), 0u);
        centres_.reserve(order.size());
        for (const Triangle& t : mesh.triangles) {
            // Three times the centroid: only comparisons are made with it.
            centres_.push_back(mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]);
        }
        if (!order.empty()) split(0, order.size());
    }

    std::vector<std::uint32_t> order;
    std::vector<Bvh::Node> nodes;

  private:
    void split(std::size_t begin, std::size_t end) {
        const std::size_t self = nodes.size();
        nodes.emplace_back();
        if (end - begin <= Bvh::kLeafTriangles) {
            nodes[self].first = static_cast<std::uint32_t>(begin);
            nodes[self].count = static_cast<std::uint32_t>(end - begin);
            return;
        }
        throw_if_stopped(stop_);
        Box box;
        for (std::size_t i = begin; i < end; ++i) {
            box.add(centres_[order[i]]);
        }
        const Vec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
            const double ca = centres_[a][axis], cb = centres_[b][axis];
            return ca != cb ? ca < cb : a < b;
        });
        // Which triangles go left is now certain, their order is up to the library: sort the leaves
        // below.
        split(begin, middle);
        nodes[self].first = static_cast<std::uint32_t>(nodes.size());
        split(middle, end);
    }

    std::vector<Vec3> centres_;
    const StopToken& stop_;
};

/// The greatest float that is no greater.
float at_most(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest > x ? std::nextafter(nearest, -std::numeric_limits<float>::infinity()) : nearest;
}

}  // namespace

Bvh::Bvh(const Mesh& mesh, bool faces_outwards, const StopToken& stop) : vertices_(mesh.vertices) {
    Builder builder(mesh, stop);
    nodes_ = std::move(builder.nodes);
    for (const Node& node : nodes_) {
        const auto first = builder.order.begin() + node.first;
        if (node.leaf()) std::sort(first, first + node.count);
    }
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const std::uint32_t i : builder.order) {
        triangles.push_back(mesh.triangles[i]);
    }
    triangles_ = std::make_shared<const std::vector<Triangle>>(std::move(triangles));
    throw_if_stopped(stop);
    refit();
    faces_outwards_ = faces_outwards || (is_closed(mesh, stop) && signed_volume(mesh) > 0);
}

void Bvh::refit() {
    box_ = Box{};
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.leaf()) {
            Box box;
            for (std::size_t t = node.first; t < node.first + node.count; ++t) {
                for (const Vec3& corner : corners(t)) {
                    box.add(corner);
                }
            }
            box_.add(box);
            for (int axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<std::size_t>(axis);
                node.min[k] = at_most(box.min[axis]);
                node.max[k] = -at_most(-box.max[axis]);
            }
        } else {
            const Node &left = nodes_[i + 1], &right = nodes_[node.first];
            for (std::size_t k = 0; k < 3; ++k) {
                node.min[k] = std::min(left.min[k], right.min[k]);
                node.max[k] = std::max(left.max[k], right.max[k]);
            }
        }
    }
}

Bvh Bvh::turned(const Mat3& linear) const {
    Bvh result(*this);
    for (Vec3& vertex : result.vertices_) {
        vertex = Transform{linear, {}} * vertex;
    }
    if (determinant(linear) < 0) {
        std::vector<Triangle> mirrored = *triangles_;
        for (Triangle& t : mirrored) {
            std::swap(t[1], t[2]);
        }
        result.triangles_ = std::make_shared<const std::vector<Triangle>>(std::move(mirrored));
    }
    result.refit();
    return result;
}

std::int64_t Bvh::bytes() const {
    return static_cast<std::int64_t>(vertices_.size() * sizeof(Vec3) + triangles_->size() * sizeof(Triangle) +
                                     nodes_.size() * sizeof(Node));
}

std::int64_t Bvh::most_bytes(const Mesh& mesh) {
    const std::size_t leaves = mesh.triangles.size() / (kLeafTriangles / 2) + 1;
    return static_cast<std::int64_t>(mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * sizeof(Triangle) +
                                     2 * leaves * sizeof(Node));
}

}  // namespace spectralpack
