#include "model/physical_surfaces.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

/// The unit normals that facets of the mesh have, each once.
std::vector<Vec3> normals_of(const Mesh& mesh) {
    std::vector<Vec3> normals;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3 n = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
        const Vec3 unit = 1 / length(n) * n;
        if (std::find(normals.begin(), normals.end(), unit) == normals.end()) normals.push_back(unit);
    }
    return normals;
}

Container filled(const Mesh& mesh) {
    return {bounding_box(mesh).max, StandingMesh{"c.stl", {}, std::make_shared<const Mesh>(mesh)}, {}, true};
}

TEST(PhysicalSurfaces, ABoxIsAFloorAndFourSidesThatFaceTheRoom) {
    const Container box{{30, 20, 10}, {}, {}, true};
    EXPECT_TRUE(opens_at_top(box));
    const std::vector<Mesh> surfaces = physical_surfaces(box);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(surfaces[0].triangles.size(), 10u);
    for (const Vec3& normal : normals_of(surfaces[0])) {
        EXPECT_NE(normal, (Vec3{0, 0, -1})) << "there is no lid";
    }
    // Every facet looks at the middle.
    for (const Triangle& t : surfaces[0].triangles) {
        const Vec3& a = surfaces[0].vertices[t[0]];
        const Vec3 n = cross(surfaces[0].vertices[t[1]] - a, surfaces[0].vertices[t[2]] - a);
        EXPECT_GT(dot(n, Vec3{15, 10, 5} - a), 0);
    }
}

TEST(PhysicalSurfaces, AMeshIsOpenWhereItIsFlatAtItsTop) {
    const Mesh stepped = merged(box_mesh({0, 0, 0}, {20, 20, 10}), box_mesh({5, 5, 10}, {15, 15, 20}));
    const std::vector<Mesh> surfaces = physical_surfaces(filled(stepped));
    EXPECT_TRUE(opens_at_top(filled(stepped)));
    EXPECT_EQ(surfaces[0].triangles.size(), stepped.triangles.size() - 2) << "the shoulder stays";
    EXPECT_FALSE(opens_at_top(filled(transformed(sphere_mesh(10), {Mat3{}, {10, 10, 10}}))));
}

TEST(PhysicalSurfaces, KeepOutsStandAsTheyAre) {
    Container box{{30, 20, 10}, {}, {}, true};
    box.keep_out = {{Box{{1, 2, 3}, {4, 5, 6}}},
                    {{}, StandingMesh{"k.stl", {}, std::make_shared<const Mesh>(cube_mesh(3))}}};
    const std::vector<Mesh> surfaces = physical_surfaces(box);
    ASSERT_EQ(surfaces.size(), 3u);
    EXPECT_EQ(signed_volume(surfaces[1]), 27);
    EXPECT_EQ(signed_volume(surfaces[2]), 27);
}

}  // namespace
}  // namespace spectralpack::test
