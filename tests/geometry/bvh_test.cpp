#include "geometry/bvh.hpp"

#include <gtest/gtest.h>

#include "core/stopped.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

TEST(Bvh, TakesNoMoreMemoryThanWasPlanned) {
    std::vector<Mesh> meshes{Mesh{}, test::cube_mesh(1), test::sphere_mesh(5)};
    for (int around = 3; around < 40; ++around) {
        meshes.push_back(test::torus_mesh(9, 2, around, 5));
    }
    for (const Mesh& mesh : meshes) {
        const Bvh tree(mesh);
        EXPECT_LE(tree.bytes(), Bvh::most_bytes(mesh)) << mesh.triangles.size();
        EXPECT_GE(2 * tree.bytes() + 200, Bvh::most_bytes(mesh)) << mesh.triangles.size();
    }
}

TEST(Bvh, IsGivenUpWhenStopped) {
    const Mesh mesh = test::torus_mesh(9, 2, 100, 60);
    StopSource stop;
    EXPECT_EQ(Bvh(mesh, false, stop.token()).triangle_count(), mesh.triangles.size());
    stop.request(StopReason::time_limit);
    EXPECT_THROW(Bvh(mesh, false, stop.token()), Stopped);
}

}  // namespace
}  // namespace spectralpack
