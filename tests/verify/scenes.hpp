#pragma once
/// Random poses and block solids.

#include <array>
#include <map>
#include <set>

#include "core/random.hpp"
#include "support/shapes.hpp"
#include "verify/overlap.hpp"

namespace spectralpack::test {

inline double between(RandomStream& random, double low, double high) { return low + (high - low) * random.unit(); }

inline Vec3 random_point(RandomStream& random, double reach) {
    return {between(random, -reach, reach), between(random, -reach, reach), between(random, -reach, reach)};
}

inline Vec3 random_direction(RandomStream& random) {
    for (;;) {
        const Vec3 v = random_point(random, 1);
        if (dot(v, v) > 0.01 && dot(v, v) < 1) return 1 / length(v) * v;
    }
}

inline Mat3 random_rotation(RandomStream& random) {
    const Vec3 x = random_direction(random);
    const Vec3 across = cross(x, random_direction(random));
    if (length(across) < 0.1) return random_rotation(random);
    const Vec3 y = 1 / length(across) * across;
    return transposed({{x, y, cross(x, y)}});
}

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

/// The surface of a union of unit cells, each side two triangles, cut along either diagonal. Cells that meet in an
/// edge or a corner only share its vertices.
inline Mesh block_mesh(const Cells& cells, bool other_diagonal = false) {
    Mesh mesh;
    std::map<Cell, std::uint32_t> index;
    const auto vertex = [&](const Cell& at) {
        const auto [found, fresh] = index.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (fresh) mesh.vertices.push_back({double(at[0]), double(at[1]), double(at[2])});
        return found->second;
    };
    for (const Cell& cell : cells) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                Cell next = cell;
                next[axis] += side ? 1 : -1;
                if (cells.contains(next)) continue;
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                std::array<std::uint32_t, 4> corner{};
                for (int i = 0; i < 4; ++i) {
                    Cell at = cell;
                    at[axis] += side;
                    at[u] += (i == 1 || i == 2);
                    at[v] += (i >= 2);
                    corner[i] = vertex(at);
                }
                if (!side) std::swap(corner[1], corner[3]);
                const int first = other_diagonal ? 1 : 0;
                for (int half = 0; half < 2; ++half) {
                    mesh.triangles.push_back(
                        {corner[first], corner[(first + 1 + half) % 4], corner[(first + 2 + half) % 4]});
                }
            }
        }
    }
    return mesh;
}

/// Cells of a box.
inline Cells box_cells(const Cell& low, const Cell& high) {
    Cells cells;
    for (int x = low[0]; x < high[0]; ++x) {
        for (int y = low[1]; y < high[1]; ++y) {
            for (int z = low[2]; z < high[2]; ++z) {
                cells.insert({x, y, z});
            }
        }
    }
    return cells;
}

inline Cells random_cells(RandomStream& random, const Cell& size, double filling) {
    Cells cells;
    for (const Cell& cell : box_cells({0, 0, 0}, size)) {
        if (random.unit() < filling) cells.insert(cell);
    }
    if (cells.empty()) cells.insert({0, 0, 0});
    return cells;
}

constexpr double kTolerance = 1e-3;
constexpr double kFar = std::numeric_limits<double>::infinity();

inline Transform moved_by(const Vec3& step) { return {Mat3{}, step}; }

/// Compares two meshes as they stand, posed after the fact so that poses are exercised.
inline Relation compare_meshes(const Mesh& a, const Mesh& b, const Transform& pose_a = {}, const Transform& pose_b = {},
                               double bound = kFar) {
    const Solid solid_a(a, {}, deep_enough(kTolerance)), solid_b(b, {}, deep_enough(kTolerance));
    return compare({&solid_a, pose_a}, {&solid_b, pose_b}, kTolerance, bound);
}

inline bool apart(const Relation& relation) { return relation.kind == Relation::Kind::apart; }

}  // namespace spectralpack::test
