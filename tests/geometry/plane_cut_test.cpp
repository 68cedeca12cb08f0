/// Cutting by planes: both sides are closed, sound, on their side, and together the whole.

#include "geometry/plane_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "geometry/loop_triangles.hpp"
#include "geometry/mesh_bodies.hpp"
#include "geometry/mesh_edges.hpp"
#include "spectralpack/mesh_figures.hpp"
#include "support/shapes.hpp"

namespace spectralpack::test {
namespace {

Vec3 unit(const Vec3& v) { return (1 / length(v)) * v; }

Vec3 random_direction(RandomStream& random) {
    for (;;) {
        const Vec3 v{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
        if (dot(v, v) > 0.01 && dot(v, v) < 1) return unit(v);
    }
}

/// A plate of 60 x 40 x 5 mm with round and square holes through it.
Mesh plate_with_holes(int columns, int rows) {
    std::vector<PlanePoint> points;
    std::vector<Loop> loops(1);
    const auto add = [&](Loop& loop, double x, double y) {
        loop.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back({x, y});
    };
    add(loops[0], 0, 0);
    add(loops[0], 60, 0);
    add(loops[0], 60, 40);
    add(loops[0], 0, 40);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const double x = 60.0 * (column + 0.5) / columns, y = 40.0 * (row + 0.5) / rows, r = 12.0 / columns;
            Loop& hole = loops.emplace_back();
            const int corners = (column + row) % 2 == 0 ? 4 : 24;
            for (int i = 0; i < corners; ++i) {
                const double angle = -2 * std::numbers::pi * i / corners;
                add(hole, x + r * std::cos(angle), y + r * std::sin(angle));
            }
        }
    }
    const auto count = static_cast<std::uint32_t>(points.size());
    Mesh mesh;
    for (const double z : {0.0, 5.0}) {
        for (const PlanePoint& p : points) {
            mesh.vertices.push_back({p.x, p.y, z});
        }
    }
    for (const Triangle& t : fill_loops(points, loops)) {
        mesh.triangles.push_back({t[0], t[2], t[1]});
        mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    }
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
            mesh.triangles.push_back({a, b, b + count});
            mesh.triangles.push_back({a, b + count, a + count});
        }
    }
    return mesh;
}

/// Every facet in n x n, so that many points of a cut lie in a row.
Mesh refined_cube(double side, int n) {
    Mesh mesh;
    const auto face = [&](const Vec3& corner, const Vec3& u, const Vec3& v) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int i = 0; i <= n; ++i) {
            for (int k = 0; k <= n; ++k) {
                mesh.vertices.push_back(corner + (static_cast<double>(i) / n) * u + (static_cast<double>(k) / n) * v);
            }
        }
        const auto at = [&](int i, int k) { return first + static_cast<std::uint32_t>(i * (n + 1) + k); };
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < n; ++k) {
                mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
                mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
            }
        }
    };
    const Vec3 x{side, 0, 0}, y{0, side, 0}, z{0, 0, side};
    face({}, y, x);
    face({}, z, y);
    face({}, x, z);
    face(z, x, y);
    face(x, y, z);
    face(y, z, x);
    // Equal points become one.
    std::vector<std::uint32_t> number;
    std::vector<Vec3> distinct;
    for (const Vec3& vertex : mesh.vertices) {
        const auto same = std::find_if(distinct.begin(), distinct.end(),
                                       [&](const Vec3& other) { return length(other - vertex) < 1e-9; });
        number.push_back(static_cast<std::uint32_t>(same - distinct.begin()));
        if (same == distinct.end()) distinct.push_back(vertex);
    }
    for (Triangle& t : mesh.triangles) {
        t = {number[t[0]], number[t[1]], number[t[2]]};
    }
    mesh.vertices = distinct;
    return mesh;
}

void expect_sound(const Mesh& mesh) {
    const MeshFigures figures = inspect_mesh(mesh);
    EXPECT_TRUE(figures.watertight());
    EXPECT_EQ(figures.edges.border, 0u);
    EXPECT_EQ(figures.edges.crowded, 0u);
    EXPECT_EQ(figures.edges.misdirected, 0u);
    EXPECT_EQ(figures.duplicates, 0u);
    EXPECT_EQ(figures.crossings.pairs, 0);
    EXPECT_GT(figures.volume, 0);
    EXPECT_EQ(figures.vertices, mesh.vertices.size()) << "none that is not used";
}

/// As written to a file: coordinates in single precision.
Mesh rounded(Mesh mesh) {
    for (Vec3& v : mesh.vertices) {
        v = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    }
    return mesh;
}

double thinnest(const Mesh& mesh) {
    double least = Box::kInfinity;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        least = std::min(least, length(cross(b - a, c - a)) / std::max({length(b - a), length(c - b), length(a - c)}));
    }
    return least;
}

CutMesh expect_cut(const Mesh& mesh, const Vec3& normal, double wanted) {
    const double reach = 0.001 * length(bounding_box(mesh).size());
    const auto offset = clear_offset(mesh, normal, wanted, wanted - reach, wanted + reach);
    EXPECT_TRUE(offset);
    CutMesh cut = cut_mesh(mesh, {normal, offset.value_or(wanted)});
    for (const Mesh* half : {&cut.below, &cut.above}) {
        if (half->triangles.empty()) continue;
        expect_sound(*half);
        expect_sound(rounded(*half));
        for (const Vec3& vertex : half->vertices) {
            const double height = dot(normal, vertex) - *offset;
            EXPECT_LE(half == &cut.below ? height : -height, 1e-9);
        }
        EXPECT_GT(thinnest(*half), 1e-5);
    }
    const double whole = signed_volume(mesh);
    EXPECT_NEAR(signed_volume(cut.below) + signed_volume(cut.above), whole, 1e-12 * whole);
    EXPECT_NEAR(surface_area(cut.below) + surface_area(cut.above), surface_area(mesh) + 2 * cut.area,
                1e-9 * surface_area(mesh))
        << "faces of the cut do not overlap";
    return cut;
}

TEST(PlaneCut, HalvesACube) {
    const CutMesh cut = expect_cut(cube_mesh(20), {1, 0, 0}, 5);
    EXPECT_NEAR(signed_volume(cut.below), 5 * 400, 1e-9);
    EXPECT_NEAR(cut.area, 400, 1e-9);
    EXPECT_EQ(bounding_box(cut.below), (Box{{0, 0, 0}, {5, 20, 20}}));
    EXPECT_EQ(bounding_box(cut.above), (Box{{5, 0, 0}, {20, 20, 20}}));
    for (const Vec3& normal : {Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}) {
        EXPECT_NEAR(signed_volume(expect_cut(cube_mesh(20), normal, -5).below), 15 * 400, 1e-9);
    }
}

TEST(PlaneCut, LeavesAMeshBesideThePlaneWhole) {
    const CutMesh cut = cut_mesh(cube_mesh(20), {{0, 0, 1}, 30});
    EXPECT_EQ(cut.below.triangles.size(), 12u);
    EXPECT_EQ(signed_volume(cut.below), 8000);
    EXPECT_TRUE(cut.above.triangles.empty());
    EXPECT_TRUE(cut_mesh(cube_mesh(20), {{0, 0, 1}, -1}).below.triangles.empty());
}

TEST(PlaneCut, KeepsClearOfVertices) {
    const Mesh cube = refined_cube(40, 8);  // vertices at every 5 mm
    EXPECT_EQ(clear_offset(cube, {0, 0, 1}, 12, 0, 40), 12);
    const auto beside = clear_offset(cube, {0, 0, 1}, 20, 19.9, 20.1);
    ASSERT_TRUE(beside);
    EXPECT_NEAR(std::abs(*beside - 20), 0.05, 0.01);
    EXPECT_FALSE(clear_offset(cube, {0, 0, 1}, 20, 20, 20));
    expect_cut(cube, {0, 0, 1}, 20);
}

TEST(PlaneCut, APlaneThroughVerticesLeavesBothSidesClosed) {
    const Mesh cube = refined_cube(40, 8);
    const CutMesh cut = cut_mesh(cube, {{0, 0, 1}, 20});
    expect_sound(cut.below);
    expect_sound(cut.above);
    EXPECT_NEAR(signed_volume(cut.below), 32000, 1e-6);
    EXPECT_NEAR(signed_volume(cut.above), 32000, 1e-6);
}

TEST(PlaneCut, PointsInARowStayInTheCut) {
    for (const Vec3& normal : {Vec3{0, 1, 0}, unit({1, 0, 1}), unit({1, 2, 3}), unit({-3, 1, 0.2})}) {
        expect_cut(refined_cube(40, 8), normal, dot(normal, Vec3{20, 20, 20}));
    }
}

TEST(PlaneCut, ATorusAcrossItsHole) {
    const Mesh torus = torus_mesh(30, 10);
    // Two discs.
    CutMesh cut = expect_cut(torus, {1, 0, 0}, 0.3);
    EXPECT_NEAR(cut.area, 2 * std::numbers::pi * 100, 0.05 * cut.area);
    EXPECT_EQ(bodies_of(cut.below).size(), 1u);
    // A ring: a loop in a loop.
    cut = expect_cut(torus, {0, 0, 1}, 0.3);
    EXPECT_NEAR(cut.area, std::numbers::pi * (1600 - 400), 0.05 * cut.area);
    // Beyond the hole: one loop that is not convex.
    expect_cut(torus, {1, 0, 0}, 19);
    expect_cut(torus, unit({1, 0.3, 2}), 1);
}

TEST(PlaneCut, FourLoopsOfTwoTori) {
    const Mesh two = merged(torus_mesh(30, 10), transformed(torus_mesh(10, 4), {Mat3{}, {0, 0, 0}}));
    const CutMesh cut = expect_cut(two, {1, 0, 0}, 0.3);
    EXPECT_NEAR(cut.area, 2 * std::numbers::pi * 116, 0.06 * cut.area);
    EXPECT_EQ(bodies_of(cut.below).size(), 2u);
}

TEST(PlaneCut, APlateWithHoles) {
    for (const auto& [columns, rows] : {std::pair{2, 1}, {5, 3}, {9, 6}}) {
        const Mesh plate = plate_with_holes(columns, rows);
        expect_sound(plate);
        const CutMesh along = expect_cut(plate, {0, 0, 1}, 2.2);  // all holes at once
        EXPECT_NEAR(along.area, signed_volume(plate) / 5, 1e-9);
        expect_cut(plate, {1, 0, 0}, 29);                                                         // across
        expect_cut(plate, unit({0.02, 0.01, 1}), dot(unit({0.02, 0.01, 1}), Vec3{30, 20, 2.5}));  // aslant, along
        expect_cut(plate, unit({1, 1, 0.1}), 35);
    }
}

TEST(PlaneCut, ACavityStaysInItsBody) {
    const Mesh hollow = merged(sphere_mesh(30), turned_inside_out(sphere_mesh(20)));
    const CutMesh through = expect_cut(hollow, {0, 0, 1}, 3);  // a ring as its face
    EXPECT_EQ(bodies_of(through.above).size(), 1u);
    const CutMesh above = expect_cut(hollow, {0, 0, 1}, 25);  // the cavity is not met
    ASSERT_EQ(bodies_of(above.below).size(), 1u);
    EXPECT_EQ(bodies_of(above.below)[0].triangles.size(), above.below.triangles.size());
}

TEST(PlaneCut, RandomPlanesThroughRandomBodies) {
    RandomStream random(5);
    for (int trial = 0; trial < 40; ++trial) {
        Mesh body = trial % 2 == 0 ? torus_mesh(20, 5 + 10 * random.unit(), 40, 24) : sphere_mesh(30, 16);
        for (Vec3& v : body.vertices) {  // dented, in double precision
            v = (1 + 0.06 * random.unit()) * v;
        }
        if (inspect_mesh(body).crossings.pairs > 0) continue;
        const Vec3 normal = random_direction(random);
        expect_cut(body, normal, 20 * random.unit() - 10);
    }
}

TEST(PlaneCut, MeshesThatCrossThemselvesAreClosedAllTheSame) {
    RandomStream random(6);
    for (int trial = 0; trial < 20; ++trial) {
        Mesh mesh;
        for (int i = 0; i < 4; ++i) {
            mesh = merged(mesh, transformed(torus_mesh(20, 7), {Mat3{}, 15 * random_direction(random)}));
        }
        const Plane plane{random_direction(random), 4 * random.unit()};
        const CutMesh cut = cut_mesh(mesh, plane);
        EXPECT_TRUE(is_closed(cut.below));
        EXPECT_TRUE(is_closed(cut.above));
        const double whole = signed_volume(mesh);
        EXPECT_NEAR(signed_volume(cut.below) + signed_volume(cut.above), whole, 1e-9 * whole);
    }
}

TEST(Bodies, AreToldApartByWhatTouches) {
    const Mesh cube = cube_mesh(10);
    const auto at = [&](double x) { return transformed(cube, {Mat3{}, {x, 0, 0}}); };
    EXPECT_EQ(bodies_of(merged(cube, at(11))).size(), 2u);
    EXPECT_EQ(bodies_of(merged(cube, at(10))).size(), 1u) << "faces touch";
    EXPECT_EQ(bodies_of(merged(cube, at(5))).size(), 1u);
    EXPECT_EQ(bodies_of(merged(merged(cube, at(12)), at(6))).size(), 1u) << "the third joins the others";
    // Boxes meet, the matter does not.
    EXPECT_EQ(bodies_of(merged(torus_mesh(20, 5), sphere_mesh(10))).size(), 2u);
    EXPECT_TRUE(bodies_of({}).empty());
}

TEST(LoopTriangles, KeepEveryPointInARow) {
    std::vector<PlanePoint> points;
    Loop loop;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {2, 3}, {1, 3}, {0, 3}}) {
        loop.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    const auto triangles = fill_loops(points, {loop});
    EXPECT_EQ(triangles.size(), loop.size() - 2);
    double twice = 0;
    for (const Triangle& t : triangles) {
        const double area = (points[t[1]].x - points[t[0]].x) * (points[t[2]].y - points[t[0]].y) -
                            (points[t[1]].y - points[t[0]].y) * (points[t[2]].x - points[t[0]].x);
        EXPECT_GT(area, 0.5);
        twice += area;
    }
    EXPECT_DOUBLE_EQ(twice, 18);
}

TEST(LoopTriangles, FillIslandsInHoles) {
    std::vector<PlanePoint> points;
    std::vector<Loop> loops;
    for (int i = 0; i < 5; ++i) {  // squares in squares, every other a hole
        const double r = 10 - 2 * i;
        Loop& loop = loops.emplace_back();
        for (const auto& [x, y] : {std::pair{-r, -r}, {r, -r}, {r, r}, {-r, r}}) {
            loop.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back({x, y});
        }
        if (i % 2 == 1) std::reverse(loop.begin(), loop.end());
    }
    EXPECT_EQ(fill_loops(points, loops).size(), 8u + 8u + 2u);
    EXPECT_TRUE(fill_loops(points, {}).empty());
}

}  // namespace
}  // namespace spectralpack::test
