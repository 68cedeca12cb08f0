/// Meshes that cannot be packed, and those that are taken with a warning.

#include <gtest/gtest.h>

#include "geometry/mesh_repair.hpp"
#include "support/names.hpp"
#include "support/remarks.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::any_names;
using test::box_mesh;
using test::cube_mesh;
using test::merged;
using test::names;
using test::turned_inside_out;

TEST(MeshVerdict, WhatEnclosesNothingIsUnusable) {
    const auto why = [](Mesh mesh) { return repair_mesh(mesh).unusable.value_or(""); };
    EXPECT_TRUE(names(why({}), {"triangles"}));
    EXPECT_NE(why({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), "");
    EXPECT_TRUE(names(why({{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}}}), {"flat"}));
    EXPECT_TRUE(names(why({{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}, {1, 1, 3}}, {{0, 1, 2}, {1, 3, 2}}}), {"plane"}));
    Mesh back_to_back{{{0, 0, 0}, {9, 0, 1}, {0, 9, 2}, {5, 5, 9}}, {{0, 1, 2}, {0, 2, 1}, {1, 3, 2}, {1, 2, 3}}};
    EXPECT_TRUE(names(why(back_to_back), {"volume"}));
    EXPECT_TRUE(names(why(box_mesh({0, 0, 0}, {1e31, 1, 1})), {1e31}));
    EXPECT_TRUE(names(why(box_mesh({1e12, 0, 0}, {1e12, 20, 20})), {"precision"}));
    EXPECT_EQ(why(box_mesh({0, 0, 0}, {1e-6, 1e-6, 1e-6})), "");
    EXPECT_EQ(why(box_mesh({0, 0, 0}, {100, 100, 0.01})), "");
}

TEST(MeshVerdict, OverlappingShellsAreToldButNotCavitiesNorIslands) {
    const auto warned = [](Mesh mesh) {
        return bool(any_names(test::texts_of(repair_mesh(mesh).warnings), {"overlap"}));
    };
    EXPECT_TRUE(warned(merged(cube_mesh(20), box_mesh({10, 10, 10}, {30, 30, 30}))));
    EXPECT_TRUE(warned(merged(cube_mesh(20), box_mesh({5, 5, 5}, {10, 10, 10}))));
    const Mesh hollow = merged(cube_mesh(40), turned_inside_out(box_mesh({10, 10, 10}, {30, 30, 30})));
    EXPECT_FALSE(warned(hollow));
    EXPECT_FALSE(warned(merged(hollow, box_mesh({15, 15, 15}, {25, 25, 25}))));
    EXPECT_FALSE(warned(merged(cube_mesh(20), box_mesh({20, 0, 0}, {40, 20, 20}))));  // they touch
    EXPECT_FALSE(warned(merged(test::torus_mesh(30, 3), box_mesh({-5, -5, -5}, {5, 5, 5}))));
}

TEST(MeshVerdict, ImplausibleSizesAreHintedAt) {
    EXPECT_TRUE(size_warning({{0, 0, 0}, {2, 1.5, 0.5}}, 1));
    EXPECT_FALSE(size_warning({{0, 0, 0}, {2, 1.5, 0.5}}, 25.4));
    EXPECT_TRUE(size_warning({{0, 0, 0}, {2, 1.5, 20000}}, 1));
    EXPECT_FALSE(size_warning({{5, 5, 5}, {20, 20, 20}}, 1));
}

}  // namespace
}  // namespace spectralpack
