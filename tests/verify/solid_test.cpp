#include "verify/solid.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "scenes.hpp"

namespace spectralpack::test {
namespace {

TEST(Solid, WindingAgreesWithSolidAngles) {
    RandomStream random(1);
    Mesh crossing = merged(torus_mesh(6, 2, 12, 7), transformed(torus_mesh(6, 2, 10, 6), {Mat3{}, {5, 1, 0.5}}));
    const Mesh shapes[] = {cube_mesh(9),
                           crossing,
                           merged(cube_mesh(9), turned_inside_out(box_mesh({2, 2, 2}, {5, 6, 7}))),
                           turned_inside_out(sphere_mesh(7, 5)),
                           block_mesh(random_cells(random, {4, 3, 3}, 0.5)),
                           merged(sphere_mesh(5, 4), sphere_mesh(5, 4))};
    for (const Mesh& mesh : shapes) {
        const Solid solid(mesh, {}, 3e-3);
        ASSERT_TRUE(solid.closed());
        int inside = 0;
        for (int i = 0; i < 600; ++i) {
            // Half of them where rays are in trouble: in line with vertices and edges.
            Vec3 p = random_point(random, 9);
            if (i % 2 == 0) p = {std::round(p.x) + 0.5, std::round(p.y) + 0.25, std::round(p.z) + 0.125};
            EXPECT_EQ(solid.winding(p), reference_winding(mesh, p)) << p.x << " " << p.y << " " << p.z;
            EXPECT_NEAR(solid.surface_distance(p), reference_surface_distance(mesh, p), 1e-12);
            inside += solid.winding(p) != 0;
        }
        EXPECT_GT(inside, 0);
    }
}

TEST(Solid, WindingNeedsNoLuckNextToASurface) {
    const Solid cube(cube_mesh(10), {}, 3e-3);
    for (const double off : {1e-3, 1e-5}) {
        EXPECT_EQ(cube.winding({5, 5, off}), 1);
        EXPECT_EQ(cube.winding({off, off, off}), 1);
        EXPECT_EQ(cube.winding({5, 5, -off}), 0);
        EXPECT_EQ(cube.winding({10 + off, 5, 5}), 0);
        EXPECT_EQ(cube.winding({10 - off, 10 - off, off}), 1);
    }
}

TEST(Solid, EveryShellHasADeepPoint) {
    RandomStream random(3);
    const Mesh shapes[] = {cube_mesh(10),
                           torus_mesh(9, 1),
                           box_mesh({0, 0, 0}, {100, 50, 0.02}),
                           merged(cube_mesh(9), turned_inside_out(box_mesh({2, 2, 2}, {5, 6, 7}))),
                           merged(cube_mesh(9), box_mesh({20, 0, 0}, {21, 1, 1})),
                           block_mesh(random_cells(random, {4, 3, 3}, 0.5))};
    const std::size_t shells[] = {1, 1, 1, 2, 2, 0};
    for (std::size_t i = 0; i < std::size(shapes); ++i) {
        const Solid solid(shapes[i], {}, 3e-3);
        EXPECT_EQ(solid.shells().size(), shells[i] > 0 ? shells[i] : solid.shells().size());
        for (const Solid::Shell& shell : solid.shells()) {
            ASSERT_TRUE(shell.deep_point) << i;
            EXPECT_NE(reference_winding(shapes[i], *shell.deep_point), 0);
            EXPECT_GT(reference_surface_distance(shapes[i], *shell.deep_point), 3e-3);
        }
    }
    // A foil has none, nor has an open mesh.
    EXPECT_FALSE(Solid(box_mesh({0, 0, 0}, {9, 9, 0.004}), {}, 3e-3).shells()[0].deep_point);
    Mesh open = cube_mesh(10);
    open.triangles.pop_back();
    EXPECT_FALSE(Solid(open, {}, 3e-3).closed());
    EXPECT_FALSE(Solid(open, {}, 3e-3).shells()[0].deep_point);
}

TEST(Solid, SoupIsWeldedAndScaled) {
    const Mesh cube = cube_mesh(1);
    Mesh soup;
    for (const Triangle& t : cube.triangles) {
        const auto base = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) {
            soup.vertices.push_back(cube.vertices[v]);
        }
        soup.triangles.push_back({base, base + 1, base + 2});
    }
    const Solid solid(soup, {25.4 * Mat3{}, {}}, 3e-3);
    EXPECT_TRUE(solid.closed());
    EXPECT_EQ(solid.mesh().vertices.size(), 8u);
    EXPECT_NEAR(solid.box().max.x, 25.4, 1e-12);
}

TEST(Solid, ShellsHangTogetherByVertices) {
    // Two cells that share an edge, one far away, and one that touches only by equal coordinates.
    const Solid solid(block_mesh({{0, 0, 0}, {1, 1, 0}, {5, 5, 5}, {2, 2, 1}}), {}, 3e-3);
    EXPECT_EQ(solid.shells().size(), 2u);
    EXPECT_EQ(solid.shell_of(0), 0u);
}

TEST(Solid, NeedlesAreNoSurface) {
    Mesh mesh = cube_mesh(10);
    mesh.vertices.push_back({5, 5e-8, 0});
    mesh.triangles.push_back({0, 8, 1});
    mesh.triangles.push_back({0, 1, 8});
    const Solid solid(mesh, {}, 3e-3);
    EXPECT_TRUE(solid.closed());
    EXPECT_EQ(solid.hierarchy()->num_tris, 12);
    EXPECT_EQ(solid.winding({5, 1, 1}), 1);
}

}  // namespace
}  // namespace spectralpack::test
