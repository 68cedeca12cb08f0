#include "render/shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kKeyLight = 1.0, kSkyLight = 0.72, kGroundLight = 0.42;
constexpr double kSheen = 0.05, kSheenPower = 22;
constexpr double kKeyLeft = 62, kKeyUp = 52;  // degrees from the camera's heading, above the floor
constexpr double kKeyRadius = 0.10;           // tangent of half the angle the key light fills
constexpr double kSkyReach = 0.7;             // stage units: what is further off takes no sky light away
constexpr double kOffSurface = 2e-4;          // stage units

Vec3 unit(const Vec3& v) { return 1 / length(v) * v; }

/// Two directions at right angles to a unit vector (Duff et al., "Building an orthonormal basis,
/// revisited", 2017).
struct Frame {
    explicit Frame(const Vec3& n) : normal(n) {
        const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
        across = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        along = {b, sign + n.y * n.y * a, -n.y};
    }
    Vec3 operator*(const Vec3& v) const { return v.x * across + v.y * along + v.z * normal; }
    Vec3 across, along, normal;
};

/// Points of the unit disc, evenly spread, also those of any run of consecutive numbers (Roberts's
/// R2 sequence).
Vec3 disc_point(int i) {
    const double u = std::fmod(0.5 + i * 0.7548776662466927, 1.0);
    const double v = std::fmod(0.5 + i * 0.5698402909980532, 1.0);
    const double r = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle), 0};
}

/// Which cell of the pattern a pixel is; the steps keep neighbours' rays apart.
int cell(int x, int y) {
    constexpr int n = Shading::kPattern;
    const int column = ((x % n) + n) % n, row = ((y % n) + n) % n;
    return (13 * column + 6 * row) % (n * n);
}

/// Straight up to 0.7, then bending so that it never reaches 1.
double toned(double c) {
    constexpr double kKnee = 0.7;
    return c <= kKnee ? c : kKnee + (1 - kKnee) * std::tanh((c - kKnee) / (1 - kKnee));
}

/// Light that other surfaces of the same colour hand on (Jimenez et al., "Practical real-time
/// strategies for accurate indirect occlusion", 2016): crevices keep their colour instead of
/// turning black.
double handed_on(double open, double albedo) {
    const double a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return std::max(open, ((open * a + b) * open + c) * open);
}

}  // namespace

Shading::Shading(const Camera& camera, Backdrop backdrop) : camera_(camera), backdrop_(backdrop) {
    const double left = kKeyLeft * std::numbers::pi / 180, up = kKeyUp * std::numbers::pi / 180;
    const Vec3 back = unit(cross(camera.right, Vec3{0, 0, 1}));  // level, from the scene towards the viewer
    key_ = unit(std::cos(up) * (-std::sin(left) * camera.right + std::cos(left) * back) + Vec3{0, 0, std::sin(up)});
    for (std::size_t i = 0; i < sky_rays_.size(); ++i) {
        const Vec3 p = disc_point(static_cast<int>(i));
        sky_rays_[i] = {p.x, p.y, std::sqrt(std::max(0.0, 1 - dot(p, p)))};
    }
    const Frame frame(key_);
    for (std::size_t i = 0; i < key_rays_.size(); ++i) {
        key_rays_[i] = unit(key_ + kKeyRadius * (frame * disc_point(static_cast<int>(i))));
    }
}

Exposure Shading::exposure(const RayScene& scene, int x, int y, const Vec3& position, const Vec3& face,
                           const Vec3& smooth) const {
    const Vec3 origin = position + kOffSurface * face;
    const auto first = static_cast<std::size_t>(cell(x, y));
    const Frame frame(smooth);
    Exposure result{0, 0};
    for (std::size_t i = first * kSkyRays; i < (first + 1) * kSkyRays; ++i) {
        const Vec3 ray = frame * sky_rays_[i];
        // Rays that a smooth normal sends into the facet count as those that graze it.
        const double into = std::min(0.0, dot(ray, face));
        if (!scene.blocked(origin, ray - (2 * into) * face, kSkyReach)) result.sky += 1.0 / kSkyRays;
    }
    if (dot(smooth, key_) <= 0) return result;
    for (std::size_t i = first * kKeyRays; i < (first + 1) * kKeyRays; ++i) {
        const Vec3& ray = key_rays_[i];
        const double into = std::min(0.0, dot(ray, face) - 0.02);
        if (!scene.blocked(origin, ray - into * face, 1e3)) result.key += 1.0 / kKeyRays;
    }
    return result;
}

Vec3 Shading::surface(const Vec3& albedo, const Vec3& normal, const Vec3& view, const Exposure& exposure) const {
    const double key = kKeyLight * exposure.key * std::max(0.0, dot(normal, key_));
    const double up = (1 + normal.z) / 2;
    const Vec3 sky = kSkyLight * up * Vec3{0.97, 1.0, 1.05} + kGroundLight * (1 - up) * Vec3{1.05, 1, 0.95};
    const double facing = std::max(0.0, dot(normal, unit(key_ + view)));
    const double sheen = kSheen * exposure.key * std::pow(facing, kSheenPower);
    Vec3 colour;
    for (int c = 0; c < 3; ++c) {
        colour[c] = toned(albedo[c] * (key + sky[c] * handed_on(exposure.sky, albedo[c])) + sheen);
    }
    return colour;
}

Vec3 Shading::background(double x, double y) const {
    if (backdrop_ == Backdrop::white) return {1, 1, 1};
    const double across = 2 * x / camera_.width - 1, down = 2 * y / camera_.height - 1;
    const double off = std::min(1.0, (0.6 * across * across + (down - 0.1) * (down - 0.1)) / 1.6);
    return from_oklch(0.985 - 0.055 * off, 0.004 + 0.006 * off, 250);
}

Vec3 Shading::floor(const Vec3& background, const Exposure& exposure) const {
    const double light = 0.62 * handed_on(exposure.sky, 0.5) + 0.38 * exposure.key;
    const double shade = 1 - 0.6 * (1 - light);
    return {background.x * shade, background.y * shade, background.z * (shade + 0.03 * (1 - shade))};
}

}  // namespace spectralpack
