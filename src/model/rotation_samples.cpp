#include "model/rotation_samples.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kLeastStep = 6;  // degrees: 60 steps about each axis are over 100 000 orientations

/// Up to 45 degrees. Below 2^-53 after the last term.
double sine_series(double degrees) {
    const double x = degrees * (3.14159265358979323846 / 180), xx = x * x;
    double term = x, sum = x;
    for (int n = 2; n <= 18; n += 2) {
        term *= -xx / (n * (n + 1));
        sum += term;
    }
    return sum;
}

double cosine_series(double degrees) {
    const double x = degrees * (3.14159265358979323846 / 180), xx = x * x;
    double term = 1, sum = 1;
    for (int n = 1; n <= 19; n += 2) {
        term *= -xx / (n * (n + 1));
        sum += term;
    }
    return sum;
}

double sine_of_degrees(double degrees) {
    degrees = std::fmod(std::fmod(degrees, 360) + 360, 360);
    if (degrees >= 180) return -sine_of_degrees(degrees - 180);
    if (degrees > 90) return sine_of_degrees(180 - degrees);
    if (degrees == 0) return 0;
    if (degrees == 30) return 0.5;
    if (degrees == 45) return std::sqrt(0.5);
    if (degrees == 60) return std::sqrt(0.75);
    if (degrees == 90) return 1;
    return degrees < 45 ? sine_series(degrees) : cosine_series(90 - degrees);
}

double cosine_of_degrees(double degrees) { return sine_of_degrees(degrees + 90); }

/// Equal up to rounding: entries in units of 1e-6.
std::array<std::int64_t, 9> rounded(const Mat3& m) {
    std::array<std::int64_t, 9> key{};
    for (int i = 0; i < 9; ++i) {
        key[static_cast<std::size_t>(i)] = std::llround(m.rows[i / 3][i % 3] * 1e6);
    }
    return key;
}

/// The turn about an axis in the xy plane that takes +z to the unit vector v.
Mat3 least_turn_from_z(const Vec3& v) {
    if (v.z <= -1 + 1e-12) return turn_about(0, 180);
    // I + [w] + [w]^2 / (1 + v.z) with w = z x v = (-v.y, v.x, 0).
    const double s = 1 / (1 + v.z);
    return {{Vec3{1 - s * v.x * v.x, -s * v.x * v.y, v.x}, Vec3{-s * v.x * v.y, 1 - s * v.y * v.y, v.y},
             Vec3{-v.x, -v.y, v.z}}};
}

/// Two poles and two rings of five at heights of +-1/sqrt(5).
std::vector<Vec3> icosahedron_vertices() {
    std::vector<Vec3> vertices{{0, 0, 1}};
    const double height = std::sqrt(0.2), radius = 2 * height;
    for (int i = 0; i < 5; ++i) {
        vertices.push_back({radius * cosine_of_degrees(72 * i), radius * sine_of_degrees(72 * i), height});
    }
    for (int i = 0; i < 5; ++i) {
        vertices.push_back({radius * cosine_of_degrees(72 * i + 36), radius * sine_of_degrees(72 * i + 36), -height});
    }
    vertices.push_back({0, 0, -1});
    return vertices;
}

using Face = std::array<std::size_t, 3>;

std::vector<Face> icosahedron_faces() {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < 5; ++i) {
        const std::size_t next = (i + 1) % 5;
        faces.push_back({0, 1 + i, 1 + next});
        faces.push_back({1 + i, 6 + i, 1 + next});
        faces.push_back({1 + next, 6 + i, 6 + next});
        faces.push_back({11, 6 + next, 6 + i});
    }
    return faces;
}

std::vector<Vec3> sphere_points(int subdivisions) {
    std::vector<Vec3> points = icosahedron_vertices();
    std::vector<Face> faces = icosahedron_faces();
    for (int n = 0; n < subdivisions; ++n) {
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
        const auto middle = [&](std::size_t a, std::size_t b) {
            const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), points.size());
            if (fresh) {
                const Vec3 sum = points[a] + points[b];
                points.push_back(1 / length(sum) * sum);
            }
            return entry->second;
        };
        std::vector<Face> finer;
        for (const auto& [a, b, c] : faces) {
            const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    return points;
}

}  // namespace

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

void require_step(double degrees, const char* what) {
    const double steps = 360 / degrees;
    if (!(degrees > 0) || degrees > 360 || std::abs(steps - std::round(steps)) > 1e-9) {
        throw UsageError(std::string(what) + " must be an angle in degrees that divides 360");
    }
    if (degrees < kLeastStep) {
        throw UsageError(std::string(what) + " below 6 degrees gives too many ways to stand (over 100000)");
    }
}

std::vector<Mat3> euler_orientations(double step_degrees) {
    require_step(step_degrees, "a rotation step");
    const auto steps = static_cast<int>(std::lround(360 / step_degrees));
    std::vector<Mat3> rotations;
    for (int i = 0; i < steps; ++i) {
        const Mat3 about_x = turn_about(0, i * step_degrees);
        for (int j = 0; j < steps; ++j) {
            const Mat3 about_xy = about_x * turn_about(1, j * step_degrees);
            for (int k = 0; k < steps; ++k) {
                rotations.push_back(about_xy * turn_about(2, k * step_degrees));
            }
        }
    }
    return distinct(rotations);
}

double icosahedral_roll(int subdivisions) { return 90.0 / (1 << subdivisions); }

std::vector<Mat3> icosahedral_orientations(int subdivisions) {
    if (subdivisions < 0 || subdivisions > kMostSubdivisions) {
        throw UsageError("icosahedron:N takes 0 to " + std::to_string(kMostSubdivisions) + " subdivisions, not " +
                         std::to_string(subdivisions));
    }
    const double roll = icosahedral_roll(subdivisions);
    std::vector<Mat3> rotations;
    for (const Vec3& up : sphere_points(subdivisions)) {
        const Mat3 turn = least_turn_from_z(up);
        for (int k = 0; k * roll < 360; ++k) {
            rotations.push_back(turn * turn_about(2, k * roll));
        }
    }
    return rotations;
}

std::vector<Mat3> distinct(const std::vector<Mat3>& rotations) {
    std::vector<Mat3> kept;
    std::set<std::array<std::int64_t, 9>> seen;
    for (const Mat3& rotation : rotations) {
        if (seen.insert(rounded(rotation)).second) kept.push_back(rotation);
    }
    return kept;
}

}  // namespace spectralpack
