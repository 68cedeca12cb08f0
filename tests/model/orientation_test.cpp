#include "model/rotation_samples.hpp"
#include "spectralpack/orientations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

bool close(const Mat3& a, const Mat3& b) {
    for (int row = 0; row < 3; ++row) {
        if (length(a.rows[row] - b.rows[row]) > 1e-9) return false;
    }
    return true;
}

bool holds(const std::vector<Mat3>& set, const Mat3& m) {
    return std::any_of(set.begin(), set.end(), [&](const Mat3& other) { return close(m, other); });
}

TEST(Orientations, NinetyDegreesGiveTheRotationGroupOfTheCube) {
    const auto set = euler_orientations(90);
    ASSERT_EQ(set.size(), 24u);
    for (const Mat3& a : set) {
        for (int i = 0; i < 9; ++i) {
            const double entry = a.rows[i / 3][i % 3];
            EXPECT_TRUE(entry == 0 || entry == 1 || entry == -1);  // exact
        }
        EXPECT_EQ(determinant(a), 1);
        for (const Mat3& b : set) {
            EXPECT_TRUE(holds(set, a * b));
        }
    }
}

TEST(Orientations, TheFirstIsTheIdentity) {
    for (const double step : {360.0, 180.0, 90.0, 45.0, 30.0}) {
        EXPECT_EQ(euler_orientations(step).front(), Mat3{}) << step;
    }
    EXPECT_EQ(orientation_set("none"), std::vector<Mat3>{Mat3{}});
}

TEST(Orientations, FinerStepsAreDistinctRotationsThatHoldTheCoarser) {
    for (const double step : {45.0, 30.0}) {
        const auto set = euler_orientations(step);
        // The middle angle may be taken within +-90 degrees; at these ends only one turn is left to choose.
        const auto n = static_cast<std::size_t>(360 / step);
        EXPECT_EQ(set.size(), (n / 2 - 1) * n * n + 2 * n);
        for (std::size_t i = 0; i < set.size(); ++i) {
            EXPECT_TRUE(close(set[i] * transposed(set[i]), Mat3{}));
            EXPECT_NEAR(determinant(set[i]), 1, 1e-12);
        }
        for (const Mat3& turn : euler_orientations(90)) {
            EXPECT_TRUE(holds(set, turn)) << step;
        }
        // Every Euler triple's matrix is in the set once.
        const double radians = step * std::acos(-1) / 180;
        const double s = std::sin(radians), c = std::cos(radians);
        const Mat3 about_x{{Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}}};
        const Mat3 about_z{{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}};
        EXPECT_EQ(std::count_if(set.begin(), set.end(), [&](const Mat3& m) { return close(m, about_x * about_z); }), 1);
    }
}

TEST(Orientations, RefuseStepsThatMakeNoGrid) {
    for (const double step : {0.0, -90.0, 17.0, 361.0, 1.0, std::nan("")}) {
        EXPECT_THROW(euler_orientations(step), UsageError) << step;
    }
    for (const char* words : {"", "many", "90x", "nan", "+box", "90+", "icosahedron:", "icosahedron:4",
                              "icosahedron:-1", "icosahedron1", "17+box"}) {
        EXPECT_THROW(orientation_set(words), UsageError) << words;
    }
}

TEST(Orientations, StepsWithoutExactConstantsAreRotationsToo) {
    for (const double step : {72.0, 40.0, 24.0}) {
        const auto set = euler_orientations(step);
        const double radians = step * std::acos(-1) / 180;
        const double s = std::sin(radians), c = std::cos(radians);
        EXPECT_TRUE(close(turn_about(2, step), {{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}})) << step;
        for (const Mat3& m : set) {
            EXPECT_TRUE(close(m * transposed(m), Mat3{}));
        }
    }
}

TEST(Orientations, IcosahedraGiveEveryVertexItsTurns) {
    const std::size_t counts[] = {48, 336, 2592};
    for (int n = 0; n < 3; ++n) {
        const auto set = icosahedral_orientations(n);
        EXPECT_EQ(set.front(), Mat3{});
        EXPECT_EQ(set.size(), counts[n]);
        EXPECT_EQ(distinct(set).size(), set.size());
        double nearest = 4;
        for (const Mat3& m : set) {
            EXPECT_TRUE(close(m * transposed(m), Mat3{}));
            EXPECT_NEAR(determinant(m), 1, 1e-12);
            const double angle = std::acos(std::clamp(m.rows[2].z, -1.0, 1.0));  // of where +z goes
            if (angle > 1e-6) nearest = std::min(nearest, angle);
        }
        EXPECT_NEAR(nearest, std::atan(2) / (1 << n), 0.06);
    }
    EXPECT_EQ(orientation_set("icosahedron"), icosahedral_orientations(0));
    EXPECT_EQ(orientation_set("icosahedron:1"), icosahedral_orientations(1));
}

TEST(Orientations, TheBoxFrameAddsItsTwentyFourTurns) {
    const Mat3 frame = turn_about(2, 24) * turn_about(0, 40);
    for (const char* base : {"none", "90", "45", "icosahedron"}) {
        const auto plain = orientation_set(base);
        const auto set = orientation_set(parse_rotations(std::string(base) + "+box"), {}, frame);
        ASSERT_EQ(set.size(), plain.size() + 24) << base;
        EXPECT_TRUE(std::equal(plain.begin(), plain.end(), set.begin())) << base;
        for (const Mat3& turn : euler_orientations(90)) {
            EXPECT_TRUE(holds(set, turn * frame)) << base;
        }
        EXPECT_EQ(orientation_set(parse_rotations(std::string(base) + "+box"), {}), plain) << base;
    }
    // A frame along the axes adds what is not there yet.
    EXPECT_EQ(orientation_set(parse_rotations("90+box"), {}, turn_about(0, 90)).size(), 24u);
    EXPECT_EQ(orientation_set(parse_rotations("none+box"), {}, turn_about(0, 90)).size(), 24u);
}

TEST(Orientations, PartsKeepToWhatTheirJobSays) {
    using Kind = PartOrientations::Kind;
    const RotationSpec by45 = parse_rotations("45+box");
    const Mat3 frame = turn_about(0, 24);
    PartOrientations part;
    part.kind = Kind::fixed;
    EXPECT_EQ(orientation_set(by45, part, frame), std::vector<Mat3>{Mat3{}});

    part.kind = Kind::upright;
    const auto upright = orientation_set(by45, part, frame);
    ASSERT_EQ(upright.size(), 8u);
    EXPECT_EQ(upright.front(), Mat3{});
    for (const Mat3& m : upright) {
        EXPECT_EQ(m * (Vec3{0, 0, 1}), (Vec3{0, 0, 1}));
    }
    EXPECT_EQ(orientation_set(parse_rotations("none"), part).size(), 1u);
    EXPECT_EQ(orientation_set(parse_rotations("icosahedron:1"), part).size(), 8u);

    part.kind = Kind::axes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool positive : {true, false}) {
            part.up = {{axis, positive}};
            part.yaw = 90;
            const auto set = orientation_set(by45, part, frame);
            ASSERT_EQ(set.size(), 4u);
            Vec3 up;
            up[axis] = positive ? 1 : -1;
            for (const Mat3& m : set) {
                EXPECT_EQ(m * up, (Vec3{0, 0, 1}));
                EXPECT_EQ(determinant(m), 1);
            }
            part.yaw.reset();
            EXPECT_EQ(orientation_set(by45, part, frame).size(), 8u);
        }
    }
    part.yaw = 17;
    EXPECT_THROW(orientation_set(by45, part), UsageError);

    part.kind = Kind::matrices;
    part.matrices = {frame, turn_about(1, 90), frame};
    EXPECT_EQ(orientation_set(by45, part), (std::vector<Mat3>{frame, turn_about(1, 90)}));
}

TEST(Orientations, OnlyRotationsPassForRotations) {
    const Mat3 turn = turn_about(2, 24) * turn_about(0, 40);
    Mat3 printed = turn;  // as a person writes it
    for (Vec3& row : printed.rows) {
        row = {std::round(row.x * 1e7) / 1e7, std::round(row.y * 1e7) / 1e7, std::round(row.z * 1e7) / 1e7};
    }
    const auto mended = as_rotation(printed);
    ASSERT_TRUE(mended);
    EXPECT_TRUE(close(*mended * transposed(*mended), Mat3{}));
    EXPECT_LT(length(mended->rows[0] - turn.rows[0]), 1e-6);
    for (const Mat3& cube : euler_orientations(90)) {
        EXPECT_EQ(as_rotation(cube), cube);
    }
    EXPECT_FALSE(as_rotation({{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}));
    EXPECT_FALSE(as_rotation(2.0 * Mat3{}));
    EXPECT_FALSE(as_rotation({{Vec3{1, 0.1, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}));
    EXPECT_FALSE(as_rotation({{Vec3{std::nan(""), 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}));
}

}  // namespace
}  // namespace spectralpack
