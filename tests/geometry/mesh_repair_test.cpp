/// What is repaired in a mesh, and what is left alone.

#include "geometry/mesh_repair.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "core/random.hpp"
#include "geometry/mesh_edges.hpp"
#include "support/names.hpp"
#include "support/remarks.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::any_names;
using test::box_mesh;
using test::cube_mesh;
using test::merged;
using test::turned_inside_out;

/// Every facet its own three vertices.
Mesh soup_of(const Mesh& mesh) {
    Mesh soup;
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t corner : t) {
            soup.vertices.push_back(mesh.vertices[corner]);
        }
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

TEST(MeshRepair, ASoundMeshIsLeftAlone) {
    for (const Mesh& sound : {cube_mesh(20), test::torus_mesh(30, 8), test::sphere_mesh(10)}) {
        Mesh mesh = sound;
        const MeshRepair outcome = repair_mesh(mesh);
        EXPECT_TRUE(outcome.repairs.empty());
        EXPECT_TRUE(outcome.warnings.empty());
        EXPECT_FALSE(outcome.unusable);
        EXPECT_TRUE(outcome.closed);
        EXPECT_EQ(outcome.box, bounding_box(sound));
        EXPECT_EQ(mesh.triangles.size(), sound.triangles.size());
        EXPECT_DOUBLE_EQ(signed_volume(mesh), signed_volume(sound));
    }
}

TEST(MeshRepair, EqualVerticesAreMergedAndUnusedOnesGo) {
    Mesh mesh = soup_of(cube_mesh(20));
    mesh.vertices.push_back({99, 99, 99});
    const MeshRepair outcome = repair_mesh(mesh);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_TRUE(outcome.closed);
    EXPECT_TRUE(any_names(outcome.repairs, {28, "vertices"}));
}

TEST(MeshRepair, AnInsideOutMeshIsTurnedAndItsCavityKept) {
    Mesh hollow = merged(cube_mesh(40), turned_inside_out(box_mesh({10, 10, 10}, {30, 30, 30})));
    const double volume = signed_volume(hollow);
    EXPECT_DOUBLE_EQ(volume, 64000 - 8000);
    Mesh turned = turned_inside_out(hollow);
    EXPECT_TRUE(any_names(repair_mesh(turned).repairs, {"inside out"}));
    EXPECT_DOUBLE_EQ(signed_volume(turned), volume);
    EXPECT_TRUE(repair_mesh(hollow).repairs.empty());
}

TEST(MeshRepair, ShellsApartAreJudgedByThemselves) {
    Mesh pair = merged(cube_mesh(20), turned_inside_out(box_mesh({30, 0, 0}, {50, 20, 20})));
    const MeshRepair outcome = repair_mesh(pair);  // as a whole its volume is zero
    EXPECT_FALSE(outcome.unusable);
    EXPECT_TRUE(any_names(outcome.repairs, {12, "facets"}));
    EXPECT_DOUBLE_EQ(signed_volume(pair), 16000);
}

TEST(MeshRepair, FacetsTurnedTheWrongWayAreTurnedBack) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh = test::torus_mesh(30, 8, 12, 8);
        const double volume = signed_volume(mesh);
        for (Triangle& t : mesh.triangles) {
            if (random.below(3) == 0) std::swap(t[1], t[2]);
        }
        const MeshRepair outcome = repair_mesh(mesh);
        RC_ASSERT(outcome.closed);
        RC_ASSERT(std::abs(signed_volume(mesh) - volume) < 1e-9 * volume);
    }));
}

TEST(MeshRepair, ZeroAreaAndRepeatedFacetsAreDropped) {
    Mesh mesh = cube_mesh(20);
    mesh.triangles.push_back(mesh.triangles[3]);
    mesh.triangles.push_back({mesh.triangles[5][1], mesh.triangles[5][2], mesh.triangles[5][0]});
    mesh.triangles.push_back({0, 1, 0});
    mesh.triangles.push_back({2, 2, 2});
    const MeshRepair outcome = repair_mesh(mesh);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_TRUE(outcome.closed);
    EXPECT_TRUE(any_names(outcome.repairs, {2, "facets", "area"}));
    EXPECT_TRUE(any_names(outcome.repairs, {2, "facets", "twice"}));
}

TEST(MeshRepair, ASliverThatJoinsItsNeighboursStays) {
    // The edge 0-1 of a cube's facet is split at its middle on one side only; a flat facet closes
    // the slit.
    Mesh mesh = cube_mesh(20);
    mesh.vertices.push_back({10, 0, 0});
    auto& triangles = mesh.triangles;
    const auto split = std::find(triangles.begin(), triangles.end(), Triangle{0, 1, 4});
    ASSERT_NE(split, triangles.end());
    *split = {0, 8, 4};
    triangles.push_back({8, 1, 4});
    triangles.push_back({0, 1, 8});
    ASSERT_TRUE(is_closed(mesh));
    EXPECT_TRUE(repair_mesh(mesh).closed);
    EXPECT_EQ(mesh.triangles.size(), 14u);
}

TEST(MeshRepair, TwoSolidsThatShareAWallKeepIt) {
    // Same facets, same way round: the floor of both. Dropping one would open the mesh.
    Mesh nested = merged(cube_mesh(20), cube_mesh(20));
    for (std::uint32_t i = 8; i < 16; ++i) {
        if (nested.vertices[i].z > 0) nested.vertices[i].z = 5;
    }
    const MeshRepair outcome = repair_mesh(nested);
    EXPECT_TRUE(outcome.closed);
    EXPECT_DOUBLE_EQ(signed_volume(nested), 8000 + 2000);
    EXPECT_TRUE(any_names(test::texts_of(outcome.warnings), {"edge"}));
}

TEST(MeshRepair, CracksAreClosedButHolesAreNot) {
    Mesh cracked = soup_of(cube_mesh(20));
    for (std::size_t i = 0; i < cracked.vertices.size(); ++i) {
        cracked.vertices[i].x += 1e-5 * static_cast<double>(i % 3);
    }
    const MeshRepair closed = repair_mesh(cracked);
    EXPECT_TRUE(closed.closed);
    EXPECT_EQ(cracked.vertices.size(), 8u);
    EXPECT_TRUE(any_names(closed.repairs, {"border", "vertices"}));

    Mesh open = cube_mesh(20);
    open.triangles.pop_back();
    const MeshRepair outcome = repair_mesh(open);
    EXPECT_FALSE(outcome.closed);
    EXPECT_FALSE(outcome.unusable);
    EXPECT_TRUE(any_names(test::texts_of(outcome.warnings), {3, "edges"}));
    EXPECT_EQ(open.triangles.size(), 11u);
}

TEST(MeshRepair, AnyMeshIsTakenAndRepairedTwiceIsRepairedOnce) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        const auto vertices = 4 + random.below(20);
        for (std::uint64_t i = 0; i < vertices; ++i) {
            const auto coordinate = [&] {
                const double crack = random.below(4) == 0 ? 1e-6 * random.unit() : 0;
                return static_cast<double>(random.below(4)) + crack;
            };
            mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
        }
        for (std::uint64_t i = 0; i < random.below(60); ++i) {
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices))});
        }
        const bool was_closed = is_closed(mesh);
        const MeshRepair first = repair_mesh(mesh);
        if (first.unusable) return;
        RC_ASSERT(first.closed == is_closed(mesh));
        RC_ASSERT(first.closed || !was_closed);
        RC_ASSERT(first.closed || !first.warnings.empty());
        RC_ASSERT(first.box == bounding_box(mesh));
        RC_ASSERT(signed_volume(mesh) >= 0);
        if (any_names(first.repairs, {"border", "vert"})) return;  // its result may have cracks of its own
        const Mesh once = mesh;
        const MeshRepair second = repair_mesh(mesh);
        RC_ASSERT(!second.unusable);
        RC_ASSERT(second.repairs.empty());
        RC_ASSERT(soup_of(mesh).vertices == soup_of(once).vertices);
        RC_ASSERT(mesh.vertices.size() == once.vertices.size());
    }));
}

}  // namespace
}  // namespace spectralpack
