#include "verify/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <numeric>

#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_weld.hpp"

namespace spectralpack {
namespace {

using Vector = fcl::Vector3<double>;

/// A ray that comes nearer than this to an edge is not counted with.
constexpr double kGrazing = 1e-6;  ///< mm
/// Boxes are asked with so much room, for rounding.
constexpr double kBoxRoom = 1e-7;  ///< mm
constexpr int kDirections = 16;
constexpr int kDeepCandidates = 8;

Vector to_fcl(const Vec3& v) { return {v.x, v.y, v.z}; }

using Volume = fcl::RSS<double>;

/// The box of a rectangle swept by a sphere: in the volume's axes, about the rectangle's middle.
struct LocalBox {
    explicit LocalBox(const Volume& swept)
        : volume(swept), middle(swept.l[0] / 2, swept.l[1] / 2, 0), half(middle + Vector::Constant(swept.r)) {}

    Vector to_local(const Vector& point) const { return volume.axis.transpose() * (point - volume.To) - middle; }

    const Volume& volume;
    Vector middle, half;
};

/// The k-th of a fixed list of directions that are parallel to nothing in particular (a spiral on the sphere).
Vec3 direction(int k) {
    const double z = 1 - (2 * k + 1.3) / (kDirections + 1);
    const double turn = 0.7 + k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Calls visit(primitive) for every triangle whose box meets the ray.
template <class Visit>
void for_each_on_ray(const Hierarchy& hierarchy, const Vec3& from, const Vec3& along, Visit visit) {
    const Vector origin = to_fcl(from), way = to_fcl(along);
    const auto meets = [&](const Volume& volume) {
        const LocalBox box(volume);
        const Vector start = box.to_local(origin), step = volume.axis.transpose() * way;
        double begin = 0, end = Box::kInfinity;
        for (int axis = 0; axis < 3; ++axis) {
            const double reach = box.half[axis] + kBoxRoom;
            if (std::abs(step[axis]) < 1e-12) {
                if (std::abs(start[axis]) > reach) return false;
                continue;
            }
            const double middle = -start[axis] / step[axis], half = std::abs(reach / step[axis]);
            begin = std::max(begin, middle - half);
            end = std::min(end, middle + half);
        }
        return begin <= end;
    };
    std::vector<int> open{0};
    while (!open.empty()) {
        const auto& node = hierarchy.getBV(open.back());
        open.pop_back();
        if (!meets(node.bv)) continue;
        if (node.isLeaf()) {
            visit(node.primitiveId());
        } else {
            open.push_back(node.leftChild());
            open.push_back(node.rightChild());
        }
    }
}

/// Looks along a ray: coordinates across it and along it.
class RayFrame {
  public:
    RayFrame(const Vec3& from, const Vec3& along) : from_(from), along_(along) {
        const Vec3 other = std::abs(along.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 across = cross(along, other);
        x_ = 1 / length(across) * across;
        y_ = cross(along, x_);
    }

    struct Crossing {
        int sign = 0;          ///< 1: out of the surface's back, -1: into its front, 0: missed
        bool grazing = false;  ///< too near an edge, or starts on the surface: not to be relied on
        double distance = 0;   ///< along the ray
    };

    Crossing cross_triangle(const Corners& corners) const {
        std::array<Vec3, 3> p;
        for (int i = 0; i < 3; ++i) {
            const Vec3 d = corners[i] - from_;
            p[i] = {dot(d, x_), dot(d, y_), dot(d, along_)};
        }
        Crossing crossing;
        if (std::max({p[0].z, p[1].z, p[2].z}) < -kGrazing) return crossing;
        std::array<double, 3> turns{};  // of the ray about each edge
        for (int i = 0; i < 3; ++i) {
            const Vec3& a = p[i];
            const Vec3& b = p[(i + 1) % 3];
            turns[i] = a.x * b.y - a.y * b.x;
            const double ex = b.x - a.x, ey = b.y - a.y, ee = ex * ex + ey * ey;
            const double t = ee > 0 ? std::clamp(-(a.x * ex + a.y * ey) / ee, 0.0, 1.0) : 0;
            const double nx = a.x + t * ex, ny = a.y + t * ey;
            if (nx * nx + ny * ny < kGrazing * kGrazing) {
                crossing.grazing = true;
                return crossing;
            }
        }
        const bool left = turns[0] > 0 && turns[1] > 0 && turns[2] > 0;
        const bool right = turns[0] < 0 && turns[1] < 0 && turns[2] < 0;
        if (!left && !right) return crossing;
        crossing.distance =
            (turns[1] * p[0].z + turns[2] * p[1].z + turns[0] * p[2].z) / (turns[0] + turns[1] + turns[2]);
        crossing.grazing = std::abs(crossing.distance) < kGrazing;
        if (crossing.distance > 0) crossing.sign = left ? 1 : -1;
        return crossing;
    }

  private:
    Vec3 from_, along_, x_, y_;
};

/// The winding number as the sum of solid angles (Van Oosterom and Strackee 1983): linear time, needs no luck.
int winding_by_solid_angle(const Mesh& mesh, const Vec3& point) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - point, b = mesh.vertices[t[1]] - point, c = mesh.vertices[t[2]] - point;
        const double la = length(a), lb = length(b), lc = length(c);
        sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

/// The library says by its return values that there is no memory, and goes on.
void require_built(int outcome) {
    if (outcome != fcl::BVH_OK) throw std::bad_alloc();
}

}  // namespace

Solid::Solid(const Mesh& mesh, const Transform& transform, double depth) : mesh_(transformed(mesh, transform)) {
    weld_equal_vertices(mesh_);
    box_ = bounding_box(mesh_);
    closed_ = is_closed(mesh_);

    std::vector<Vector> vertices;
    std::vector<fcl::Triangle> triangles;
    for (const Vec3& v : mesh_.vertices) {
        vertices.push_back(to_fcl(v));
    }
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        if (!(least_height(corners(i)) > kNeedle)) continue;
        const Triangle& t = mesh_.triangles[i];
        triangles.emplace_back(t[0], t[1], t[2]);
        kept_.push_back(i);
    }
    if (!kept_.empty()) {
        hierarchy_.emplace();
        require_built(hierarchy_->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size())));
        require_built(hierarchy_->addSubModel(vertices, triangles));
        require_built(hierarchy_->endModel());
    }
    find_shells();
    if (closed_) find_deep_points(depth);
}

Corners Solid::corners(std::size_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
}

int Solid::winding(const Vec3& point) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (point[axis] < box_.min[axis] || point[axis] > box_.max[axis]) return 0;
    }
    if (!hierarchy_) return 0;
    for (int k = 0; k < kDirections; ++k) {
        const Vec3 along = direction(k);
        const RayFrame frame(point, along);
        int sum = 0;
        bool grazing = false;
        for_each_on_ray(*hierarchy_, point, along, [&](int primitive) {
            if (grazing) return;
            const auto crossing = frame.cross_triangle(corners(triangle(primitive)));
            grazing = crossing.grazing;
            sum += crossing.sign;
        });
        if (!grazing) return sum;
    }
    return winding_by_solid_angle(mesh_, point);
}

double Solid::surface_distance(const Vec3& point) const {
    if (!hierarchy_) return Box::kInfinity;
    const Vector p = to_fcl(point);
    const auto box_distance = [&](int node) {
        const LocalBox box(hierarchy_->getBV(node).bv);
        return (box.to_local(p).cwiseAbs() - box.half).cwiseMax(0).norm() - kBoxRoom;
    };
    double best = Box::kInfinity;
    std::vector<std::pair<double, int>> open{{box_distance(0), 0}};
    while (!open.empty()) {
        const auto [lower, index] = open.back();
        open.pop_back();
        if (lower >= best) continue;
        const auto& node = hierarchy_->getBV(index);
        if (node.isLeaf()) {
            best = std::min(best, point_triangle_distance(point, corners(triangle(node.primitiveId()))));
            continue;
        }
        std::pair near(box_distance(node.leftChild()), node.leftChild());
        std::pair far(box_distance(node.rightChild()), node.rightChild());
        if (far.first < near.first) std::swap(near, far);
        open.push_back(far);
        open.push_back(near);
    }
    return best;
}

void Solid::find_shells() {
    // Union-find over vertices; shells are numbered by their first triangle.
    std::vector<std::size_t> parent(mesh_.vertices.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t v) {
        while (parent[v] != v) {
            v = parent[v] = parent[parent[v]];
        }
        return v;
    };
    for (const Triangle& t : mesh_.triangles) {
        parent[root(t[1])] = root(t[0]);
        parent[root(t[2])] = root(t[0]);
    }
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> number(mesh_.vertices.size(), kNone);
    for (const Triangle& t : mesh_.triangles) {
        std::size_t& shell = number[root(t[0])];
        if (shell == kNone) {
            shell = shells_.size();
            shells_.push_back({mesh_.vertices[t[0]], std::nullopt});
        }
        shell_of_.push_back(shell);
    }
}

void Solid::find_deep_points(double depth) {
    // From the middles of each shell's largest triangles to half way through the material behind them.
    std::vector<double> area(mesh_.triangles.size());
    for (std::size_t i = 0; i < area.size(); ++i) {
        const Corners c = corners(i);
        area[i] = length(cross(c[1] - c[0], c[2] - c[0]));
    }
    std::vector<std::size_t> order = kept_;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
    std::vector<int> tried(shells_.size(), 0);
    std::vector<double> deepest(shells_.size(), depth);
    for (const std::size_t i : order) {
        const std::size_t shell = shell_of_[i];
        if (tried[shell]++ >= kDeepCandidates) continue;
        const std::optional<Vec3> point = middle_behind(i);
        if (!point || winding(*point) == 0) continue;
        const double reached = surface_distance(*point);
        if (reached > deepest[shell]) {
            deepest[shell] = reached;
            shells_[shell].deep_point = point;
        }
    }
}

std::optional<Vec3> Solid::middle_behind(std::size_t index) const {
    const Corners c = corners(index);
    if (!(least_height(c) > kNeedle)) return std::nullopt;
    const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
    const Vec3 inward = -1 / length(normal) * normal;
    // Not the very middle: on regular meshes that often lies opposite to an edge.
    const Vec3 middle = 0.2957 * c[0] + 0.3391 * c[1] + 0.3652 * c[2];
    const RayFrame frame(middle, inward);
    double opposite = Box::kInfinity;
    for_each_on_ray(*hierarchy_, middle, inward, [&](int primitive) {
        const auto crossing = frame.cross_triangle(corners(triangle(primitive)));
        if (crossing.sign != 0 && crossing.distance > kGrazing) {
            opposite = std::min(opposite, crossing.distance);
        }
    });
    if (opposite == Box::kInfinity) return std::nullopt;
    return middle + opposite / 2 * inward;
}

}  // namespace spectralpack
