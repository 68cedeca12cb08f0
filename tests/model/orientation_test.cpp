#include "model/orientation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

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
    for (const char* words : {"", "many", "90x", "nan"}) {
        EXPECT_THROW(orientation_set(words), UsageError) << words;
    }
}

}  // namespace
}  // namespace spectralpack
