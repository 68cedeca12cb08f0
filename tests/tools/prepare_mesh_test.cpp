#include "spectralpack/tools/prepare.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "geometry/mesh_edges.hpp"
#include "spectralpack/tools/simplify.hpp"
#include "support/names.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

using namespace tools;

Mesh scaled(const Mesh& mesh, double factor) { return transformed(mesh, {factor * Mat3{}, {}}); }

TEST(PrepareMesh, KeepsAGoodMeshAsItIs) {
    const PreparedMesh prepared = prepare_mesh(box_mesh({5, 5, 5}, {25, 15, 10}), {});
    EXPECT_EQ(prepared.outcome, Prepared::kept);
    EXPECT_EQ(prepared.scale, 1);
    EXPECT_TRUE(prepared.detail.empty());
    EXPECT_EQ(prepared.mesh.triangles.size(), 12u);
    EXPECT_EQ(bounding_box(prepared.mesh), (Box{{0, 0, 0}, {20, 10, 5}}));
}

TEST(PrepareMesh, DropsWhatEnclosesNothingAndSaysWhy) {
    Mesh open = cube_mesh(20);
    open.triangles.pop_back();
    EXPECT_EQ(prepare_mesh(open, {}).outcome, Prepared::open);
    EXPECT_TRUE(names(prepare_mesh(open, {}).detail, {3, "edges"}));
    EXPECT_TRUE(prepare_mesh(open, {}).mesh.triangles.empty());

    EXPECT_EQ(prepare_mesh(turned_inside_out(cube_mesh(20)), {}).outcome, Prepared::no_volume);

    Mesh turned = cube_mesh(20);
    std::swap(turned.triangles[0][1], turned.triangles[0][2]);
    EXPECT_EQ(prepare_mesh(turned, {}).outcome, Prepared::inconsistent);

    // Two cubes that share an edge, and its vertices.
    Mesh touching = merged(cube_mesh(20), box_mesh({20, 20, 0}, {40, 40, 20}));
    for (Triangle& t : touching.triangles) {
        for (std::uint32_t& v : t) {
            if (v == 8) v = 3;
            if (v == 12) v = 7;
        }
    }
    EXPECT_EQ(prepare_mesh(touching, {}).outcome, Prepared::non_manifold);
    EXPECT_TRUE(names(prepare_mesh(touching, {}).detail, {1, "edge"}));
}

TEST(PrepareMesh, ShellsMayCross) {
    EXPECT_EQ(prepare_mesh(merged(cube_mesh(20), box_mesh({10, 10, 10}, {30, 30, 30})), {}).outcome, Prepared::kept);
}

TEST(PrepareMesh, ScalesDownToTheTrayAsItLiesAndUpToTwoMillimetres) {
    const PreparedMesh large = prepare_mesh(box_mesh({0, 0, 0}, {100, 490, 100}), {});
    EXPECT_DOUBLE_EQ(large.scale, 0.5);
    EXPECT_NEAR(bounding_box(large.mesh).size().y, 245, 1e-9);
    const PreparedMesh small = prepare_mesh(box_mesh({0, 0, 0}, {0.5, 0.25, 0.1}), {});
    EXPECT_DOUBLE_EQ(small.scale, 4);
    EXPECT_NEAR(bounding_box(small.mesh).size().x, 2, 1e-12);
    EXPECT_EQ(prepare_mesh(box_mesh({0, 0, 0}, {2.5, 0.25, 0.1}), {}).scale, 1);
    const PreparedMesh thin_tray = prepare_mesh(box_mesh({0, 0, 0}, {1, 1, 1}), {{480, 245, 2}, 2, 4000});
    EXPECT_DOUBLE_EQ(thin_tray.scale, 2);
}

TEST(PrepareMesh, SimplifiesDenseMeshesAndKeepsTheirShape) {
    for (const Mesh& dense : {torus_mesh(30, 10, 200, 100), sphere_mesh(25, 100)}) {
        const PreparedMesh prepared = prepare_mesh(dense, {{480, 245, 200}, 2, 2000});
        ASSERT_EQ(prepared.outcome, Prepared::kept);
        EXPECT_LE(prepared.mesh.triangles.size(), 2000u);
        EXPECT_GE(prepared.mesh.triangles.size(), 1000u);
        const EdgeCount edges = count_edges(MeshEdges(prepared.mesh));
        EXPECT_TRUE(edges.closed);
        EXPECT_EQ(edges.crowded, 0u);
        EXPECT_NEAR(signed_volume(prepared.mesh), signed_volume(dense), 0.03 * signed_volume(dense));
        const Vec3 size = bounding_box(prepared.mesh).size(), was = bounding_box(dense).size();
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(size[axis], was[axis], 0.02 * 80);
        }
    }
}

TEST(PrepareMesh, WhereNoFewerTrianglesAreAlikeMoreAreKept) {
    // Two hundred small boxes: none can lose a triangle and stay a box.
    Mesh many;
    for (int i = 0; i < 200; ++i) {
        many = merged(many, box_mesh({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1}));
    }
    const PreparedMesh prepared = prepare_mesh(many, {{1000, 1000, 1000}, 2, 500});
    EXPECT_EQ(prepared.outcome, Prepared::kept);
    EXPECT_NEAR(signed_volume(prepared.mesh), 200, 6);
    EXPECT_GT(prepared.mesh.triangles.size(), 500u);
    EXPECT_FALSE(prepared.detail.empty());
}

RC_GTEST_PROP(PrepareMesh, SimplificationNeverOpensAMesh, ()) {
    const int around = *rc::gen::inRange(3, 40), across = *rc::gen::inRange(3, 30);
    const Mesh mesh = scaled(torus_mesh(3, 1, around, across), *rc::gen::element(0.01, 1.0, 1000.0));
    const auto target = static_cast<std::size_t>(*rc::gen::inRange(1, 2 * around * across));
    const Mesh simple = simplified(mesh, target, *rc::gen::element(0.001, 0.1, 1.0));
    RC_ASSERT(simple.triangles.size() <= mesh.triangles.size());
    RC_ASSERT(simple.triangles.empty() || is_closed(simple));
    for (const Vec3& v : simple.vertices) {
        RC_ASSERT(std::find(mesh.vertices.begin(), mesh.vertices.end(), v) != mesh.vertices.end());
    }
}

}  // namespace
}  // namespace spectralpack::test
