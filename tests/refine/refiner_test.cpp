#include "refine/refiner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "geometry/mesh_distance.hpp"
#include "spectralpack/error.hpp"
#include "support/shapes.hpp"

namespace spectralpack {
namespace {

using Direction = std::array<int, 3>;

std::shared_ptr<const Bvh> surface(const Mesh& mesh) { return std::make_shared<const Bvh>(mesh); }

const Mesh kBrick = test::box_mesh({0, 0, 0}, {20, 15, 10});

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Descent, IsMinusTheSignOfTheCentralDifference) {
    const auto cost = [](double primary, std::int64_t secondary = 0) { return Cost{primary, secondary}; };
    EXPECT_EQ(descent({cost(3), cost(5), cost(5), cost(3), cost(4), cost(4)}), (Direction{-1, 1, 0}));
    // Compared as costs are: the secondary decides between equal primaries.
    EXPECT_EQ(descent({cost(1, 9), cost(1, 8), cost(1, 2), cost(2, 1), cost(0, 0), cost(0, 0)}), (Direction{1, -1, 0}));
}

TEST(Refiner, SlidesToTheWallsLessTheWallGap) {
    const auto brick = surface(kBrick);
    for (const double wall_gap : {0.0, 1.5}) {
        const Refiner refiner({{60, 50, 40}, wall_gap, 4, 3});
        const Vec3 start{5, 5, 5};
        const Refined low = refiner.refine({brick, start, 0.2}, {-1, -1, -1});
        expect_near(low.offset, {wall_gap, wall_gap, wall_gap}, 1e-12);
        EXPECT_GE(low.offset.x, wall_gap);
        const Refined high = refiner.refine({brick, {30, 25, 20}, 0.2}, {1, 1, 1});
        expect_near(high.offset, {40 - wall_gap, 35 - wall_gap, 30 - wall_gap}, 1e-12);
    }
}

TEST(Refiner, MovesAtMostTheLongestMoveInEachRound) {
    const auto brick = surface(kBrick);
    const Refiner one({{90, 90, 90}, 0, 4, 1}), three({{90, 90, 90}, 0, 4, 3});
    expect_near(one.refine({brick, {30, 30, 30}, 0}, {1, -1, 0}).offset, {34, 26, 30}, 1e-12);
    expect_near(three.refine({brick, {30, 30, 30}, 0}, {1, -1, 0}).offset, {42, 18, 30}, 1e-12);
    EXPECT_NEAR(three.refine({brick, {30, 30, 30}, 0}, {1, -1, 0}).way, 24, 1e-12);
}

TEST(Refiner, StaysWhereTheGradientIsZero) {
    Refiner refiner({{90, 90, 90}, 0, 4, 3});
    refiner.add({surface(kBrick), {0, 0, 0}, 0.2});
    const Vec3 start{31.7, 12.9, 3.3};
    const Refined refined = refiner.refine({surface(kBrick), start, 0.2}, {0, 0, 0});
    EXPECT_EQ(refined.offset, start);
    EXPECT_EQ(refined.way, 0);
    EXPECT_EQ(refined.shortfall, 0);
}

TEST(Refiner, KeepsTheLargerOfTwoGaps) {
    const auto brick = surface(kBrick);
    Refiner refiner({{90, 90, 90}, 0, 4, 3});
    refiner.add({brick, {0, 0, 0}, 1.3});
    const Refined small = refiner.refine({brick, {24, 0, 0}, 0.2}, {-1, 0, 0});
    EXPECT_NEAR(small.offset.x, 21.3, 2e-6);
    EXPECT_GE(small.offset.x, 21.3 - 1e-9);
    const Refined large = refiner.refine({brick, {24, 0, 0}, 2.5}, {-1, 0, 0});
    EXPECT_NEAR(large.offset.x, 22.5, 2e-6);
    EXPECT_NEAR(refiner.clearance({brick, large.offset, 2.5}, 100), 2.5, 2e-6);
    EXPECT_EQ(refiner.clearance({brick, large.offset, 2.5}, 1), 1);
}

TEST(Refiner, ACopyThatWasRemovedIsNoHindrance) {
    const auto brick = surface(kBrick);
    Refiner refiner({{90, 90, 90}, 0, 4, 3});
    const Refiner::CopyId first = refiner.add({brick, {0, 0, 0}, 0.2});
    const Refiner::CopyId second = refiner.add({brick, {0, 40, 0}, 0.2});
    EXPECT_NE(refiner.find(first), nullptr);
    refiner.remove(first);
    EXPECT_EQ(refiner.find(first), nullptr);
    EXPECT_NEAR(refiner.refine({brick, {10, 0, 0}, 0.2}, {-1, 0, 0}).offset.x, 0, 1e-12);
    EXPECT_EQ(refiner.clearance({brick, {0, 40, 0}, 0}, 100, second), 100);
    EXPECT_THROW(refiner.remove(first), InternalError);
    EXPECT_THROW(refiner.remove(99), InternalError);
}

/// Bricks on a lattice that leaves 0 to 2 mm between them, at a gap or touching, pushed into the
/// corner one by one: nothing is left between them but the gap.
TEST(Refiner, ClosesTheSlackOfALattice) {
    const auto brick = surface(kBrick);
    for (const double gap : {0.0, 0.2, 1.0}) {
        Refiner refiner({{100, 80, 60}, 0, 4, 3});
        for (int z = 0; z < 3; ++z) {
            for (int y = 0; y < 3; ++y) {
                for (int x = 0; x < 3; ++x) {
                    const Vec3 at{22.0 * x, 18.0 * y, 12.0 * z};
                    const Refined r = refiner.refine({brick, at, gap}, {-1, -1, -1});
                    EXPECT_EQ(r.shortfall, 0);
                    expect_near(r.offset, {(20 + gap) * x, (15 + gap) * y, (10 + gap) * z}, 1e-5);
                    EXPECT_GE(refiner.clearance({brick, r.offset, gap}, 5), gap - 1e-9);
                    refiner.add({brick, r.offset, gap});
                }
            }
        }
    }
}

TEST(Refiner, MakesUpForAStartThatIsALittleTooNearWhereThereIsRoom) {
    const auto brick = surface(kBrick);
    Refiner refiner({{90, 90, 90}, 0, 4, 3});
    refiner.add({brick, {0, 0, 0}, 0.2});
    const PlacedSurface near{brick, {20.2 - 3e-4, 2, 1}, 0.2};
    const Refined freed = refiner.refine(near, {0, 0, 0});
    EXPECT_EQ(freed.shortfall, 0);
    EXPECT_GE(refiner.clearance({brick, freed.offset, 0.2}, 1), 0.2 - 1e-9);
    EXPECT_NEAR(freed.offset.x, 20.2, 2e-6);
    // Jammed between two it stays as it is, says so, and may still move along.
    refiner.add({brick, {40.4 - 3e-4, 0, 0}, 0.2});
    const Refined jammed = refiner.refine(near, {-1, -1, 0});
    EXPECT_NEAR(jammed.shortfall, 3e-4, 1.6e-4);
    EXPECT_NEAR(jammed.offset.y, 0, 1e-9);
    EXPECT_GE(refiner.clearance({brick, jammed.offset, 0.2}, 1), 0.2 - 3e-4 - 1e-8);
    // Crossing another it does not move.
    EXPECT_EQ(refiner.refine({brick, {10, 1, 1}, 0.2}, {1, 1, 1}).offset, (Vec3{10, 1, 1}));
}

TEST(Refiner, RefusesNonsense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Refiner({{10, 10, 10}, -1, 4, 3}), UsageError);
    EXPECT_THROW(Refiner({{10, 10, 10}, nan, 4, 3}), UsageError);
    EXPECT_THROW(Refiner({{10, 10, 10}, 5, 4, 3}), UsageError);
    EXPECT_THROW(Refiner({{10, 10, 10}, 0, nan, 3}), InternalError);
    Refiner refiner({{10, 10, 10}, 0, 4, 3});
    EXPECT_THROW(refiner.add({surface(kBrick), {}, -0.1}), UsageError);
    EXPECT_THROW(refiner.add({surface(kBrick), {}, nan}), UsageError);
    EXPECT_THROW(refiner.refine({surface(kBrick), {}, nan}, {1, 1, 1}), UsageError);
}

/// Shapes of every kind, good and bad.
std::vector<Mesh> shapes() {
    Mesh open = kBrick;
    open.triangles.pop_back();
    Mesh thin = test::box_mesh({0, 0, 0}, {18, 0.01, 14});
    Mesh flat = test::box_mesh({0, 0, 0}, {18, 0, 14});
    const Mesh crossing =
        test::merged(test::box_mesh({0, 0, 0}, {12, 12, 12}), test::box_mesh({6, 6, 6}, {18, 18, 18}));
    const Mesh shells = test::merged(test::cube_mesh(5), test::box_mesh({9, 9, 9}, {14, 14, 14}));
    Mesh doubled = test::torus_mesh(8, 3, 14, 8);
    doubled.triangles.insert(doubled.triangles.end(), doubled.triangles.begin(), doubled.triangles.end());
    return {kBrick,
            test::torus_mesh(9, 3, 20, 10),
            test::sphere_mesh(7, 6),
            open,
            thin,
            flat,
            crossing,
            shells,
            doubled,
            test::turned_inside_out(test::torus_mesh(10, 2.5, 16, 8))};
}

/// Scatters copies that keep their gaps, refines each, and returns where they end.
std::vector<PlacedSurface> scatter(std::uint64_t seed, bool expectations, const Workers& workers = Workers(1)) {
    RandomStream random(seed);
    std::vector<std::shared_ptr<const Bvh>> surfaces;
    for (const Mesh& mesh : shapes()) {
        surfaces.push_back(surface(mesh));
    }
    const Vec3 size{80, 70, 60};
    const double wall_gap = 0.5, gaps[] = {0.2, 0.2, 1.1, 3};
    Refiner refiner({size, wall_gap, 4, 3});
    std::vector<PlacedSurface> standing;
    int moved = 0;
    for (int tries = 0; tries < 300 && standing.size() < 40; ++tries) {
        PlacedSurface copy{surfaces[random.below(surfaces.size())], {}, gaps[random.below(4)]};
        const Vec3 low = copy.surface->box().min, extent = copy.surface->box().size();
        for (int axis = 0; axis < 3; ++axis) {
            copy.offset[axis] = wall_gap - low[axis] + random.unit() * (size[axis] - 2 * wall_gap - extent[axis]);
        }
        bool free = true;
        for (const PlacedSurface& other : standing) {
            free = free && least_distance(*copy.surface, copy.offset, *other.surface, other.offset).distance >=
                               std::max(copy.gap, other.gap);
        }
        if (!free) continue;
        Direction direction;
        for (int& d : direction) {
            d = static_cast<int>(random.below(3)) - 1;
        }
        const Refined refined = refiner.refine(copy, direction, workers);
        moved += refined.way > 0;
        copy.offset = refined.offset;
        if (expectations) {
            EXPECT_EQ(refined.shortfall, 0);
            const Box box = copy.box();
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(box.min[axis], wall_gap - 1e-12);
                EXPECT_LE(box.max[axis], size[axis] - wall_gap + 1e-12);
            }
            for (const PlacedSurface& other : standing) {
                EXPECT_GE(least_distance(*copy.surface, copy.offset, *other.surface, other.offset).distance,
                          std::max(copy.gap, other.gap) - 1e-9);
            }
        }
        refiner.add(copy);
        standing.push_back(copy);
    }
    if (expectations) {
        EXPECT_GT(moved, 10);
    }
    return standing;
}

TEST(Refiner, KeepsEveryGapAmongShapesOfEveryKind) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        scatter(seed, true);
    }
}

TEST(Refiner, GivesTheSameForAnyNumberOfThreads) {
    const Workers three(3);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const std::vector<PlacedSurface> one = scatter(seed, false);
        for (int again = 0; again < 3; ++again) {
            const std::vector<PlacedSurface> other = scatter(seed, false, three);
            ASSERT_EQ(one.size(), other.size());
            for (std::size_t i = 0; i < one.size(); ++i) {
                EXPECT_EQ(one[i].offset, other[i].offset) << "seed " << seed << ", copy " << i;
            }
        }
    }
}

TEST(Refiner, LeastGapIsThatOfTheNearestPairForAnyNumberOfThreads) {
    Refiner refiner(RefineOptions{{80, 70, 60}});
    const std::vector<PlacedSurface> standing = scatter(3, false);
    double least = Box::kInfinity;
    for (std::size_t i = 0; i < standing.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const PlacedSurface &a = standing[i], &b = standing[k];
            least = std::min(least, least_distance(*a.surface, a.offset, *b.surface, b.offset).distance);
        }
        refiner.add(standing[i]);
    }
    EXPECT_EQ(refiner.least_gap(), least);
    EXPECT_EQ(refiner.least_gap(Workers(3)), least);
}

/// The whole path is free, not only its end: a thin wall between the start and a hollow behind it
/// is not jumped.
TEST(Refiner, DoesNotTunnel) {
    for (const double thickness : {0.0, 1e-6, 0.05}) {
        Refiner refiner({{90, 60, 60}, 0, 30, 3});
        refiner.add({surface(test::box_mesh({30, 0, 0}, {30 + thickness, 60, 60})), {}, 0.2});
        const Refined r = refiner.refine({surface(test::cube_mesh(3)), {50, 10, 10}, 0.2}, {-1, 0, 0});
        EXPECT_NEAR(r.offset.x, 30.2 + thickness, 2e-6);
    }
}

}  // namespace
}  // namespace spectralpack
