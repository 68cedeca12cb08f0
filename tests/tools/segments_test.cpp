/// Bodies made of fields, and their cutting into pieces that fit a room.

#include "tools/generate/segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "geometry/mesh_edges.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/mesh_figures.hpp"
#include "support/shapes.hpp"
#include "tools/generate/implicit_surface.hpp"
#include "tools/generate/whole_bodies.hpp"

namespace spectralpack::test {
namespace {

using namespace tools;

void expect_sound(const Mesh& mesh, std::size_t shells = 1) {
    const MeshFigures figures = inspect_mesh(mesh);
    EXPECT_TRUE(figures.watertight());
    EXPECT_EQ(figures.edges.border + figures.edges.crowded + figures.edges.misdirected, 0u);
    EXPECT_EQ(figures.crossings.pairs, 0);
    EXPECT_EQ(figures.duplicates, 0u);
    EXPECT_EQ(figures.shells, shells);
    EXPECT_GT(figures.volume, 0);
}

/// Some balls that run into one another.
Mesh random_body(std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<std::pair<Vec3, double>> balls;
    for (int i = 0; i < 12; ++i) {
        const double x = 60 * random.unit(), y = 40 * random.unit(), z = 30 * random.unit();
        balls.emplace_back(Vec3{x, y, z}, 8 + 8 * random.unit());
    }
    const auto field = [&](const Vec3& p) {
        double nearest = Box::kInfinity;
        for (const auto& [centre, radius] : balls) {
            nearest = std::min(nearest, length(p - centre) - radius);
        }
        return nearest;
    };
    return surface_of(field, {{-20, -20, -20}, {80, 60, 50}}, 2.5);
}

void expect_fits(const Mesh& mesh, const Vec3& room) {
    const Vec3 size = bounding_box(mesh).size();
    std::array<double, 3> sides{size.x, size.y, size.z}, rooms{room.x, room.y, room.z};
    std::ranges::sort(sides);
    std::ranges::sort(rooms);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(sides[i], rooms[i] + kContainTolerance);
    }
}

/// Each is closed, and together they are the whole.
void expect_pieces_of(const Mesh& whole, const std::vector<Mesh>& pieces) {
    double volume = 0;
    Box box;
    for (const Mesh& piece : pieces) {
        EXPECT_TRUE(is_closed(piece));
        EXPECT_GT(signed_volume(piece), 0);
        volume += signed_volume(piece);
        box.add(bounding_box(piece));
    }
    EXPECT_NEAR(volume, signed_volume(whole), 1e-9 * signed_volume(whole));
    EXPECT_EQ(box, bounding_box(whole)) << "each in its place";
}

TEST(ImplicitSurface, IsClosedAndWhereTheFieldIsNought) {
    const Mesh ball = surface_of([](const Vec3& p) { return length(p) - 10; }, {{-12, -12, -12}, {12, 12, 12}}, 1);
    expect_sound(ball);
    EXPECT_NEAR(signed_volume(ball), 4188.8, 0.02 * 4188.8);
    for (const Vec3& vertex : ball.vertices) {
        EXPECT_NEAR(length(vertex), 10, 0.15);
    }
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        const MeshFigures figures = inspect_mesh(random_body(seed));
        EXPECT_TRUE(figures.watertight());
        EXPECT_EQ(figures.crossings.pairs, 0);
        EXPECT_EQ(figures.edges.crowded, 0u);
    }
}

TEST(ImplicitSurface, OfFieldsThatAreNoughtAtGridPoints) {
    const auto cube = [](const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 5; };
    expect_sound(surface_of(cube, {{-7, -7, -7}, {7, 7, 7}}, 1));
}

TEST(WholeBodies, AreSoundAndOfTheSizeWanted) {
    const Mesh bunny = bunny_body(), molecule = molecule_body();
    expect_sound(bunny, 2);  // it is hollow
    expect_sound(molecule);
    for (const Mesh* body : {&bunny, &molecule}) {
        const Vec3 size = bounding_box(*body).size();
        EXPECT_NEAR(std::max({size.x, size.y, size.z}), 125, 25);
    }
}

TEST(Segments, AreAsManyAsAreAskedFor) {
    for (const std::uint64_t seed : {0u, 1u, 2u, 3u}) {
        for (const auto& [whole, count] : {std::pair{bunny_body(), 13}, {molecule_body(), 12}}) {
            const auto pieces = cut_into_segments(whole, {.pieces = count, .seed = seed});
            ASSERT_EQ(pieces.size(), static_cast<std::size_t>(count));
            expect_pieces_of(whole, pieces);
            for (const Mesh& piece : pieces) {
                expect_sound(piece);
            }
        }
    }
}

TEST(Segments, FitTheRoom) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Mesh whole = random_body(seed);
        for (const Vec3& room : {Vec3{200, 200, 200}, {50, 50, 50}, {20, 70, 25}, {12, 12, 12}}) {
            const auto pieces = cut_into_segments(whole, {.room = room});
            expect_pieces_of(whole, pieces);
            for (const Mesh& piece : pieces) {
                expect_fits(piece, room);
            }
            EXPECT_EQ(pieces.size() == 1, room.x == 200);
        }
    }
}

TEST(Segments, AreAsFewAsTheRoomAllows) {
    const auto count = [](const Mesh& mesh, const Vec3& room) {
        return cut_into_segments(mesh, {.room = room}).size();
    };
    EXPECT_EQ(count(cube_mesh(100), {100, 100, 100}), 1u);
    EXPECT_EQ(count(cube_mesh(100), {100, 100, 99}), 2u);
    EXPECT_EQ(count(cube_mesh(100), {50, 50, 50}), 8u) << "exactly";
    EXPECT_EQ(count(cube_mesh(100), {34, 100, 100}), 3u);
    EXPECT_EQ(count(box_mesh({0, 0, 0}, {10, 100, 20}), {100, 20, 10}), 1u) << "turned";
    EXPECT_EQ(count(box_mesh({-30, 7, 0}, {370, 17, 20}), {10, 101, 20}), 4u);
    // 100.3 mm cannot be halved in single precision into slabs of no more than 50.15.
    const auto pieces = cut_into_segments(box_mesh({0, 0, 0}, {100.3, 10, 10}), {.room = Vec3{50.15, 10, 10}});
    EXPECT_LE(pieces.size(), 3u);
    for (const Mesh& piece : pieces) {
        EXPECT_LE(static_cast<double>(static_cast<float>(bounding_box(piece).size().x)), 50.15 + kContainTolerance);
    }
}

TEST(Segments, BodiesThatLieApartAreNotCutWhereTheyFitAlone) {
    const Mesh two = merged(cube_mesh(20), transformed(cube_mesh(20), {Mat3{}, {80, 0, 0}}));
    const auto pieces = cut_into_segments(two, {.room = Vec3{50, 50, 50}});
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].triangles.size(), 12u);
    EXPECT_EQ(cut_into_segments(two, {.room = Vec3{100, 20, 20}}).size(), 1u) << "they stay together where they fit";
}

TEST(Segments, MoreThanTheRoomDemandsWhereTheyAreWanted) {
    const auto pieces = cut_into_segments(cube_mesh(100), {.room = Vec3{100, 100, 50}, .pieces = 7, .seed = 3});
    EXPECT_EQ(pieces.size(), 7u);
    expect_pieces_of(cube_mesh(100), pieces);
}

TEST(Segments, DifferBySeedAndByNothingElse) {
    const Mesh whole = random_body(5);
    const auto cut = [&](std::uint64_t seed) { return cut_into_segments(whole, {.pieces = 5, .seed = seed}); };
    const auto first = cut(1), again = cut(1), other = cut(2);
    ASSERT_EQ(first.size(), again.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].vertices, again[i].vertices);
        EXPECT_EQ(first[i].triangles, again[i].triangles);
    }
    EXPECT_NE(first[0].vertices, other[0].vertices);
}

TEST(Segments, RefuseToBeThousands) {
    EXPECT_THROW(cut_into_segments(cube_mesh(100), {.room = Vec3{1, 1, 1}}), UsageError);
    EXPECT_THROW(cut_into_segments(cube_mesh(100), {.room = Vec3{1e-9, 100, 100}}), UsageError);
    EXPECT_THROW(cut_into_segments(cube_mesh(100), {.pieces = kMostSegments + 1}), UsageError);
}

TEST(Segments, AreNumberedFromOne) {
    EXPECT_EQ(segment_name("bunny", 1), "bunny-01");
    EXPECT_EQ(segment_name("bunny", 12), "bunny-12");
    EXPECT_EQ(segment_name("bunny", 123), "bunny-123");
}

}  // namespace
}  // namespace spectralpack::test
