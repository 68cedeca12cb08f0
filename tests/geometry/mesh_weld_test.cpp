/// Vertices that are joined, and edges that are counted, against plain loops over all pairs.

#include "geometry/mesh_weld.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>

#include "core/random.hpp"
#include "geometry/mesh_edges.hpp"

namespace spectralpack {
namespace {

TEST(MeshWeld, IsWhatComparingAllPairsGives) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        const auto vertices = 1 + random.below(300);
        for (std::uint64_t i = 0; i < vertices; ++i) {  // few distinct values, so that many coincide
            const auto coordinate = [&] { return static_cast<double>(random.below(5)) - 2; };
            mesh.vertices.push_back({coordinate() * 0.5, coordinate() * 0.0, coordinate() * 1e-300});
        }
        for (int i = 0; i < 200; ++i) {
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices))});
        }
        const Mesh before = mesh;
        weld_equal_vertices(mesh);
        std::vector<Vec3> distinct;  // used ones, in order
        for (std::uint32_t i = 0; i < vertices; ++i) {
            const bool used = std::any_of(before.triangles.begin(), before.triangles.end(), [&](const Triangle& t) {
                return std::find(t.begin(), t.end(), i) != t.end();
            });
            const Vec3& point = before.vertices[i];
            if (used && std::find(distinct.begin(), distinct.end(), point) == distinct.end()) {
                distinct.push_back(point);
            }
        }
        RC_ASSERT(mesh.vertices == distinct);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                RC_ASSERT(mesh.vertices[mesh.triangles[i][k]] == before.vertices[before.triangles[i][k]]);
            }
        }
    }));
}

TEST(MeshWeld, WithinAToleranceKeepsWhatIsFurtherApart) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < 120; ++i) {
            const auto coordinate = [&] { return static_cast<double>(random.below(4)) + 1e-3 * random.unit() - 1.5; };
            mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
            all.push_back(i);
        }
        for (std::uint32_t i = 0; i < 120; i += 3) {
            mesh.triangles.push_back({i, i + 1, i + 2});
        }
        const Mesh before = mesh;
        const double tolerance = 2e-3;  // above a cluster's diameter, far below the clusters' distance
        weld_near_vertices(mesh, all, tolerance);
        std::vector<std::uint32_t> target(120);
        for (std::size_t i = 0; i < 120; ++i) {
            target[i] = mesh.triangles[i / 3][i % 3];
        }
        for (std::size_t i = 0; i < 120; ++i) {
            for (std::size_t j = 0; j < 120; ++j) {
                const bool near = length(before.vertices[i] - before.vertices[j]) <= tolerance;
                RC_ASSERT((target[i] == target[j]) == near);
            }
        }
    }));
}

TEST(MeshEdges, AreCountedAsBruteForceCountsThem) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        mesh.vertices.resize(40);
        for (std::uint64_t i = 0; i < 1 + seed % 120; ++i) {  // vertex 0 is of high degree
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(2) * random.below(40)),
                                      static_cast<std::uint32_t>(random.below(40)),
                                      static_cast<std::uint32_t>(random.below(40))});
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                if (a < b) ++uses[{a, b}].first;
                if (b < a) ++uses[{b, a}].second;
            }
        }
        EdgeCount expected;
        expected.closed = !uses.empty();
        for (const auto& [edge, count] : uses) {
            const auto [forward, backward] = count;
            expected.border += (forward + backward) % 2 == 1;
            expected.misdirected += forward + backward == 2 && forward != 1;
            expected.crowded += forward + backward > 2;
            expected.closed = expected.closed && forward == backward;
        }
        const EdgeCount count = count_edges(MeshEdges(mesh));
        RC_ASSERT(count.border == expected.border);
        RC_ASSERT(count.misdirected == expected.misdirected);
        RC_ASSERT(count.crowded == expected.crowded);
        RC_ASSERT(count.closed == expected.closed);
        RC_ASSERT(is_closed(mesh) == expected.closed);
    }));
}

}  // namespace
}  // namespace spectralpack
