#include "render/camera.hpp"

#include <limits>
#include <numbers>

namespace spectralpack {
namespace {

// A long lens: little distortion, so that sizes in the picture can be compared, but still depth.
constexpr double kHalfView = 13;  // degrees, along the picture's shorter side
constexpr double kMargin = 0.07;  // of the picture, on each side

constexpr double kRadians = std::numbers::pi / 180;

/// How far back and aside the camera must stand for |a - aside| <= (depth - back) * tangent to hold for all points:
/// two bounds, each tight for one of them.
struct Fit {
    double back = 0, aside = 0;
};

class AxisFit {
  public:
    explicit AxisFit(double tangent) : tangent_(tangent) {}

    void add(double a, double depth) {
        high_ = std::max(high_, a - tangent_ * depth);
        low_ = std::max(low_, -a - tangent_ * depth);
    }
    Fit get() const { return {-(high_ + low_) / (2 * tangent_), (high_ - low_) / 2}; }

  private:
    double tangent_;
    double high_ = -std::numeric_limits<double>::infinity(), low_ = high_;
};

}  // namespace

Vec3 Camera::ray(double x, double y) const {
    return forward + ((2 * x / width - 1) * tan_x) * right + ((1 - 2 * y / height) * tan_y) * up;
}

PicturePoint Camera::project(const Vec3& point) const {
    const Vec3 v = point - eye;
    const double depth = dot(v, forward);
    return {(1 + dot(v, right) / (depth * tan_x)) * width / 2,
            (1 - dot(v, up) / (depth * tan_y)) * height / 2, depth};
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

    AxisFit across(camera.tan_x * (1 - 2 * kMargin)), upright(camera.tan_y * (1 - 2 * kMargin));
    for (const Vec3& point : points) {
        across.add(dot(point, camera.right), dot(point, camera.forward));
        upright.add(dot(point, camera.up), dot(point, camera.forward));
    }
    const Fit x = across.get(), y = upright.get();
    camera.eye =
        x.aside * camera.right + y.aside * camera.up + std::min(x.back, y.back) * camera.forward;
    return camera;
}

}  // namespace spectralpack
