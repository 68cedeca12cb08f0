#include "model/rotation_samples.hpp"
#include "spectralpack/orientations.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kRotation = 1e-6;  // how far an entry of R R^T may be from the identity's

template <class Number>
bool parse_whole(std::string_view text, Number& number) {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    return parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
}

std::vector<Mat3> sampled(const RotationSpec& rotations) {
    switch (rotations.sampling) {
        case RotationSpec::Sampling::none:
            return {Mat3{}};
        case RotationSpec::Sampling::euler:
            return euler_orientations(rotations.step);
        case RotationSpec::Sampling::icosahedron:
            return icosahedral_orientations(rotations.subdivisions);
    }
    return {};
}

/// A turn that makes the part's axis point up.
Mat3 upward(const SignedAxis& up) {
    switch (up.axis) {
        case 0:
            return turn_about(1, up.positive ? -90 : 90);
        case 1:
            return turn_about(0, up.positive ? 90 : -90);
        default:
            return turn_about(0, up.positive ? 0 : 180);
    }
}

std::vector<Mat3> turned_about_vertical(const std::vector<SignedAxis>& ups, double yaw) {
    std::vector<Mat3> set;
    for (const SignedAxis& up : ups) {
        const Mat3 stood = upward(up);
        for (int k = 0; k * yaw < 360 - 1e-6; ++k) {
            set.push_back(turn_about(2, k * yaw) * stood);
        }
    }
    return distinct(set);
}

}  // namespace

RotationSpec parse_rotations(const std::string& rotations) {
    constexpr std::string_view kBox = "+box", kIcosahedron = "icosahedron";
    RotationSpec spec;
    std::string_view text = rotations;
    if (text.ends_with(kBox)) {
        spec.box = true;
        text.remove_suffix(kBox.size());
    }
    if (text == "none") {
        spec.sampling = RotationSpec::Sampling::none;
        return spec;
    }
    if (text.starts_with(kIcosahedron)) {
        spec.sampling = RotationSpec::Sampling::icosahedron;
        text.remove_prefix(kIcosahedron.size());
        if (text.empty()) return spec;
        if (text.front() == ':' && parse_whole(text.substr(1), spec.subdivisions)) return spec;
    } else if (parse_whole(text, spec.step)) {
        return spec;
    }
    throw UsageError("--rotations takes 'none', an angle in degrees or 'icosahedron:N', each also with '+box'; not '" +
                     rotations + "'");
}

double yaw_step(const RotationSpec& rotations) {
    switch (rotations.sampling) {
        case RotationSpec::Sampling::none:
            return 360;
        case RotationSpec::Sampling::euler:
            return rotations.step;
        case RotationSpec::Sampling::icosahedron:
            return icosahedral_roll(rotations.subdivisions);
    }
    return 360;
}

std::optional<Mat3> as_rotation(const Mat3& matrix) {
    const Mat3 product = matrix * transposed(matrix);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double off = product.rows[row][column] - (row == column ? 1 : 0);
            if (!(std::abs(off) <= kRotation)) return std::nullopt;
        }
    }
    if (determinant(matrix) < 0) return std::nullopt;
    const auto unit = [](const Vec3& v) { return 1 / length(v) * v; };
    const Vec3 x = unit(matrix.rows[0]);
    const Vec3 y = unit(matrix.rows[1] - dot(matrix.rows[1], x) * x);
    return Mat3{{x, y, cross(x, y)}};
}

std::vector<Mat3> orientation_set(const RotationSpec& rotations, const PartOrientations& part, const Mat3& box_frame) {
    using Kind = PartOrientations::Kind;
    switch (part.kind) {
        case Kind::fixed:
            return {Mat3{}};
        case Kind::upright:
            require_step(yaw_step(rotations), "a rotation step");
            return turned_about_vertical({SignedAxis{}}, yaw_step(rotations));
        case Kind::axes: {
            const double yaw = part.yaw.value_or(yaw_step(rotations));
            require_step(yaw, "a turn about the vertical");
            return turned_about_vertical(part.up, yaw);
        }
        case Kind::matrices:
            return distinct(part.matrices);
        case Kind::any:
            break;
    }
    std::vector<Mat3> set = sampled(rotations);
    if (!rotations.box || box_frame == Mat3{}) return set;
    for (const Mat3& turn : euler_orientations(90)) {
        set.push_back(turn * box_frame);
    }
    return distinct(set);
}

std::vector<Mat3> orientation_set(const std::string& rotations) {
    return orientation_set(parse_rotations(rotations), {});
}

}  // namespace spectralpack
