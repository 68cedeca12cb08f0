#include "render/ray_scene.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "scenes.hpp"

namespace spectralpack {
namespace {

using test::SmallScene;

struct Met {
    int copy = -1;
    double at = std::numeric_limits<double>::infinity();
    double edge = 1;  ///< how far inside its triangle, in barycentric coordinates
    Vec3 normal;
};

/// First triangle of any copy along the ray, in doubles, each tested (Moeller and Trumbore).
Met brute_force(const Stage& stage, const Vec3& origin, const Vec3& direction) {
    Met met;
    for (std::size_t i = 0; i < stage.copies.size(); ++i) {
        const StagedCopy& copy = stage.copies[i];
        const Mesh& mesh = *stage.meshes[static_cast<std::size_t>(copy.mesh)];
        for (const Triangle& t : mesh.triangles) {
            const Vec3 a = copy.pose * mesh.vertices[t[0]], ab = copy.pose * mesh.vertices[t[1]] - a,
                       ac = copy.pose * mesh.vertices[t[2]] - a;
            const Vec3 p = cross(direction, ac);
            const double d = dot(ab, p);
            if (d == 0) continue;
            const Vec3 s = origin - a, q = cross(s, ab);
            const double u = dot(s, p) / d, v = dot(direction, q) / d, at = dot(ac, q) / d;
            if (u < 0 || v < 0 || u + v > 1 || at <= 0 || at >= met.at) continue;
            const Vec3 normal = cross(ab, ac);
            met = {static_cast<int>(i), at, std::min({u, v, 1 - u - v}), 1 / length(normal) * normal};
        }
    }
    return met;
}

void expect_brute_force(const SmallScene& scene) {
    RenderOptions options = test::small_picture(80, 60);
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    const test::StageRays held(stage);
    const RayScene& rays = held.rays;
    int hits = 0;
    for (int y = 0; y < options.height; ++y) {
        for (int x = 0; x < options.width; ++x) {
            const Vec3 ray = stage.camera.ray(x + 0.4, y + 0.7);
            const Met expected = brute_force(stage, stage.camera.eye, ray);
            // Single precision may decide either way at a triangle's edge.
            if (expected.copy >= 0 && expected.edge < 1e-3) continue;
            const RayHit hit = rays.first(stage.camera.eye, ray);
            ASSERT_EQ(hit.copy, expected.copy) << x << "," << y;
            EXPECT_EQ(rays.blocked(stage.camera.eye, ray, 1e3), expected.copy >= 0);
            if (hit.copy < 0) continue;
            ++hits;
            EXPECT_NEAR(hit.at, expected.at, 1e-4);
            EXPECT_FALSE(rays.blocked(stage.camera.eye, ray, hit.at - 1e-3));
            EXPECT_NEAR(length(hit.smooth), 1, 1e-6);
            EXPECT_LE(dot(hit.face, ray), 0);
            const double side = dot(expected.normal, ray) > 0 ? -1 : 1;
            EXPECT_LT(length(hit.face - side * expected.normal), 1e-3);
            EXPECT_GT(dot(hit.face, hit.smooth), 0.8);
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(RayScene, FindsWhatBruteForceFinds) { expect_brute_force(test::varied_scene()); }

TEST(RayScene, FindsItInMeshesFarFromTheirOrigin) {
    SmallScene scene = test::varied_scene();
    const Vec3 away{1e7, -3e6, 2e6};
    for (auto& mesh : scene.meshes) {
        mesh = std::make_shared<const Mesh>(transformed(*mesh, {Mat3{}, away}));
    }
    for (Placement& placement : scene.packing.trays[0].placements) {
        placement.transform = placement.transform * Transform{Mat3{}, -away};
    }
    expect_brute_force(scene);
}

TEST(RayScene, HoldsNothingWithoutCopies) {
    const SmallScene scene = test::empty_scene();
    const test::StageRays held(set_stage(scene.packing, scene.meshes, {}));
    const RayScene& rays = held.rays;
    EXPECT_EQ(rays.first({0, 0, 5}, {0, 0, -1}).copy, -1);
    EXPECT_FALSE(rays.blocked({0, 0, 5}, {0, 0, -1}, 1e3));
}

}  // namespace
}  // namespace spectralpack
