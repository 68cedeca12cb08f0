#include "render/stage.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "scenes.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

using test::SmallScene;

Stage staged(const SmallScene& scene, const RenderOptions& options = test::small_picture()) {
    return set_stage(scene.packing, scene.meshes, {options});
}

SmallScene trays(int count) {
    SmallScene scene = test::empty_scene({40, 30, 20});
    const int part = scene.add_part(test::cube_mesh(5));
    for (int i = 0; i < count; ++i) {
        scene.place(part, {Mat3{}, {1, 2, 3}}, i, static_cast<std::size_t>(i));
    }
    return scene;
}

TEST(Stage, FitsTheUnitSphere) {
    for (const double size : {1e-9, 1.0, 1e12}) {
        SmallScene scene = test::empty_scene({4 * size, 3 * size, 2 * size});
        const Stage stage = staged(scene);
        ASSERT_EQ(stage.containers.size(), 1u);
        EXPECT_NEAR(length(stage.containers[0].min), 1, 1e-12);
        EXPECT_NEAR(length(stage.containers[0].max), 1, 1e-12);
        EXPECT_NEAR(stage.floor, stage.containers[0].min.z, 1e-12);
    }
}

TEST(Stage, HoldsAMeshOnceHoweverManyPartsAndCopiesUseIt) {
    SmallScene scene = trays(3);
    const int twin = scene.add_part({});
    scene.meshes[static_cast<std::size_t>(twin)] = scene.meshes[0];
    scene.place(twin, {Mat3{}, {9, 9, 9}});
    const Stage stage = staged(scene);
    EXPECT_EQ(stage.meshes.size(), 1u);
    EXPECT_EQ(stage.copies.size(), 4u);
}

TEST(Stage, SetsTraysApartAndEachWithItsCopies) {
    for (const int count : {2, 3, 7, 20}) {
        for (const double azimuth : {0.0, 35.0, 200.0}) {
            RenderOptions options = test::small_picture();
            options.azimuth = azimuth;
            const Stage stage = staged(trays(count), options);
            ASSERT_EQ(static_cast<int>(stage.containers.size()), count);
            for (std::size_t i = 0; i < stage.containers.size(); ++i) {
                const Box& box = stage.containers[i];
                const Vec3 corner = stage.copies[i].pose * Vec3{};
                EXPECT_LT(distance(box, {corner, corner}), 1e-12);
                EXPECT_LE(length(box.min), 1 + 1e-9);
                for (std::size_t k = 0; k < i; ++k) {
                    EXPECT_GT(distance(box, stage.containers[k]), 0.0);
                }
            }
        }
    }
}

TEST(Stage, ShowsOneTrayAsIfItWereAlone) {
    const SmallScene three = trays(3), one = trays(1);
    RenderOptions second = test::small_picture();
    second.tray = 1;
    const Stage picked = staged(three, second), alone = staged(one);
    EXPECT_EQ(picked.containers, alone.containers);
    EXPECT_EQ(picked.camera.eye, alone.camera.eye);
    ASSERT_EQ(picked.copies.size(), 1u);
    EXPECT_EQ(picked.copies[0].pose, alone.copies[0].pose);
}

TEST(Stage, RefusesATrayThatIsNotThere) {
    for (const int tray : {-2, 3, 1000}) {
        RenderOptions options;
        options.tray = tray;
        EXPECT_THROW(staged(trays(3), options), UsageError) << tray;
    }
    RenderOptions first;
    first.tray = 0;
    EXPECT_EQ(staged(test::empty_scene(), first).containers.size(), 1u);
}

TEST(Stage, RefusesAPartWithoutMesh) {
    SmallScene scene = trays(1);
    scene.meshes[0] = nullptr;
    EXPECT_THROW(staged(scene), UsageError);
    scene.meshes.clear();
    EXPECT_THROW(staged(scene), UsageError);
}

TEST(Stage, RefusesAContainerWithoutSize) {
    EXPECT_THROW(staged(test::empty_scene({0, 0, 0})), UsageError);
    EXPECT_THROW(staged(test::empty_scene({std::numeric_limits<double>::quiet_NaN(), 1, 1})), UsageError);
}

TEST(Stage, LeavesOutCopiesThatAreFlattened) {
    SmallScene scene = trays(1);
    scene.place(0, {0 * Mat3{}, {1, 1, 1}}, 7);
    scene.place(0, {std::numeric_limits<double>::infinity() * Mat3{}, {1, 1, 1}}, 8);
    EXPECT_EQ(staged(scene).copies.size(), 1u);
}

TEST(Stage, ShowsCopiesThatStickOut) {
    SmallScene scene = trays(1);
    scene.place(0, {Mat3{}, {60, -20, -9}}, 1);
    const Stage stage = staged(scene);
    for (const StagedCopy& copy : stage.copies) {
        for (const Vec3& vertex : scene.meshes[0]->vertices) {
            const PicturePoint seen = stage.camera.project(copy.pose * vertex);
            EXPECT_GT(seen.x, 0);
            EXPECT_LT(seen.x, stage.camera.width);
            EXPECT_GT(seen.y, 0);
            EXPECT_LT(seen.y, stage.camera.height);
            EXPECT_GE((copy.pose * vertex).z, stage.floor - 1e-12);
        }
    }
}

}  // namespace
}  // namespace spectralpack
