/// What generated parts are built with, against definitions and brute force.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/mesh_edges.hpp"
#include "tools/generate/blocks.hpp"
#include "tools/generate/dice.hpp"
#include "tools/generate/loft.hpp"

namespace spectralpack::test {
namespace {

using namespace tools;

RC_GTEST_PROP(GenerateBuilders, DirectionsAreCosineAndSine, ()) {
    const double turns = *rc::gen::inRange(-3000000, 3000000) / 1e6;
    const Vec2 d = direction(turns);
    const double angle = 2 * std::numbers::pi * (turns - std::floor(turns));
    RC_ASSERT(std::abs(d.x - std::cos(angle)) < 2e-15);
    RC_ASSERT(std::abs(d.y - std::sin(angle)) < 2e-15);
}

TEST(GenerateBuilders, QuarterTurnsAreExact) {
    const Vec2 expected[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const Vec2 d = direction(0.25 * quarter), e = expected[(quarter + 8) % 4];
        EXPECT_EQ(d.x, e.x);
        EXPECT_EQ(d.y, e.y);
    }
}

RC_GTEST_PROP(GenerateBuilders, BlocksAreWhatTheirStepsLeave, ()) {
    struct Step {
        int low[3], high[3];
        bool filled;
    };
    const auto steps = *rc::gen::container<std::vector<Step>>(rc::gen::exec([] {
        Step step;
        for (int axis = 0; axis < 3; ++axis) {
            step.low[axis] = *rc::gen::inRange(0, 6);
            step.high[axis] = *rc::gen::inRange(step.low[axis] + 1, 8);
        }
        step.filled = *rc::gen::weightedElement<bool>({{2, true}, {1, false}});
        return step;
    }));
    Blocks blocks;
    bool cells[8][8][8] = {};
    for (const Step& s : steps) {
        const Vec3 low{1.0 * s.low[0], 1.0 * s.low[1], 1.0 * s.low[2]};
        const Vec3 high{1.0 * s.high[0], 1.0 * s.high[1], 1.0 * s.high[2]};
        s.filled ? blocks.add(low, high) : blocks.cut(low, high);
        for (int x = s.low[0]; x < s.high[0]; ++x) {
            for (int y = s.low[1]; y < s.high[1]; ++y) {
                for (int z = s.low[2]; z < s.high[2]; ++z) {
                    cells[x][y][z] = s.filled;
                }
            }
        }
    }
    int volume = 0, area = 0;
    const auto at = [&](int x, int y, int z) {
        return x >= 0 && y >= 0 && z >= 0 && x < 8 && y < 8 && z < 8 && cells[x][y][z];
    };
    for (int x = 0; x <= 8; ++x) {
        for (int y = 0; y <= 8; ++y) {
            for (int z = 0; z <= 8; ++z) {
                volume += at(x, y, z);
                area += (at(x, y, z) != at(x - 1, y, z)) + (at(x, y, z) != at(x, y - 1, z)) +
                        (at(x, y, z) != at(x, y, z - 1));
            }
        }
    }
    const Mesh mesh = blocks.mesh();
    RC_ASSERT(is_closed(mesh) == (volume > 0));
    RC_ASSERT(std::abs(signed_volume(mesh) - volume) < 1e-9);
    RC_ASSERT(std::abs(surface_area(mesh) - area) < 1e-9);
}

TEST(GenerateBuilders, LoftsAreClosedAndOutward) {
    const Outline square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, hole{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
    for (const auto& [mesh, volume] :
         {std::pair{prism(square, 1, 4), 12.0}, std::pair{ring_prism(square, hole, 1, 4), 9.0},
          std::pair{sweep({{0, 0, 0}, {5, 0, 0}}, false, square), 20.0}}) {
        EXPECT_TRUE(is_closed(mesh));
        EXPECT_NEAR(signed_volume(mesh), volume, 1e-12);
    }
    const Mesh torus = sweep(flat_path(circle(10, 400)), true, circle(2, 200));
    EXPECT_TRUE(is_closed(torus));
    EXPECT_NEAR(signed_volume(torus), 2 * std::numbers::pi * std::numbers::pi * 10 * 4, 0.5);
    const Mesh turned = turned_ring({{8, -1}, {10, -1}, {10, 1}, {8, 1}}, 400);
    EXPECT_TRUE(is_closed(turned));
    EXPECT_NEAR(signed_volume(turned), std::numbers::pi * (100 - 64) * 2, 0.1);
}

RC_GTEST_PROP(GenerateBuilders, RotationsTurnAndNeverMirror, (std::uint64_t seed)) {
    const Mat3 m = Dice(seed).cube_rotation();
    RC_ASSERT(m * transposed(m) == Mat3{});
    RC_ASSERT(dot(m.rows[0], cross(m.rows[1], m.rows[2])) == 1);
}

TEST(GenerateBuilders, QuantilesStayWithinTheirValues) {
    Dice dice(3);
    int below = 0;
    for (int i = 0; i < 10000; ++i) {
        const double value = dice.quantile({1, 2, 10});
        EXPECT_GE(value, 1);
        EXPECT_LT(value, 10);
        below += value < 2;
    }
    EXPECT_NEAR(below, 5000, 250);
}

}  // namespace
}  // namespace spectralpack::test
