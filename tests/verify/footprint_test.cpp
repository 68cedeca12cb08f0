#include "verify/footprint.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace spectralpack::test {
namespace {

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How far inside a convex polygon a point is; negative outside.
double inside_by(const Polygon& polygon, const Point2& p) {
    double least = polygon.empty() ? -kFar : kFar;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Point2& a = polygon.corners[i];
        const Point2& b = polygon.corners[(i + 1) % polygon.corners.size()];
        least = std::min(least, turn(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
    }
    return least;
}

struct Scene {
    Corners triangle;
    std::vector<Corners> others;
    PlaneFrame frame;
    std::vector<Polygon> prints;
    double reach;
};

Scene random_scene(RandomStream& random) {
    const Mat3 turned = random_rotation(random);
    const Vec3 away = random_point(random, 100);
    const auto placed = [&](const Vec3& p) { return turned * p + away; };
    const auto corners = [&](double flatness) {
        Corners c;
        const Vec3 middle{between(random, -4, 4), between(random, -4, 4), between(random, -flatness, flatness)};
        for (Vec3& p : c) {
            const Vec3 d = random_point(random, 4);
            p = placed(middle + Vec3{d.x, d.y, flatness * d.z});
        }
        return c;
    };
    const Corners triangle{placed({-8, -6, 0}), placed({9, -7, 0}), placed({between(random, -9, 9), 8, 0})};
    Scene scene{triangle, {}, PlaneFrame(triangle), {}, 0.3};
    for (std::uint64_t i = 0, count = random.below(9); i < count; ++i) {
        const double flatness[] = {0, 0.05, 1};
        scene.others.push_back(corners(flatness[random.below(3)]));
        Polygon print = footprint(scene.frame, scene.others.back(), scene.reach);
        if (!print.empty()) scene.prints.push_back(std::move(print));
    }
    return scene;
}

TEST(Footprint, CoversWhatIsNearAndNothingFar) {
    RandomStream random(1);
    int near = 0, far = 0;
    for (int i = 0; i < 300; ++i) {
        const Scene scene = random_scene(random);
        for (const Corners& other : scene.others) {
            const Polygon print = footprint(scene.frame, other, scene.reach);
            for (int k = 0; k < 100; ++k) {
                const Point2 p{between(random, -12, 22), between(random, -12, 22)};
                const double distance = point_triangle_distance(scene.frame.to_space(p), other);
                if (distance <= scene.reach) {
                    EXPECT_GT(inside_by(print, p), -1e-9);
                    ++near;
                } else if (distance > std::sqrt(3) * scene.reach * (1 + 1e-5)) {
                    EXPECT_LT(inside_by(print, p), 1e-9);
                    ++far;
                }
            }
        }
    }
    EXPECT_GT(near, 500);
    EXPECT_GT(far, 500);
}

TEST(Footprint, PiecesAreTheRestAndDoNotOverlap) {
    RandomStream random(2);
    int covered = 0, free = 0;
    for (int i = 0; i < 300; ++i) {
        const Scene scene = random_scene(random);
        const Polygon whole = in_plane(scene.frame, scene.triangle);
        const std::vector<Polygon> pieces = free_pieces(whole, scene.prints);
        for (const Polygon& piece : pieces) {
            EXPECT_GT(inside_by(piece, piece.centre()), 0);
        }
        for (int k = 0; k < 200; ++k) {
            const Point2 p{between(random, -12, 22), between(random, -12, 22)};
            double in_print = -kFar, in_piece = -kFar;
            int holders = 0;
            for (const Polygon& print : scene.prints) {
                in_print = std::max(in_print, inside_by(print, p));
            }
            for (const Polygon& piece : pieces) {
                in_piece = std::max(in_piece, inside_by(piece, p));
                holders += inside_by(piece, p) > 1e-9;
            }
            const double in_whole = inside_by(whole, p);
            EXPECT_LE(holders, 1);
            if (in_whole > 1e-6 && in_print < -1e-6) {
                EXPECT_GT(in_piece, -1e-7);
                ++free;
            } else if (in_whole < -1e-9 || in_print > 1e-9) {
                EXPECT_LT(in_piece, 1e-9);
                ++covered;
            }
        }
    }
    EXPECT_GT(covered, 1000);
    EXPECT_GT(free, 1000);
}

TEST(Footprint, PathsAreClearThatMeetNoFootprint) {
    RandomStream random(3);
    int clear = 0, blocked = 0;
    for (int i = 0; i < 2000; ++i) {
        const Scene scene = random_scene(random);
        const Polygon whole = in_plane(scene.frame, scene.triangle);
        const auto point = [&] {
            return Point2{between(random, whole.low.x, whole.high.x), between(random, whole.low.y, whole.high.y)};
        };
        const Point2 from = point(), to = point();
        double deepest = -kFar;
        for (int k = 0; k <= 400; ++k) {
            const Point2 p{from.x + k / 400.0 * (to.x - from.x), from.y + k / 400.0 * (to.y - from.y)};
            for (const Polygon& print : scene.prints) {
                deepest = std::max(deepest, inside_by(print, p));
            }
        }
        if (clear_path(from, to, scene.prints)) {
            EXPECT_LE(deepest, 1e-9);
            ++clear;
        } else {
            EXPECT_GT(deepest, -0.1);  // a step of the sampling away
            ++blocked;
        }
    }
    EXPECT_GT(clear, 200);
    EXPECT_GT(blocked, 200);
}

TEST(Footprint, ATriangleWithinItsOwnFootprintHasNoFreePiece) {
    const Corners triangle{Vec3{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    const PlaneFrame frame(triangle);
    const Polygon whole = in_plane(frame, triangle);
    EXPECT_TRUE(free_pieces(whole, {footprint(frame, triangle, 1e-3)}).empty());
    EXPECT_EQ(free_pieces(whole, {}).size(), 1u);
    EXPECT_TRUE(footprint(frame, {Vec3{0, 0, 1}, {10, 0, 1}, {0, 10, 1}}, 0.5).empty());
}

}  // namespace
}  // namespace spectralpack::test
