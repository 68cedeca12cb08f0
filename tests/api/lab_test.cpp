/// The laboratory level against the definition.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <spectralpack/error.hpp>
#include <spectralpack/lab/distance.hpp>
#include <spectralpack/lab/search.hpp>
#include <spectralpack/lab/voxels.hpp>

#include <cmath>
#include <tuple>

#include "support/shapes.hpp"

namespace spectralpack::lab {
namespace {

std::int64_t sum(const Grid<std::uint8_t>& grid) {
    std::int64_t total = 0;
    for (const std::uint8_t voxel : grid.values()) {
        total += voxel;
    }
    return total;
}

TEST(LabVoxels, ABoxOnTheGridIsItsVoxels) {
    const Voxels voxels = voxelize(test::box_mesh({3, 4, 5}, {13, 10, 9}), 2);
    EXPECT_EQ(voxels.solid.extent(), (Extent{5, 3, 2}));
    EXPECT_EQ(sum(voxels.solid), 30);
    EXPECT_EQ(voxels.corner, (Vec3{3, 4, 5}));
}

TEST(LabVoxels, BitsAreTheBytes) {
    const Mesh mesh = test::torus_mesh(40, 6);
    const Voxels bytes = voxelize(mesh, 1);
    const VoxelBits bits = voxelize_bits(mesh, 1);
    ASSERT_EQ(bits.extent, bytes.solid.extent());
    EXPECT_GT(bits.words_per_row, 1);
    for (int z = 0; z < bits.extent.z; ++z) {
        for (int y = 0; y < bits.extent.y; ++y) {
            for (int x = 0; x < bits.extent.x; ++x) {
                ASSERT_EQ(bits.at(x, y, z), bytes.solid.at(x, y, z) == 1) << x << ' ' << y << ' ' << z;
            }
        }
    }
}

TEST(LabVoxels, RefuseWhatMakesNoSense) {
    EXPECT_THROW(voxelize(test::cube_mesh(5), 0), UsageError);
    EXPECT_THROW(voxelize(Mesh{}, 1), InputError);
}

TEST(LabTray, WhatIsTakenOutLeavesNothing) {
    Tray tray({.size = {20, 20, 20}, .voxel_size = 1});
    const Shape shape = tray.shape(test::cube_mesh(5), orientation_set("none"));
    const CopyId first = tray.add(shape, 0, {0, 0, 0});
    tray.add(shape, 0, {3, 3, 3});
    EXPECT_EQ(sum(tray.occupied()), 2 * 125 - 8);
    tray.remove(first);
    EXPECT_EQ(sum(tray.occupied()), 125);
    EXPECT_THROW(tray.remove(first), UsageError);
}

TEST(LabTray, EqualOrientationsAreOne) {
    const Tray tray({.size = {20, 20, 20}, .voxel_size = 1});
    EXPECT_EQ(tray.shape(test::cube_mesh(5), orientation_set("90")).orientations(), std::vector<int>{0});
    EXPECT_EQ(tray.shape(test::bracket(), orientation_set("90")).orientations().size(), 24u);
}

TEST(LabTray, RefusesShapesOfOtherTrays) {
    Tray coarse({.size = {20, 20, 20}, .voxel_size = 2}), fine({.size = {20, 20, 20}, .voxel_size = 1});
    const Shape shape = fine.shape(test::cube_mesh(5), orientation_set("none"));
    EXPECT_THROW(coarse.best_placement(shape), UsageError);
    EXPECT_THROW(coarse.best_placement(Shape()), UsageError);
    EXPECT_THROW(fine.shape(test::cube_mesh(5), orientation_set("none"), 0.5), UsageError);
    EXPECT_THROW(fine.add(shape, 7, {0, 0, 0}), UsageError);
}

#ifdef SPECTRALPACK_HAS_REFERENCE
/// best_placement() is the least (cost, orientation, z, y, x) where zeta is 0, by the whole fields.
RC_GTEST_PROP(LabTray, TheBestPlacementIsTheLeastOfTheFields, ()) {
    const auto side = [] { return static_cast<double>(*rc::gen::inRange(3, 7)); };
    Tray tray({.size = {16, 13, 11}, .voxel_size = 1, .gaps = {0, 1}});
    const Shape bracket = tray.shape(test::bracket(), orientation_set("90"), 1);
    const Shape box = tray.shape(test::box_mesh({0, 0, 0}, {side(), side(), side()}), orientation_set("90"));
    const CostOptions cost{.height_penalty = static_cast<double>(*rc::gen::inRange(0, 1000))};
    for (int copy = 0; copy < 4; ++copy) {
        const Shape& shape = *rc::gen::arbitrary<bool>() ? bracket : box;
        using Key = std::tuple<double, int, int, int, int>;
        std::optional<Key> least;
        for (const int orientation : shape.orientations()) {
            const MetricFields fields = tray.metric_fields(shape, orientation);
            const Extent& n = fields.collision.extent();
            for (int z = 0; z < n.z; ++z) {
                for (int y = 0; y < n.y; ++y) {
                    for (int x = 0; x < n.x; ++x) {
                        if (fields.collision.at(x, y, z) > 0) continue;
                        const double t = static_cast<double>(z) / tray.extent().z;
                        const double sigma =
                            static_cast<double>(fields.proximity.at(x, y, z)) + cost.height_penalty * t * t * t;
                        const Key key{sigma, orientation, z, y, x};
                        if (!least || key < *least) least = key;
                    }
                }
            }
        }
        const auto best = tray.best_placement(shape, cost);
        RC_ASSERT(best.has_value() == least.has_value());
        if (!best) return;
        RC_ASSERT((Key{best->cost, best->orientation, best->position.z, best->position.y, best->position.x}) == *least);
        tray.add(shape, *best);
    }
}
#endif

TEST(LabTray, TheTransformPutsTheMeshThere) {
    Tray tray({.size = {30, 30, 30}, .voxel_size = 1});
    const Mesh mesh = test::box_mesh({100, 100, 100}, {110, 104, 102});
    const Shape shape = tray.shape(mesh, orientation_set("90"));
    const auto best = tray.best_placement(shape);
    ASSERT_TRUE(best);
    const Box box = bounding_box(transformed(mesh, best->transform));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], best->position[axis], 1e-9);
    }
}

TEST(LabDistance, IsExact) {
    const Mesh a = test::cube_mesh(10), b = test::cube_mesh(4);
    const Distance apart = distance(a, {}, b, {Mat3{}, {13, 14, 3}});
    EXPECT_NEAR(apart.value, 5, 1e-12);
    EXPECT_NEAR(length(apart.point_a - apart.point_b), 5, 1e-12);
    EXPECT_EQ(distance(a, {}, b, {Mat3{}, {10, 0, 0}}).value, 0);
    EXPECT_NEAR(distance(a, {}, b, {Mat3{}, {3, 3, 3}}).value, 3, 1e-12);  // inside: surfaces
    EXPECT_THROW(distance(a, {}, Mesh{}, {}), InputError);
}

}  // namespace
}  // namespace spectralpack::lab
