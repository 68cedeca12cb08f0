#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numeric>

#include "core/random.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/triangle_crossing.hpp"
#include "spectralpack/mesh_figures.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

/// The mesh without the listed triangles.
Mesh without(Mesh mesh, std::initializer_list<std::size_t> triangles) {
    std::vector<std::size_t> sorted(triangles);
    std::sort(sorted.rbegin(), sorted.rend());
    for (const std::size_t i : sorted) {
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return mesh;
}

double border_length(const Mesh& mesh) {
    double sum = 0;
    MeshEdges(mesh).for_each([&](std::uint32_t low, std::span<const MeshEdges::Use> uses) {
        if (uses.size() % 2 != 0) {
            sum += length(mesh.vertices[low] - mesh.vertices[uses[0].high]);
        }
    });
    return sum;
}

TEST(MeshFigures, FiguresOfABox) {
    const MeshFigures figures = inspect_mesh(box_mesh({1, 2, 3}, {11, 7, 5}));
    EXPECT_EQ(figures.box, (Box{{1, 2, 3}, {11, 7, 5}}));
    EXPECT_DOUBLE_EQ(figures.volume, 100);
    EXPECT_DOUBLE_EQ(figures.area, 2 * (50 + 20 + 10));
    EXPECT_EQ(figures.triangles, 12u);
    EXPECT_EQ(figures.vertices, 8u);
    EXPECT_EQ(figures.shells, 1u);
    EXPECT_TRUE(figures.watertight());
    EXPECT_EQ(figures.border_loops, 0u);
    EXPECT_EQ(figures.duplicates, 0u);
    EXPECT_EQ(figures.crossings.pairs, 0);
    EXPECT_FALSE(figures.crowded_place || figures.misdirected_place || figures.crossings.place);
}

TEST(MeshFigures, AMeshWithoutTrianglesHasNothing) {
    const MeshFigures figures = inspect_mesh({});
    EXPECT_EQ(figures.triangles, 0u);
    EXPECT_FALSE(figures.watertight());
}

TEST(MeshFigures, AMissingFacetIsOneLoopOfItsEdges) {
    const Mesh mesh = without(box_mesh({0, 0, 0}, {4, 3, 5}), {0});  // {0, 2, 1}: at z = 0
    const MeshFigures figures = inspect_mesh(mesh);
    EXPECT_FALSE(figures.watertight());
    EXPECT_EQ(figures.edges.border, 3u);
    ASSERT_EQ(figures.border_loops, 1u);
    EXPECT_EQ(figures.holes[0].edges, 3u);
    EXPECT_DOUBLE_EQ(figures.holes[0].length, 3 + 4 + 5);
    EXPECT_EQ(figures.holes[0].place.z, 0);
}

TEST(MeshFigures, TwoFacetsOfOneFaceAreOneLoop) {
    const MeshFigures figures = inspect_mesh(without(box_mesh({0, 0, 0}, {4, 3, 5}), {0, 1}));
    ASSERT_EQ(figures.border_loops, 1u);
    EXPECT_EQ(figures.holes[0].edges, 4u);
    EXPECT_DOUBLE_EQ(figures.holes[0].length, 14);
}

TEST(MeshFigures, HolesThatTouchAtACornerAreTwoLoopsLongestFirst) {
    // Triangles {0, 2, 1} and {5, 7, 6} have no vertex in common, {0, 2, 1} and {2, 4, 6} have one.
    const MeshFigures apart = inspect_mesh(without(box_mesh({0, 0, 0}, {4, 3, 5}), {0, 3}));
    EXPECT_EQ(apart.border_loops, 2u);
    const MeshFigures touching = inspect_mesh(without(box_mesh({0, 0, 0}, {4, 3, 5}), {0, 9}));
    ASSERT_EQ(touching.border_loops, 2u);
    EXPECT_GE(touching.holes[0].length, touching.holes[1].length);
}

TEST(MeshFigures, LoopsPartTheBorderWhateverIsMissing) {
    EXPECT_TRUE(rc::check([] {
        Mesh mesh = torus_mesh(10, 4, 9, 7);
        const auto keep = *rc::gen::container<std::vector<bool>>(
            mesh.triangles.size(), rc::gen::map(rc::gen::inRange(0, 8), [](int i) { return i > 0; }));
        Mesh holed{mesh.vertices, {}};
        for (std::size_t i = 0; i < keep.size(); ++i) {
            if (keep[i]) holed.triangles.push_back(mesh.triangles[i]);
        }
        RC_PRE(!holed.triangles.empty());
        const MeshFigures figures = inspect_mesh(holed);
        RC_PRE(figures.border_loops <= MeshFigures::kMostListed);
        std::size_t edges = 0;
        double length = 0;
        for (const BorderLoop& loop : figures.holes) {
            RC_ASSERT(loop.edges >= 3);
            edges += loop.edges;
            length += loop.length;
        }
        RC_ASSERT(edges == figures.edges.border);
        RC_ASSERT(std::abs(length - border_length(holed)) < 1e-9);
    }));
}

TEST(MeshFigures, CountsShellsAndWhatIsInsideThem) {
    const Mesh hollow = merged(cube_mesh(20), turned_inside_out(box_mesh({5, 5, 5}, {9, 9, 9})));
    const MeshFigures figures = inspect_mesh(hollow);
    EXPECT_EQ(figures.shells, 2u);
    EXPECT_TRUE(figures.watertight());
    EXPECT_DOUBLE_EQ(figures.volume, 8000 - 64);
    EXPECT_EQ(figures.crossings.pairs, 0);
}

TEST(MeshFigures, AFacetTurnedRoundIsInconsistent) {
    Mesh mesh = cube_mesh(10);
    std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
    const MeshFigures figures = inspect_mesh(mesh);
    EXPECT_EQ(figures.edges.misdirected, 3u);
    EXPECT_TRUE(figures.misdirected_place.has_value());
    EXPECT_FALSE(figures.watertight());
    EXPECT_EQ(figures.border_loops, 0u);
}

TEST(MeshFigures, AFinMakesACrowdedEdgeAndADuplicateIsCounted) {
    Mesh fin = cube_mesh(10);
    fin.vertices.push_back({-5, 0, 5});
    fin.triangles.push_back({0, 4, 8});
    const MeshFigures with_fin = inspect_mesh(fin);
    EXPECT_EQ(with_fin.edges.crowded, 1u);
    ASSERT_TRUE(with_fin.crowded_place);
    EXPECT_EQ(*with_fin.crowded_place, (Vec3{0, 0, 5}));

    Mesh twice = cube_mesh(10);
    twice.triangles.push_back(twice.triangles[3]);
    twice.triangles.push_back({twice.triangles[5][1], twice.triangles[5][0], twice.triangles[5][2]});
    EXPECT_EQ(inspect_mesh(twice).duplicates, 2u);
}

TEST(MeshFigures, TrianglesThatCross) {
    const Corners flat{Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{0, 10, 0}};
    const auto at = [&](const Corners& other) { return crossing_point(flat, other, 1e-6); };
    const auto through = at({Vec3{2, 2, -1}, Vec3{2, 2, 3}, Vec3{4, 4, 1}});
    ASSERT_TRUE(through);
    EXPECT_NEAR(through->z, 0, 1e-12);
    EXPECT_TRUE(at({Vec3{-5, 1, -1}, Vec3{20, 1, -1}, Vec3{5, 1, 9}}));  // all the way across
    EXPECT_TRUE(at({Vec3{0, 0, 0}, Vec3{3, 3, -1}, Vec3{3, 3, 1}}));     // with a corner in common
    EXPECT_FALSE(at({Vec3{0, 0, 0}, Vec3{-3, -3, -1}, Vec3{-3, -3, 1}}));
    EXPECT_FALSE(at({Vec3{2, 2, 0}, Vec3{2, 2, 3}, Vec3{4, 4, 1}}));      // stands on it
    EXPECT_FALSE(at({Vec3{1, 1, 0}, Vec3{3, 1, 0}, Vec3{1, 3, 0}}));      // lies on it
    EXPECT_FALSE(at({Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{5, 5, 1}}));     // folded at a common edge
    EXPECT_FALSE(at({Vec3{9, 9, -1}, Vec3{9, 9, 1}, Vec3{12, 12, 0}}));   // beside it
    EXPECT_FALSE(at({Vec3{2, 2, -1e-8}, Vec3{2, 2, 3}, Vec3{4, 4, 1}}));  // deeper by rounding only
}

TEST(MeshFigures, AGreaterToleranceFindsNothingNew) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        const auto corners = [&] {
            Corners made;
            for (Vec3& corner : made) {
                corner = {random.unit(), random.unit(), 0.01 * random.unit()};
            }
            return made;
        };
        const Corners a = corners(), b = corners();
        if (crossing_point(a, b, 0.01)) RC_ASSERT(crossing_point(a, b, 0.001).has_value());
        if (crossing_point(a, b, 0.001)) RC_ASSERT(crossing_point(a, b, 0).has_value());
    }));
}

TEST(MeshFigures, CubesThatOverlapCrossAlsoWhereEdgesMeetEdges) {
    const Mesh mesh = merged(cube_mesh(20), box_mesh({10, 10, 10}, {30, 30, 30}));
    const MeshFigures figures = inspect_mesh(mesh);
    EXPECT_GT(figures.crossings.pairs, 0);
    ASSERT_TRUE(figures.crossings.place);
    const Vec3 place = *figures.crossings.place;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(place[axis], 10 - 1e-9);
        EXPECT_LE(place[axis], 20 + 1e-9);
    }
}

TEST(MeshFigures, NeighboursAndTouchingSolidsDoNotCross) {
    EXPECT_EQ(inspect_mesh(torus_mesh(30, 10)).crossings.pairs, 0);
    EXPECT_EQ(inspect_mesh(sphere_mesh(17, 20)).crossings.pairs, 0);
    const Mesh touching = merged(cube_mesh(20), box_mesh({20, 5, 5}, {30, 15, 15}));
    EXPECT_EQ(inspect_mesh(touching).crossings.pairs, 0);
}

TEST(MeshFigures, TheTreeFindsWhatComparingAllPairsFinds) {
    RandomStream random(7);
    for (int round = 0; round < 20; ++round) {
        Mesh soup;
        for (std::uint32_t i = 0; i < 60; ++i) {
            const Vec3 centre{30 * random.unit(), 20 * random.unit(), 10 * random.unit()};
            for (int corner = 0; corner < 3; ++corner) {
                soup.vertices.push_back(centre + Vec3{8 * random.unit(), 8 * random.unit(), 8 * random.unit()});
            }
            soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        std::int64_t pairs = 0;
        const auto corners = [&](std::size_t i) {
            const Triangle& t = soup.triangles[i];
            return Corners{soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]};
        };
        for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const bool crosses = crossing_point(corners(i), corners(j), 1e-6).has_value();
                EXPECT_EQ(crosses, crossing_point(corners(j), corners(i), 1e-6).has_value());
                pairs += crosses ? 1 : 0;
            }
        }
        EXPECT_GT(pairs, 0);
        const SelfCrossings found = self_crossings(soup, 1e-6);
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(found.pairs, pairs);
    }
}

TEST(MeshFigures, TheSearchForCrossingsEndsWhereAllTrianglesMeetAll) {
    // Large triangles in a small space: nearly every box meets every other.
    Mesh fan;
    RandomStream random(3);
    for (std::uint32_t i = 0; i < 12'000; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            fan.vertices.push_back({random.unit(), random.unit(), random.unit()});
        }
        fan.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const SelfCrossings found = self_crossings(fan, 1e-6);
    EXPECT_FALSE(found.complete);
    EXPECT_GT(found.pairs, 1000);
}

}  // namespace
}  // namespace spectralpack::test
