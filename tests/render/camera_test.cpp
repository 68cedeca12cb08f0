#include "render/camera.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "core/random.hpp"

namespace spectralpack {
namespace {

struct View {
    std::vector<Vec3> points;
    double azimuth, elevation;
    int width, height;

    Camera camera() const { return fit_camera(points, azimuth, elevation, width, height); }
};

View any_view(std::uint64_t seed) {
    RandomStream random(seed);
    const auto between = [&](double low, double high) { return low + (high - low) * random.unit(); };
    View view{{}, between(-360, 360), between(-90, 90), 100 + int(random.below(900)), 100 + int(random.below(900))};
    const Vec3 size{between(1, 500), between(1, 300), between(1, 200)};
    for (std::uint64_t i = 0; i < 2 + random.below(10); ++i) {
        view.points.push_back({between(-9, size.x), between(-7, size.y), between(-5, size.z)});
    }
    return view;
}

TEST(Camera, ProjectsAPointOfARayToItsPixelAndDepth) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        const Camera camera = any_view(seed).camera();
        RandomStream random(seed + 1);
        const double x = camera.width * random.unit(), y = camera.height * random.unit();
        const double depth = 1 + 100 * random.unit();
        const PicturePoint found = camera.project(camera.eye + depth * camera.ray(x, y));
        RC_ASSERT(std::abs(found.x - x) < 1e-6);
        RC_ASSERT(std::abs(found.y - y) < 1e-6);
        RC_ASSERT(std::abs(found.depth - depth) < 1e-9 * (1 + length(camera.eye)));
    }));
}

TEST(Camera, SeesEveryPointInTheMiddleAndCannotStandNearer) {
    EXPECT_TRUE(rc::check([](std::uint64_t seed) {
        const View view = any_view(seed);
        const Camera camera = view.camera();
        const auto margins = [&](const Camera& c) {  // left, right, top, bottom, as shares
            std::array<double, 4> least{1, 1, 1, 1};
            for (const Vec3& point : view.points) {
                const PicturePoint p = c.project(point);
                RC_ASSERT(p.depth > 0);
                const double x = p.x / c.width, y = p.y / c.height;
                const std::array<double, 4> here{x, 1 - x, y, 1 - y};
                for (std::size_t i = 0; i < 4; ++i) {
                    least[i] = std::min(least[i], here[i]);
                }
            }
            return least;
        };
        const auto fitted = margins(camera);
        RC_ASSERT(std::abs(fitted[0] - fitted[1]) < 1e-9);
        RC_ASSERT(std::abs(fitted[2] - fitted[3]) < 1e-9);
        RC_ASSERT(*std::min_element(fitted.begin(), fitted.end()) > 0.05);

        double first = 1e9, last = -1e9;
        for (const Vec3& point : view.points) {
            const double depth = camera.project(point).depth;
            first = std::min(first, depth);
            last = std::max(last, depth);
        }
        RC_ASSERT(first >= 0.5 * (last - first) - 1e-9);
        if (first < 0.5 * (last - first) + 1e-6) return;  // stands back for the sake of perspective

        Camera nearer = camera;
        nearer.eye = nearer.eye + 1e-3 * camera.forward;
        const auto tighter = margins(nearer);
        RC_ASSERT(*std::min_element(tighter.begin(), tighter.end()) < *std::min_element(fitted.begin(), fitted.end()));
    }));
}

TEST(Camera, StandsWhereItsAnglesSay) {
    const std::vector<Vec3> points{{-1, -1, -1}, {1, 1, 1}};
    const auto close = [](const Vec3& a, const Vec3& b) { return length(a - b) < 1e-12; };
    EXPECT_TRUE(close(fit_camera(points, 0, 0, 80, 60).forward, {0, 1, 0}));
    EXPECT_TRUE(close(fit_camera(points, 90, 0, 80, 60).forward, {-1, 0, 0}));
    const Camera above = fit_camera(points, 0, 90, 80, 60);
    EXPECT_TRUE(close(above.forward, {0, 0, -1}));
    EXPECT_TRUE(close(above.up, {0, 1, 0}));
    EXPECT_GT(fit_camera(points, 35, 28, 80, 60).eye.z, 0);
    EXPECT_GT(fit_camera(points, 35, 28, 80, 60).up.z, 0);
}

}  // namespace
}  // namespace spectralpack
