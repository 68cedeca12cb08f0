#pragma once
/// Meshes that make voxelisers stumble.

#include <algorithm>
#include <array>
#include <vector>

#include "core/random.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {

/// The signed permutations, mirrors among them if asked for.
inline std::vector<Mat3> axis_turns(bool mirrors) {
    std::vector<Mat3> turns;
    std::array<int, 3> axes{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Mat3 m;
            for (std::size_t row = 0; row < 3; ++row) {
                m.rows[row] = {};
                m.rows[row][axes[row]] = signs >> row & 1 ? -1 : 1;
            }
            if (mirrors || determinant(m) == 1) turns.push_back(m);
        }
    } while (std::ranges::next_permutation(axes).found);
    return turns;
}

class RandomMesh {
  public:
    explicit RandomMesh(std::uint64_t seed) : random_(seed) {}

    std::uint64_t below(std::uint64_t bound) { return random_.below(bound); }
    double within(double low, double high) { return low + (high - low) * random_.unit(); }
    Vec3 point(double low, double high) {
        return {within(low, high), within(low, high), within(low, high)};  // braces: in order
    }

    /// Rotation by any angles about all axes.
    Mat3 rotation() {
        Mat3 result;
        for (int axis = 0; axis < 3; ++axis) {
            const double angle = within(0, 7), s = std::sin(angle), c = std::cos(angle);
            Mat3 turn;
            const auto a = static_cast<std::size_t>((axis + 1) % 3), b = static_cast<std::size_t>((axis + 2) % 3);
            turn.rows[a] = turn.rows[b] = {};
            turn.rows[a][static_cast<int>(a)] = turn.rows[b][static_cast<int>(b)] = c;
            turn.rows[a][static_cast<int>(b)] = -s;
            turn.rows[b][static_cast<int>(a)] = s;
            result = turn * result;
        }
        return result;
    }

    /// A box whose corners are multiples of `step`, so that it shares faces, edges and corners with
    /// others.
    Mesh coarse_box(double step) {
        Vec3 low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = step * static_cast<double>(below(5));
            high[axis] = low[axis] + step * static_cast<double>(1 + below(4));
        }
        return box_mesh(low, high);
    }

    /// Closed; perhaps of several shells that cross, touch or are inside-out.
    Mesh closed() {
        Mesh mesh;
        const std::uint64_t shells = 1 + below(3);
        for (std::uint64_t i = 0; i < shells; ++i) {
            Mesh shell;
            switch (below(5)) {
                case 0: {
                    const double major = within(2, 6);
                    shell = torus_mesh(major, within(0.2, 2), 9, 6);
                    break;
                }
                case 1:
                    shell = sphere_mesh(within(0.3, 5), 4);
                    break;
                case 2:
                    shell = box_mesh({0, 0, 0}, point(0.01, 8));
                    break;
                case 3:
                    shell = tetrahedron();
                    break;
                default:
                    shell = coarse_box(below(2) == 0 ? 1 : 0.5);
                    break;
            }
            const bool keep = below(3) == 0;
            shell = transformed(shell, {keep ? Mat3{} : rotation(), keep ? Vec3{} : point(-3, 3)});
            if (below(4) == 0) shell = turned_inside_out(shell);
            mesh = merged(mesh, shell);
        }
        return mesh;
    }

    /// Loose triangles: open, with needles, segments and points among them.
    Mesh soup() {
        Mesh mesh;
        const std::uint64_t triangles = 1 + below(12);
        for (std::uint64_t i = 0; i < triangles; ++i) {
            const Vec3 a = point(-4, 4);
            Vec3 b = a + point(-5, 5), c = a + point(-5, 5);
            switch (below(6)) {
                case 0:
                    c = a + 1e-9 * point(-1, 1);
                    break;
                case 1:
                    c = a + within(0, 1) * (b - a);
                    break;
                case 2:
                    b = c = a;
                    break;
                case 3:
                    b = a + point(-0.3, 0.3), c = a + point(-0.3, 0.3);
                    break;
                default:
                    break;
            }
            const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
            mesh.triangles.push_back({base, base + 1, base + 2});
        }
        return mesh;
    }

  private:
    Mesh tetrahedron() {
        Mesh mesh;
        for (int i = 0; i < 4; ++i) {
            mesh.vertices.push_back(point(-4, 4));
        }
        mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
        return mesh;
    }

    RandomStream random_;
};

}  // namespace spectralpack::test
