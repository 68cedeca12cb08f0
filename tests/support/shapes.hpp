#pragma once
/// Small meshes made in code, for tests.

#include <cmath>
#include <numbers>

#include "spectralpack/mesh.hpp"

namespace spectralpack::test {

/// A closed box, 12 triangles, outward.
inline Mesh box_mesh(const Vec3& low, const Vec3& high) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

inline Mesh cube_mesh(double side) { return box_mesh({0, 0, 0}, {side, side, side}); }

/// All triangles of both; shells stay apart.
inline Mesh merged(Mesh a, const Mesh& b) {
    const auto base = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles) {
        a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
    return a;
}

/// An L of two boxes: no rotation maps it onto itself.
inline Mesh bracket() { return merged(box_mesh({0, 0, 0}, {7, 3, 2}), box_mesh({0, 0, 1.5}, {2.5, 2, 5})); }

inline Mesh turned_inside_out(Mesh mesh) {
    for (Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
    return mesh;
}

/// Torus around z, centred on the origin.
inline Mesh torus_mesh(double major, double minor, int around = 32, int across = 16) {
    Mesh mesh;
    const double tau = 2 * std::numbers::pi;
    for (int i = 0; i < around; ++i) {
        const double a = tau * i / around;
        for (int j = 0; j < across; ++j) {
            const double b = tau * j / across;
            const double r = major + minor * std::cos(b);
            mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// Sphere of `rings` x 2 rings facets, centred on the origin.
inline Mesh sphere_mesh(double radius, int rings = 12) {
    Mesh mesh;
    const int around = 2 * rings;
    mesh.vertices.push_back({0, 0, -radius});
    for (int i = 1; i < rings; ++i) {
        const double polar = std::numbers::pi * i / rings;
        for (int j = 0; j < around; ++j) {
            const double a = 2 * std::numbers::pi * j / around;
            mesh.vertices.push_back({radius * std::sin(polar) * std::cos(a), radius * std::sin(polar) * std::sin(a),
                                     -radius * std::cos(polar)});
        }
    }
    mesh.vertices.push_back({0, 0, radius});
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(1 + (i - 1) * around + j % around); };
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (int j = 0; j < around; ++j) {
        mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
        mesh.triangles.push_back({top, at(rings - 1, j), at(rings - 1, j + 1)});
        for (int i = 1; i < rings - 1; ++i) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return mesh;
}

/// No turn, and quarter turns about x and y.
inline std::vector<Mat3> three_turns() {
    return {Mat3{}, Mat3{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}},
            Mat3{{Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}}}};
}

}  // namespace spectralpack::test
