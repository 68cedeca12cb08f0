#include "geometry/plane_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "geometry/loop_triangles.hpp"

namespace spectralpack {
namespace {

constexpr double kClear = 1e-3;  // mm; a plane so far from all vertices is clear of them

using Index = std::uint32_t;
using Step = std::pair<Index, Index>;  // along the cut, with the area below on its left as seen from above

/// The mesh's vertices, and those that the cut adds.
class Cutter {
  public:
    Cutter(const Mesh& mesh, const Plane& plane) : plane_(plane), vertices_(mesh.vertices) {
        heights_.reserve(vertices_.size());
        for (const Vec3& vertex : vertices_) {
            heights_.push_back(dot(plane.normal, vertex) - plane.offset);
        }
        for (const Triangle& triangle : mesh.triangles) {
            split(triangle);
        }
        close();
    }

    CutMesh halves() && { return {compact(below_), compact(above_), area_}; }

  private:
    bool is_above(Index vertex) const { return heights_[vertex] >= 0; }

    /// The same vertex for both triangles of an edge. One that lies in the plane is its own, so it leaves no slivers.
    Index crossing(Index a, Index b) {
        for (const Index end : {a, b}) {
            if (heights_[end] == 0) return end;
        }
        if (a > b) std::swap(a, b);
        const auto [entry, is_new] =
            crossings_.try_emplace(std::uint64_t{a} << 32 | b, static_cast<Index>(vertices_.size()));
        if (is_new) {
            const double share = heights_[a] / (heights_[a] - heights_[b]);
            Vec3 point = vertices_[a] + share * (vertices_[b] - vertices_[a]);
            for (int axis = 0; axis < 3; ++axis) {
                if (plane_.normal[axis] == 1) point[axis] = plane_.offset;
            }
            vertices_.push_back(point);
        }
        return entry->second;
    }

    static void add(std::vector<Triangle>& triangles, const Triangle& t) {
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }

    void split(const Triangle& triangle) {
        int above = 0;
        for (const Index vertex : triangle) {
            above += is_above(vertex) ? 1 : 0;
        }
        if (above == 0 || above == 3) {
            (above == 0 ? below_ : above_).push_back(triangle);
            return;
        }
        const bool lone_above = above == 1;
        std::size_t lone = 0;
        while (is_above(triangle[lone]) != lone_above) {
            ++lone;
        }
        const Index a = triangle[lone], b = triangle[(lone + 1) % 3], c = triangle[(lone + 2) % 3];
        const Index p = crossing(a, b), q = crossing(a, c);
        add(lone_above ? above_ : below_, {a, p, q});
        std::vector<Triangle>& others = lone_above ? below_ : above_;
        const Vec3 pc = vertices_[c] - vertices_[p], qb = vertices_[b] - vertices_[q];
        if (dot(pc, pc) < dot(qb, qb)) {
            add(others, {p, b, c});
            add(others, {p, c, q});
        } else {
            add(others, {p, b, q});
            add(others, {b, c, q});
        }
        if (p != q) steps_.push_back(lone_above ? Step{p, q} : Step{q, p});
    }

    /// Every vertex of the cut is left as often as it is come to, so the steps are loops.
    std::vector<Loop> loops() {
        std::stable_sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) { return a.first < b.first; });
        std::vector<bool> walked(steps_.size());
        const auto next = [&](Index from) {
            auto step = std::lower_bound(steps_.begin(), steps_.end(), from,
                                         [](const Step& a, Index vertex) { return a.first < vertex; });
            while (walked[static_cast<std::size_t>(step - steps_.begin())]) {
                ++step;
            }
            walked[static_cast<std::size_t>(step - steps_.begin())] = true;
            return step->second;
        };
        std::vector<Loop> loops;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            if (walked[i]) continue;
            Loop& loop = loops.emplace_back();
            Index vertex = steps_[i].first;
            do {
                loop.push_back(vertex);
                vertex = next(vertex);
            } while (vertex != steps_[i].first);
        }
        return loops;
    }

    void close() {
        // Seen along the axis that the plane faces most, from above.
        const Vec3& n = plane_.normal;
        const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
        const int axis = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
        int right = (axis + 1) % 3, up = (axis + 2) % 3;
        if (n[axis] < 0) std::swap(right, up);
        std::vector<PlanePoint> points;
        points.reserve(vertices_.size());
        for (const Vec3& vertex : vertices_) {
            points.push_back({vertex[right], vertex[up]});
        }
        for (const Triangle& t : fill_loops(points, loops())) {
            below_.push_back(t);
            above_.push_back({t[0], t[2], t[1]});
            area_ += dot(n, cross(vertices_[t[1]] - vertices_[t[0]], vertices_[t[2]] - vertices_[t[0]])) / 2;
        }
    }

    Mesh compact(std::vector<Triangle>& triangles) const {
        constexpr Index kUnused = std::numeric_limits<Index>::max();
        std::vector<Index> number(vertices_.size(), kUnused);
        Mesh mesh;
        for (Triangle& triangle : triangles) {
            for (Index& vertex : triangle) {
                if (number[vertex] == kUnused) {
                    number[vertex] = static_cast<Index>(mesh.vertices.size());
                    mesh.vertices.push_back(vertices_[vertex]);
                }
                vertex = number[vertex];
            }
        }
        mesh.triangles = std::move(triangles);
        return mesh;
    }

    Plane plane_;
    std::vector<Vec3> vertices_;
    std::vector<double> heights_;
    std::vector<Triangle> below_, above_;
    std::vector<Step> steps_;
    std::unordered_map<std::uint64_t, Index> crossings_;
    double area_ = 0;
};

}  // namespace

std::optional<double> clear_offset(const Mesh& mesh, const Vec3& normal, double wanted, double low, double high) {
    std::vector<double> heights;
    double largest = 0, nearest = Box::kInfinity;
    for (const Vec3& vertex : mesh.vertices) {
        const double height = dot(normal, vertex);
        nearest = std::min(nearest, std::abs(height - wanted));
        if (height > low - kClear && height < high + kClear) heights.push_back(height);
        largest = std::max({largest, std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
    }
    if (wanted >= low && wanted <= high && nearest >= kClear) return wanted;
    heights.insert(heights.end(), {low - kClear, high + kClear});
    std::sort(heights.begin(), heights.end());
    double best = 0;
    std::optional<double> offset;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const double middle = std::clamp((heights[i - 1] + heights[i]) / 2, low, high);
        const double room = std::min(middle - heights[i - 1], heights[i] - middle);
        const bool nearer = offset && std::abs(middle - wanted) < std::abs(*offset - wanted);
        if (room > best || (room == best && nearer)) {
            best = room;
            offset = middle;
        }
    }
    if (best <= largest * static_cast<double>(std::numeric_limits<float>::epsilon())) return std::nullopt;
    return offset;
}

CutMesh cut_mesh(const Mesh& mesh, const Plane& plane) { return Cutter(mesh, plane).halves(); }

}  // namespace spectralpack
