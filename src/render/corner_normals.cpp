#include "render/corner_normals.hpp"

namespace spectralpack {
namespace {

constexpr double kCrease = 0.848;  // cosine of 32 degrees: twelve-sided rounds are still round
constexpr std::size_t kMostAround = 128;

Vec3 unit_or_zero(const Vec3& v) {
    const double size = length(v);
    return size > 0 ? 1 / size * v : Vec3{};
}

/// Which corners (3 * triangle + place in it) meet at a vertex.
struct Around {
    explicit Around(const Mesh& mesh) : begin(mesh.vertices.size() + 1), corners(3 * mesh.triangles.size()) {
        for (const Triangle& t : mesh.triangles) {
            for (const std::uint32_t vertex : t) {
                ++begin[vertex + 1];
            }
        }
        for (std::size_t v = 1; v < begin.size(); ++v) {
            begin[v] += begin[v - 1];
        }
        std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            corners[next[mesh.triangles[c / 3][c % 3]]++] = c;
        }
    }
    std::vector<std::size_t> begin, corners;
};

}  // namespace

std::vector<CornerNormals> corner_normals(const Mesh& mesh) {
    const Around around(mesh);
    std::vector<Vec3> flat(mesh.triangles.size());
    std::vector<double> weight(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = mesh.vertices[mesh.triangles[t][k]];
        }
        const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
        flat[t] = unit_or_zero(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = unit_or_zero(p[(k + 1) % 3] - p[k]), b = unit_or_zero(p[(k + 2) % 3] - p[k]);
            weight[3 * t + k] = length(normal) * std::acos(std::min(1.0, std::max(-1.0, dot(a, b))));
        }
    }
    std::vector<CornerNormals> result(flat.size());
    for (std::size_t t = 0; t < flat.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t vertex = mesh.triangles[t][k];
            const std::size_t first = around.begin[vertex], last = around.begin[vertex + 1];
            Vec3 normal = flat[t];
            if (last - first <= kMostAround) {
                Vec3 sum;
                for (std::size_t i = first; i < last; ++i) {
                    const std::size_t corner = around.corners[i];
                    const Vec3& other = flat[corner / 3];
                    if (dot(other, flat[t]) > kCrease) sum = sum + weight[corner] * other;
                }
                if (length(sum) > 0) normal = unit_or_zero(sum);
            }
            result[t][k] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
        }
    }
    return result;
}

}  // namespace spectralpack
