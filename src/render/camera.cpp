#include "render/camera.hpp"

#include <limits>
#include <numbers>

namespace spectralpack {
namespace {

// A long lens: little distortion, so that sizes in the picture can be compared, but still depth.
constexpr double kHalfView = 13;  // degrees, along the picture's shorter side
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

/// Looks the given way in a picture of the given size; stands nowhere yet.
Camera turned_camera(double azimuth, double elevation, int width, int height) {
    const double a = azimuth * kRadians, e = elevation * kRadians;
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.right = {std::cos(a), std::sin(a), 0};
    camera.forward = {-std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), -std::sin(e)};
    camera.up = cross(camera.right, camera.forward);
    return camera;
}

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    double middle() const { return (low + high) / 2; }
    double half() const { return (high - low) / 2; }
};

Span span_along(std::span<const Vec3> points, const Vec3& axis) {
    Span span;
    for (const Vec3& point : points) {
        span.low = std::min(span.low, dot(point, axis));
        span.high = std::max(span.high, dot(point, axis));
    }
    return span;
}

}  // namespace

Vec3 Camera::ray(double x, double y) const {
    if (lens == Lens::parallel) return forward;
    return forward + ((2 * x / width - 1) * tan_x) * right + ((1 - 2 * y / height) * tan_y) * up;
}

Vec3 Camera::origin(double x, double y) const {
    if (lens == Lens::perspective) return eye;
    return eye + ((2 * x / width - 1) * tan_x) * right + ((1 - 2 * y / height) * tan_y) * up;
}

PicturePoint Camera::project(const Vec3& point) const {
    const Vec3 v = point - eye;
    const double depth = dot(v, forward), scale = lens == Lens::parallel ? 1 : depth;
    return {(1 + dot(v, right) / (scale * tan_x)) * width / 2, (1 - dot(v, up) / (scale * tan_y)) * height / 2, depth};
}

Vec3 Camera::to_viewer(const Vec3& point) const {
    if (lens == Lens::parallel) return -forward;
    const Vec3 v = eye - point;
    return 1 / length(v) * v;
}

double Camera::pixel_size(const Vec3& point) const {
    return 2 * tan_y / height * (lens == Lens::parallel ? 1 : length(point - eye));
}

Camera fit_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height) {
    Camera camera = turned_camera(azimuth, elevation, width, height);
    const double shorter = std::min(width, height);
    camera.tan_x = std::tan(kHalfView * kRadians) * width / shorter;
    camera.tan_y = std::tan(kHalfView * kRadians) * height / shorter;

    const double across = camera.tan_x * (1 - 2 * kMargin), upright = camera.tan_y * (1 - 2 * kMargin);
    const Span depth = span_along(points, camera.forward);
    const double back = std::min({fit_axis(points, camera.right, camera.forward, across).back,
                                  fit_axis(points, camera.up, camera.forward, upright).back,
                                  depth.low - kNearest * (depth.high - depth.low)});
    camera.eye = centred(points, camera.right, camera.forward, across, back) * camera.right +
                 centred(points, camera.up, camera.forward, upright, back) * camera.up + back * camera.forward;
    return camera;
}

Camera fit_parallel_camera(std::span<const Vec3> points, double azimuth, double elevation, int width, int height,
                           double margin) {
    Camera camera = turned_camera(azimuth, elevation, width, height);
    camera.lens = Lens::parallel;
    const Span across = span_along(points, camera.right), upright = span_along(points, camera.up);
    const Span depth = span_along(points, camera.forward);
    const double half_pixel = std::max(across.half() / width, upright.half() / height) / (1 - 2 * margin);
    camera.tan_x = half_pixel * width;
    camera.tan_y = half_pixel * height;
    camera.eye = across.middle() * camera.right + upright.middle() * camera.up +
                 (depth.low - (depth.high - depth.low) - half_pixel) * camera.forward;
    return camera;
}

}  // namespace spectralpack
