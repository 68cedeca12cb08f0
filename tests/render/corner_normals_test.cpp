#include "render/corner_normals.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace spectralpack {
namespace {

Vec3 normal_at(const std::vector<CornerNormals>& normals, std::size_t t, std::size_t k) {
    return {normals[t][k][0], normals[t][k][1], normals[t][k][2]};
}

Vec3 facet_normal(const Mesh& mesh, std::size_t t) {
    const Vec3 a = mesh.vertices[mesh.triangles[t][0]], b = mesh.vertices[mesh.triangles[t][1]],
               c = mesh.vertices[mesh.triangles[t][2]];
    const Vec3 normal = cross(b - a, c - a);
    return 1 / length(normal) * normal;
}

TEST(CornerNormals, StaySharpAtCreases) {
    const Mesh mesh = test::box_mesh({0, 0, 0}, {5, 7, 3});
    const auto normals = corner_normals(mesh);
    ASSERT_EQ(normals.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < normals.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LT(length(normal_at(normals, t, k) - facet_normal(mesh, t)), 1e-6);
        }
    }
}

TEST(CornerNormals, AreRadialOnASphere) {
    const Mesh mesh = test::sphere_mesh(3, 16);
    const auto normals = corner_normals(mesh);
    for (std::size_t t = 0; t < normals.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 radial = 1.0 / 3 * mesh.vertices[mesh.triangles[t][k]];
            EXPECT_LT(length(normal_at(normals, t, k) - radial), 0.02);
        }
    }
}

TEST(CornerNormals, TurnWithTheMesh) {
    const Mesh mesh = test::torus_mesh(5, 2, 24, 12);
    const auto inwards = corner_normals(test::turned_inside_out(mesh));
    const auto outwards = corner_normals(mesh);
    for (std::size_t t = 0; t < outwards.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t swapped = k == 0 ? 0 : 3 - k;
            EXPECT_LT(length(normal_at(outwards, t, k) + normal_at(inwards, t, swapped)), 1e-5);
        }
    }
}

TEST(CornerNormals, OfACrowdedVertexAreTheFacetsOwn) {
    Mesh cone;  // 400 facets round the tip
    cone.vertices.push_back({0, 0, 1});
    for (int i = 0; i < 400; ++i) {
        const double a = 2 * std::numbers::pi * i / 400;
        cone.vertices.push_back({std::cos(a), std::sin(a), 0});
    }
    for (std::uint32_t i = 0; i < 400; ++i) {
        cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % 400});
    }
    const auto normals = corner_normals(cone);
    for (std::size_t t = 0; t < normals.size(); ++t) {
        EXPECT_LT(length(normal_at(normals, t, 0) - facet_normal(cone, t)), 1e-6);
    }
}

TEST(CornerNormals, OfFlatTrianglesAreZeroAndSpoilNoOther) {
    Mesh mesh = test::cube_mesh(2);
    mesh.triangles.push_back({0, 1, 1});
    const auto normals = corner_normals(mesh);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(normal_at(normals, 12, k), Vec3{});
    }
    for (std::size_t t = 0; t < 12; ++t) {
        EXPECT_LT(length(normal_at(normals, t, 0) - facet_normal(mesh, t)), 1e-6);
    }
}

}  // namespace
}  // namespace spectralpack
