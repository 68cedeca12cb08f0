#include "model/orientation.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/error.hpp"

namespace spectralpack {
namespace {

constexpr std::int64_t kMaxOrientations = 100'000;

/// sin of a whole number of twelfths of 90 degrees where a square root gives it exactly; else the library's.
double sine_of_degrees(double degrees) {
    degrees = std::fmod(std::fmod(degrees, 360) + 360, 360);
    if (degrees >= 180) return -sine_of_degrees(degrees - 180);
    if (degrees > 90) return sine_of_degrees(180 - degrees);
    if (degrees == 0) return 0;
    if (degrees == 30) return 0.5;
    if (degrees == 45) return std::sqrt(0.5);
    if (degrees == 60) return std::sqrt(0.75);
    if (degrees == 90) return 1;
    return std::sin(degrees * (3.14159265358979323846 / 180));
}

double cosine_of_degrees(double degrees) { return sine_of_degrees(degrees + 90); }

Mat3 turn_about(int axis, double degrees) {
    const double s = sine_of_degrees(degrees), c = cosine_of_degrees(degrees);
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    Mat3 m;
    m.rows[a][a] = c;
    m.rows[a][b] = -s;
    m.rows[b][a] = s;
    m.rows[b][b] = c;
    return m;
}

/// Equal up to rounding: entries in units of 1e-6.
std::array<std::int64_t, 9> rounded(const Mat3& m) {
    std::array<std::int64_t, 9> key{};
    for (int i = 0; i < 9; ++i) {
        key[static_cast<std::size_t>(i)] = std::llround(m.rows[i / 3][i % 3] * 1e6);
    }
    return key;
}

}  // namespace

std::vector<Mat3> euler_orientations(double step_degrees) {
    if (!(step_degrees > 0) || step_degrees > 360 ||
        std::abs(360 / step_degrees - std::round(360 / step_degrees)) > 1e-9) {
        throw UsageError("a rotation step must be an angle in degrees that divides 360");
    }
    const auto steps = static_cast<std::int64_t>(std::llround(360 / step_degrees));
    if (steps > 60) {
        throw UsageError("a rotation step below 6 degrees gives too many orientations (over " +
                         std::to_string(kMaxOrientations) + ")");
    }
    std::vector<Mat3> orientations;
    std::set<std::array<std::int64_t, 9>> seen;
    for (std::int64_t i = 0; i < steps; ++i) {
        const Mat3 about_x = turn_about(0, static_cast<double>(i) * step_degrees);
        for (std::int64_t j = 0; j < steps; ++j) {
            const Mat3 about_xy = about_x * turn_about(1, static_cast<double>(j) * step_degrees);
            for (std::int64_t k = 0; k < steps; ++k) {
                const Mat3 turn = about_xy * turn_about(2, static_cast<double>(k) * step_degrees);
                if (seen.insert(rounded(turn)).second) orientations.push_back(turn);
            }
        }
    }
    return orientations;
}

std::vector<Mat3> orientation_set(const std::string& rotations) {
    if (rotations == "none") return {Mat3{}};
    double angle = 0;
    const char* end = rotations.data() + rotations.size();
    const auto parsed = std::from_chars(rotations.data(), end, angle);
    if (parsed.ec != std::errc{} || parsed.ptr != end) {
        throw UsageError("--rotations takes 'none' or an angle in degrees, not '" + rotations + "'");
    }
    return euler_orientations(angle);
}

}  // namespace spectralpack
