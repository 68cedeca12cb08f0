#include "geometry/mesh_repair.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>

#include "core/random.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/mesh_weld.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using test::box_mesh;
using test::cube_mesh;
using test::merged;
using test::turned_inside_out;

bool says(const std::vector<std::string>& texts, const std::string& part) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

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
    EXPECT_TRUE(says(outcome.repairs, "28 vertices"));
}

TEST(MeshRepair, WeldingIsWhatComparingAllPairsGives) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        const auto vertices = 1 + random.below(300);
        for (std::uint64_t i = 0; i < vertices; ++i) {  // few distinct values, so that many coincide
            const auto coordinate = [&] { return static_cast<double>(random.below(5)) - 2; };
            mesh.vertices.push_back({coordinate() * 0.5, coordinate() * 0.0, coordinate() * 1e-300});
        }
        for (int i = 0; i < 200; ++i) {
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices)),
                                      static_cast<std::uint32_t>(random.below(vertices))});
        }
        const Mesh before = mesh;
        weld_equal_vertices(mesh);
        std::vector<Vec3> distinct;  // used ones, in order
        for (std::uint32_t i = 0; i < vertices; ++i) {
            const bool used = std::any_of(before.triangles.begin(), before.triangles.end(), [&](const Triangle& t) {
                return std::find(t.begin(), t.end(), i) != t.end();
            });
            const Vec3& point = before.vertices[i];
            if (used && std::find(distinct.begin(), distinct.end(), point) == distinct.end()) {
                distinct.push_back(point);
            }
        }
        RC_ASSERT(mesh.vertices == distinct);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                RC_ASSERT(mesh.vertices[mesh.triangles[i][k]] == before.vertices[before.triangles[i][k]]);
            }
        }
    }));
}

TEST(MeshRepair, EdgesAreCountedAsBruteForceCountsThem) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        mesh.vertices.resize(40);
        for (std::uint64_t i = 0; i < 1 + seed % 120; ++i) {  // vertex 0 is of high degree
            mesh.triangles.push_back({static_cast<std::uint32_t>(random.below(2) * random.below(40)),
                                      static_cast<std::uint32_t>(random.below(40)),
                                      static_cast<std::uint32_t>(random.below(40))});
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                if (a < b) ++uses[{a, b}].first;
                if (b < a) ++uses[{b, a}].second;
            }
        }
        EdgeCount expected;
        expected.closed = !uses.empty();
        for (const auto& [edge, count] : uses) {
            const auto [forward, backward] = count;
            expected.border += (forward + backward) % 2 == 1;
            expected.misdirected += forward + backward == 2 && forward != 1;
            expected.crowded += forward + backward > 2;
            expected.closed = expected.closed && forward == backward;
        }
        const EdgeCount count = count_edges(MeshEdges(mesh));
        RC_ASSERT(count.border == expected.border);
        RC_ASSERT(count.misdirected == expected.misdirected);
        RC_ASSERT(count.crowded == expected.crowded);
        RC_ASSERT(count.closed == expected.closed);
        RC_ASSERT(is_closed(mesh) == expected.closed);
    }));
}

TEST(MeshRepair, AnInsideOutMeshIsTurnedAndItsCavityKept) {
    Mesh hollow = merged(cube_mesh(40), turned_inside_out(box_mesh({10, 10, 10}, {30, 30, 30})));
    const double volume = signed_volume(hollow);
    EXPECT_DOUBLE_EQ(volume, 64000 - 8000);
    Mesh turned = turned_inside_out(hollow);
    EXPECT_TRUE(says(repair_mesh(turned).repairs, "inside out"));
    EXPECT_DOUBLE_EQ(signed_volume(turned), volume);
    EXPECT_TRUE(repair_mesh(hollow).repairs.empty());
}

TEST(MeshRepair, ShellsApartAreJudgedByThemselves) {
    Mesh pair = merged(cube_mesh(20), turned_inside_out(box_mesh({30, 0, 0}, {50, 20, 20})));
    const MeshRepair outcome = repair_mesh(pair);  // as a whole its volume is zero
    EXPECT_FALSE(outcome.unusable);
    EXPECT_TRUE(says(outcome.repairs, "12 facets"));
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
    EXPECT_TRUE(says(outcome.repairs, "2 facets of zero area"));
    EXPECT_TRUE(says(outcome.repairs, "2 facets stored twice"));
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
    EXPECT_TRUE(says(outcome.warnings, "more than two facets"));
}

TEST(MeshRepair, CracksAreClosedButHolesAreNot) {
    Mesh cracked = soup_of(cube_mesh(20));
    for (std::size_t i = 0; i < cracked.vertices.size(); ++i) {
        cracked.vertices[i].x += 1e-5 * static_cast<double>(i % 3);
    }
    const MeshRepair closed = repair_mesh(cracked);
    EXPECT_TRUE(closed.closed);
    EXPECT_EQ(cracked.vertices.size(), 8u);
    EXPECT_TRUE(says(closed.repairs, "border vertices"));

    Mesh open = cube_mesh(20);
    open.triangles.pop_back();
    const MeshRepair outcome = repair_mesh(open);
    EXPECT_FALSE(outcome.closed);
    EXPECT_FALSE(outcome.unusable);
    EXPECT_TRUE(says(outcome.warnings, "is not closed: 3 border edges; packed by its surface"));
    EXPECT_EQ(open.triangles.size(), 11u);
}

TEST(MeshRepair, WeldingWithinAToleranceKeepsWhatIsFurtherApart) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        RandomStream random(seed);
        Mesh mesh;
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < 120; ++i) {
            const auto coordinate = [&] { return static_cast<double>(random.below(4)) + 1e-3 * random.unit() - 1.5; };
            mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
            all.push_back(i);
        }
        for (std::uint32_t i = 0; i < 120; i += 3) {
            mesh.triangles.push_back({i, i + 1, i + 2});
        }
        const Mesh before = mesh;
        const double tolerance = 2e-3;  // above a cluster's diameter, far below the clusters' distance
        weld_near_vertices(mesh, all, tolerance);
        std::vector<std::uint32_t> target(120);
        for (std::size_t i = 0; i < 120; ++i) {
            target[i] = mesh.triangles[i / 3][i % 3];
        }
        for (std::size_t i = 0; i < 120; ++i) {
            for (std::size_t j = 0; j < 120; ++j) {
                const bool near = length(before.vertices[i] - before.vertices[j]) <= tolerance;
                RC_ASSERT((target[i] == target[j]) == near);
            }
        }
    }));
}

TEST(MeshRepair, WhatEnclosesNothingIsUnusable) {
    const auto why = [](Mesh mesh) { return repair_mesh(mesh).unusable.value_or(""); };
    EXPECT_NE(why({}).find("no triangles"), std::string::npos);
    EXPECT_NE(why({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), "");
    EXPECT_NE(why({{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}}}).find("flat"), std::string::npos);
    EXPECT_NE(why({{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}, {1, 1, 3}}, {{0, 1, 2}, {1, 3, 2}}}).find("plane"),
              std::string::npos);
    Mesh back_to_back{{{0, 0, 0}, {9, 0, 1}, {0, 9, 2}, {5, 5, 9}}, {{0, 1, 2}, {0, 2, 1}, {1, 3, 2}, {1, 2, 3}}};
    EXPECT_NE(why(back_to_back).find("volume is zero"), std::string::npos);
    EXPECT_NE(why(box_mesh({0, 0, 0}, {1e31, 1, 1})).find("beyond"), std::string::npos);
    EXPECT_NE(why(box_mesh({1e12, 0, 0}, {1e12, 20, 20})).find("precision"), std::string::npos);
    EXPECT_EQ(why(box_mesh({0, 0, 0}, {1e-6, 1e-6, 1e-6})), "");
    EXPECT_EQ(why(box_mesh({0, 0, 0}, {100, 100, 0.01})), "");
}

TEST(MeshRepair, OverlappingShellsAreToldButNotCavitiesNorIslands) {
    const auto warned = [](Mesh mesh) { return says(repair_mesh(mesh).warnings, "overlap"); };
    EXPECT_TRUE(warned(merged(cube_mesh(20), box_mesh({10, 10, 10}, {30, 30, 30}))));
    EXPECT_TRUE(warned(merged(cube_mesh(20), box_mesh({5, 5, 5}, {10, 10, 10}))));
    const Mesh hollow = merged(cube_mesh(40), turned_inside_out(box_mesh({10, 10, 10}, {30, 30, 30})));
    EXPECT_FALSE(warned(hollow));
    EXPECT_FALSE(warned(merged(hollow, box_mesh({15, 15, 15}, {25, 25, 25}))));
    EXPECT_FALSE(warned(merged(cube_mesh(20), box_mesh({20, 0, 0}, {40, 20, 20}))));  // they touch
    EXPECT_FALSE(warned(merged(test::torus_mesh(30, 3), box_mesh({-5, -5, -5}, {5, 5, 5}))));
}

TEST(MeshRepair, ImplausibleSizesAreHintedAt) {
    EXPECT_TRUE(size_warning({{0, 0, 0}, {2, 1.5, 0.5}}, 1));
    EXPECT_FALSE(size_warning({{0, 0, 0}, {2, 1.5, 0.5}}, 25.4));
    EXPECT_TRUE(size_warning({{0, 0, 0}, {2, 1.5, 20000}}, 1));
    EXPECT_FALSE(size_warning({{5, 5, 5}, {20, 20, 20}}, 1));
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
        if (says(first.repairs, "border vert")) return;  // its result may have cracks of its own
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
