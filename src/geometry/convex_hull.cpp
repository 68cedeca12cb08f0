#include "geometry/convex_hull.hpp"

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "spectralpack/geometry.hpp"

namespace spectralpack {
namespace {

constexpr double kFlat = 1e-9;  // of the size: thinner spans no volume

/// How far the points reach along the direction that the first of them leave free.
bool is_flat(const std::vector<Vec3>& points) {
    if (points.size() < 4) return true;
    Box box;
    for (const Vec3& p : points) {
        box.add(p);
    }
    const double size = length(box.size());
    const auto farthest = [&](const auto& measure) {
        return *std::max_element(points.begin(), points.end(),
                                 [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
    };
    const Vec3& a = points.front();
    const Vec3 along = farthest([&](const Vec3& p) { return length(p - a); }) - a;
    const auto off_line = [&](const Vec3& p) { return length(cross(p - a, along)); };
    const Vec3 across = farthest(off_line) - a;
    const Vec3 normal = cross(along, across);
    const auto off_plane = [&](const Vec3& p) { return std::abs(dot(p - a, normal)); };
    return !(length(normal) > kFlat * size * length(along)) ||
           !(off_plane(farthest(off_plane)) > kFlat * size * length(normal));
}

/// Qhull's state, which it frees in two steps.
struct Qhull {
    Qhull() { qh_zero(&state, silence.get()); }
    ~Qhull() {
        int left = 0, bytes = 0;
        qh_freeqhull(&state, !qh_ALL);
        qh_memfreeshort(&state, &left, &bytes);
    }
    Qhull(const Qhull&) = delete;
    Qhull& operator=(const Qhull&) = delete;

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> silence{std::fopen("/dev/null", "w")};  // for what it would print
    qhT state;
};

}  // namespace

ConvexHull convex_hull(const std::vector<Vec3>& points) {
    ConvexHull hull;
    if (is_flat(points) || points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return hull;
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vec3& p : points) {
        coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    }
    Qhull qhull;
    char command[] = "qhull Qt Pp";
    if (qh_new_qhull(&qhull.state, 3, static_cast<int>(points.size()), coordinates.data(), False, command, nullptr,
                     qhull.silence.get()) != 0) {
        return hull;
    }
    std::vector<bool> used(points.size(), false);
    for (const vertexT* vertex = qhull.state.vertex_list; vertex && vertex->next; vertex = vertex->next) {
        used[static_cast<std::size_t>(qh_pointid(&qhull.state, vertex->point))] = true;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (used[i]) hull.vertices.push_back(points[i]);
    }
    std::set<std::pair<int, int>> edges;
    for (facetT* facet = qhull.state.facet_list; facet && facet->next; facet = facet->next) {
        hull.normals.push_back({facet->normal[0], facet->normal[1], facet->normal[2]});
        std::vector<int> corners;
        vertexT *vertex, **vertexp;
        FOREACHvertex_(facet->vertices) { corners.push_back(qh_pointid(&qhull.state, vertex->point)); }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int a = corners[i], b = corners[(i + 1) % corners.size()];
            edges.emplace(std::min(a, b), std::max(a, b));
        }
    }
    for (const auto& [a, b] : edges) {
        hull.edges.push_back(points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)]);
    }
    return hull;
}

}  // namespace spectralpack
