#include "render/camera.hpp"

#include <limits>
#include <numbers>

namespace spectralpack {
namespace {

// A long lens: little distortion, so that sizes in the picture can be compared, but still depth.
constexpr double kHalfView = 13;  // degrees, along the picture's shorter side
constexpr double kMargin = 0.07;  // of the picture, on each side
constexpr double kNearest = 0.5;  // of the depth of what is shown: nearer, perspective looks wild

constexpr double kRadians = std::numbers::pi / 180;

/// How far back and aside the camera must stand so that |a - aside| <= (depth - back) * tangent
/// holds for all points (a, depth): two bounds, each tight for one of them.
struct Fit {
    double back = 0, aside = 0;
};

Fit fit_axis(std::span<const Vec3> points, const Vec3& axis, const Vec3& forward, double tangent) {
    double high = -std::numeric_limits<double>::infinity(), low = high;
    for (const Vec3& point : points) {
        const double a = dot(point, axis), depth = dot(point, forward);
        high = std::max(high, a - tangent * depth);
        low = std::max(low, -a - tangent * depth);
    }
    return {-(high + low) / (2 * tangent), (high - low) / 2};
}

/// The same for a camera that stands further back: as far aside as leaves equal margins.
double centred(std::span<const Vec3> points, const Vec3& axis, const Vec3& forward, double tangent, double back) {
    double narrow = 0, wide = tangent;
    for (int i = 0; i < 50; ++i) {
        const double middle = (narrow + wide) / 2;
        (fit_axis(points, axis, forward, middle).back < back ? narrow : wide) = middle;
    }
    return fit_axis(points, axis, forward, wide).aside;
}

}  // namespace

Vec3 Camera::ray(double x, double y) const {
    return forward + ((2 * x / width - 1) * tan_x) * right + ((1 - 2 * y / height) * tan_y) * up;
}

PicturePoint Camera::project(const Vec3& point) const {
    const Vec3 v = point - eye;
    const double depth = dot(v, forward);
    return {(1 + dot(v, right) / (depth * tan_x)) * width / 2, (1 - dot(v, up) / (depth * tan_y)) * height / 2, depth};
}

Camera fit_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height) {
    const double a = azimuth * kRadians, e = elevation * kRadians;
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.right = {std::cos(a), std::sin(a), 0};
    camera.forward = {-std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), -std::sin(e)};
    camera.up = cross(camera.right, camera.forward);
    const double shorter = std::min(width, height);
    camera.tan_x = std::tan(kHalfView * kRadians) * width / shorter;
    camera.tan_y = std::tan(kHalfView * kRadians) * height / shorter;

    const double across = camera.tan_x * (1 - 2 * kMargin), upright = camera.tan_y * (1 - 2 * kMargin);
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Vec3& point : points) {
        first = std::min(first, dot(point, camera.forward));
        last = std::max(last, dot(point, camera.forward));
    }
    const double back =
        std::min({fit_axis(points, camera.right, camera.forward, across).back,
                  fit_axis(points, camera.up, camera.forward, upright).back, first - kNearest * (last - first)});
    camera.eye = centred(points, camera.right, camera.forward, across, back) * camera.right +
                 centred(points, camera.up, camera.forward, upright, back) * camera.up + back * camera.forward;
    return camera;
}

}  // namespace spectralpack
