#include "spectralpack/tools/simplify.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <tuple>

#include "geometry/mesh_weld.hpp"

namespace spectralpack::tools {
namespace {

/// Removes pairs of triangles on the same corners that face opposite ways: fins without thickness, which collapsing
/// the edge between two others leaves where these had a third neighbour in common.
void remove_fins(Mesh& mesh) {
    struct Corners {
        Triangle sorted;
        std::size_t triangle;
        bool turned;  // the corners run the other way round than sorted
    };
    std::vector<Corners> all;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle t = mesh.triangles[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool turned = t[1] > t[2];
        if (turned) std::swap(t[1], t[2]);
        all.push_back({t, i, turned});
    }
    std::sort(all.begin(), all.end(), [](const Corners& a, const Corners& b) {
        return std::tie(a.sorted, a.triangle) < std::tie(b.sorted, b.triangle);
    });
    std::vector<bool> dropped(all.size(), false);
    for (std::size_t i = 1; i < all.size(); ++i) {
        const Corners &one = all[i - 1], &other = all[i];
        if (one.sorted != other.sorted || one.turned == other.turned || dropped[one.triangle]) continue;
        dropped[one.triangle] = dropped[other.triangle] = true;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!dropped[i]) mesh.triangles[kept++] = mesh.triangles[i];
    }
    mesh.triangles.resize(kept);
}

}  // namespace

Mesh simplified(const Mesh& mesh, std::size_t triangles, double error) {
    const Vec3 corner = bounding_box(mesh).min;  // single precision counts from here
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            positions.push_back(static_cast<float>(v[axis] - corner[axis]));
        }
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        indices.insert(indices.end(), t.begin(), t.end());
    }
    std::vector<std::uint32_t> left(indices.size());
    left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), positions.data(), mesh.vertices.size(),
                                 3 * sizeof(float), 3 * triangles, static_cast<float>(error), 0, nullptr));
    Mesh result;
    result.vertices = mesh.vertices;
    for (std::size_t i = 0; i < left.size(); i += 3) {
        result.triangles.push_back({left[i], left[i + 1], left[i + 2]});
    }
    remove_fins(result);
    weld_equal_vertices(result);  // drops the vertices that are no longer used
    return result;
}

}  // namespace spectralpack::tools
