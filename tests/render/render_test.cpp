#include "render/render.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>

#include "render/outline.hpp"
#include "render/ray_scene.hpp"
#include "render/stage.hpp"
#include "scenes.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

using test::picture;
using test::pixel;
using test::small_picture;
using test::SmallScene;

/// Which copy the middle of each pixel sees.
std::vector<int> copies_seen(const SmallScene& scene, const RenderOptions& options) {
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    const test::StageRays held(stage);
    const RayScene& rays = held.rays;
    std::vector<int> seen;
    for (int y = 0; y < options.height; ++y) {
        for (int x = 0; x < options.width; ++x) {
            seen.push_back(rays.first(stage.camera.eye, stage.camera.ray(x + 0.5, y + 0.5)).copy);
        }
    }
    return seen;
}

TEST(Render, GivesTheSameBytesForAnyNumberOfThreads) {
    const SmallScene scene = test::varied_scene();
    const Image one = picture(scene, small_picture(), 1);
    for (const int threads : {2, 7}) {
        EXPECT_EQ(picture(scene, small_picture(), threads).rgb, one.rgb) << threads;
    }
}

TEST(Render, HasTheSizeAskedFor) {
    const SmallScene scene = test::varied_scene();
    for (const auto& [width, height] : {std::pair{1, 1}, {64, 64}, {65, 130}, {131, 7}}) {
        for (const int samples : {1, 2, 5}) {
            RenderOptions options = small_picture(width, height);
            options.samples = samples;
            const Image image = picture(scene, options);
            EXPECT_EQ(image.width, width);
            EXPECT_EQ(image.height, height);
            EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * width * height));
        }
    }
}

TEST(Render, WithoutTimeItDrawsPlainlyAndWhole) {
    const SmallScene scene = test::varied_scene();
    RenderOptions options = small_picture();
    options.samples = 3;
    StopSource hurry;
    const Image fine = render(scene.packing, scene.meshes, options, Workers(2), {hurry.token(), {}});
    EXPECT_EQ(fine.rgb, picture(scene, options).rgb) << "there is time";
    hurry.request(StopReason::time_limit);
    const Image plain = render(scene.packing, scene.meshes, options, Workers(2), {hurry.token(), {}});
    ASSERT_EQ(plain.rgb.size(), fine.rgb.size());
    EXPECT_NE(plain.rgb, fine.rgb);
    double difference = 0;
    for (std::size_t i = 0; i < fine.rgb.size(); ++i) {
        difference += std::abs(plain.rgb[i] - fine.rgb[i]);
    }
    EXPECT_LT(difference / static_cast<double>(fine.rgb.size()), 25) << "of 255: the same picture without shadows";
}

TEST(Render, ShowsEveryCopyInItsPixelsAndOnlyThere) {
    const SmallScene scene = test::varied_scene();
    const RenderOptions options = small_picture();
    const Image with_all = picture(scene, options);
    const std::vector<int> seen = copies_seen(scene, options);
    const auto count = static_cast<int>(scene.packing.trays[0].placements.size());
    for (int copy = 0; copy < count; ++copy) {
        SmallScene without = scene;
        auto& placements = without.packing.trays[0].placements;
        placements.erase(placements.begin() + copy);
        const Image image = picture(without, options);
        int changed = 0, own = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (seen[i] != copy) continue;
            ++own;
            if (!std::equal(&image.rgb[3 * i], &image.rgb[3 * i + 3], &with_all.rgb[3 * i])) ++changed;
        }
        EXPECT_GT(own, 20) << "the scene hides copy " << copy;
        EXPECT_EQ(changed, own) << copy;
        // The bottom right corner is far from everything, also from shadows.
        EXPECT_EQ(pixel(image, 199, 149), pixel(with_all, 199, 149));
    }
}

/// Colour without brightness.
Vec3 tint(const Vec3& c) { return 1 / (c.x + c.y + c.z + 1e-9) * c; }

TEST(Render, ShowsEachCopyInItsColour) {
    const SmallScene scene = test::varied_scene();
    const RenderOptions options = small_picture(400, 300);
    const Image image = picture(scene, options);
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    const std::vector<int> seen = copies_seen(scene, options);
    const auto parts = scene.packing.parts.size();
    for (std::size_t part = 0; part < parts; ++part) {
        Vec3 sum;  // of both copies
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const int copy = seen[static_cast<std::size_t>(y * image.width + x)];
                if (copy < 0 || static_cast<std::size_t>(copy) % parts != part) continue;
                Vec3 c = pixel(image, x, y);
                for (int i = 0; i < 3; ++i) {
                    c[i] = std::pow(c[i] / 255, 2.2);
                }
                sum = sum + c;
            }
        }
        std::size_t nearest = 0;
        const auto off = [&](std::size_t other) {
            return length(tint(sum) - tint(stage.copies[other].colour + stage.copies[other + parts].colour));
        };
        for (std::size_t other = 1; other < parts; ++other) {
            if (off(other) < off(nearest)) nearest = other;
        }
        EXPECT_EQ(nearest, part);
    }
}

TEST(Render, OutlinesTheContainer) {
    const SmallScene scene = test::empty_scene();
    const RenderOptions options = small_picture(400, 300);
    const Image image = picture(scene, options);
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    const auto edges = Outline(stage).near(0, 0, options.width, options.height);
    ASSERT_EQ(edges.size(), 12u);
    const auto darkness = [&](double x, double y) {
        return 255 - pixel(image, static_cast<int>(x), static_cast<int>(y)).y;
    };
    for (const Outline::Edge& edge : edges) {
        const double dx = edge.to.x - edge.from.x, dy = edge.to.y - edge.from.y, size = std::hypot(dx, dy);
        for (const double t : {0.23, 0.41, 0.77}) {
            const double x = edge.from.x + t * dx, y = edge.from.y + t * dy;
            double on_line = 0;
            for (int k = -1; k <= 1; ++k) {
                on_line = std::max(on_line, darkness(x - k * dy / size, y + k * dx / size));
            }
            EXPECT_GT(on_line, 25 + darkness(x + 5 * dy / size, y - 5 * dx / size));
        }
    }
}

TEST(Render, DashesEdgesThatCopiesHide) {
    SmallScene scene = test::empty_scene();
    scene.place(scene.add_part(test::box_mesh({1, 1, 1}, {89, 59, 39})), {});
    const RenderOptions options = small_picture(400, 300);
    const Stage stage = set_stage(scene.packing, scene.meshes, {options});
    const Outline outline(stage);
    const test::StageRays held(stage);
    const RayScene& rays = held.rays;
    int hidden = 0;
    for (const Outline::Edge& edge : outline.near(0, 0, options.width, options.height)) {
        const double x = (edge.from.x + edge.to.x) / 2, y = (edge.from.y + edge.to.y) / 2;
        const double in_front = outline.opacity(edge, x, y, 1e9);
        EXPECT_GT(in_front, 0.4);
        std::set<double> behind;
        for (int i = 1; i < 100; ++i) {
            const double t = i / 100.0;
            behind.insert(outline.opacity(edge, edge.from.x + t * (edge.to.x - edge.from.x),
                                          edge.from.y + t * (edge.to.y - edge.from.y), 0.1));
        }
        EXPECT_EQ(behind.size(), 2u);
        EXPECT_EQ(*behind.begin(), 0.0);
        EXPECT_LT(*behind.rbegin(), in_front);
        const RayHit hit = rays.first(stage.camera.eye, stage.camera.ray(x, y));
        if (hit.copy >= 0 && outline.opacity(edge, x, y, hit.at) < in_front) ++hidden;
    }
    EXPECT_EQ(hidden, 3);  // those at the far lower corner
}

TEST(Render, ShowsAnEmptyPackingWithOrWithoutATray) {
    SmallScene scene = test::empty_scene();
    const Image no_tray = picture(scene);
    scene.packing.trays.resize(1);
    EXPECT_EQ(picture(scene).rgb, no_tray.rgb);
    EXPECT_GT(std::set<std::uint8_t>(no_tray.rgb.begin(), no_tray.rgb.end()).size(), 20u);
}

TEST(Render, DoesNotDependOnTheOrderOfPlacements) {
    SmallScene scene = test::varied_scene();
    const Image image = picture(scene);
    std::reverse(scene.packing.trays[0].placements.begin(), scene.packing.trays[0].placements.end());
    EXPECT_EQ(picture(scene).rgb, image.rgb);
}

TEST(Render, DoesNotDependOnTheUnit) {
    const SmallScene scene = test::varied_scene();
    const Image image = picture(scene);
    for (const double scale : {0x1p-30, 0x1p30}) {  // powers of two: no digit changes
        SmallScene scaled = scene;
        scaled.packing.container.size = scale * scaled.packing.container.size;
        for (Placement& placement : scaled.packing.trays[0].placements) {
            placement.transform = Transform{scale * Mat3{}, {}} * placement.transform;
        }
        EXPECT_EQ(picture(scaled).rgb, image.rgb) << scale;
    }
}

TEST(Render, ShowsInsideOutMeshesAsTheOthers) {
    SmallScene scene = test::varied_scene();
    const Image image = picture(scene);
    for (auto& mesh : scene.meshes) {
        mesh = std::make_shared<const Mesh>(test::turned_inside_out(*mesh));
    }
    const Image turned = picture(scene);
    // Corners come in another order, so sums may differ in the last bit: one step in what is drawn
    // and one more, with some compilers, in the average over its neighbours.
    int most = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        most = std::max(most, std::abs(int{image.rgb[i]} - int{turned.rgb[i]}));
    }
    EXPECT_LE(most, 2);
}

TEST(Render, ThrowsAShadowOnTheFloorBesideACopy) {
    SmallScene scene = test::empty_scene();
    const RenderOptions options = small_picture();
    const Image bare = picture(scene, options);
    scene.place(scene.add_part(test::box_mesh({35, 20, 0}, {55, 40, 30})), {});
    const Image image = picture(scene, options);
    const std::vector<int> seen = copies_seen(scene, options);
    int darker = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i] < 0 && image.rgb[3 * i] + 3 < bare.rgb[3 * i]) ++darker;
    }
    EXPECT_GT(darker, 300);
    const RenderOptions from_below = [&] {
        RenderOptions low = options;
        low.elevation = -20;
        return low;
    }();
    EXPECT_EQ(pixel(picture(scene, from_below), 10, 140), pixel(bare, 10, 140));
}

TEST(Render, RefusesOptionsThatMakeNoSense) {
    const SmallScene scene = test::empty_scene();
    const auto with = [](auto change) {
        RenderOptions options = small_picture();
        change(options);
        return options;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const RenderOptions& options :
         {with([](auto& o) { o.width = 0; }), with([](auto& o) { o.height = -1; }),
          with([](auto& o) { o.width = 1 << 30; }), with([](auto& o) { o.samples = 0; }),
          with([](auto& o) { o.samples = 100; }), with([](auto& o) { o.elevation = 91; }),
          with([&](auto& o) { o.elevation = nan; }), with([&](auto& o) { o.azimuth = nan; }),
          with([](auto& o) { o.tray = 1; }), with([](auto& o) { o.tray = -2; })}) {
        EXPECT_THROW(picture(scene, options), UsageError);
    }
}

}  // namespace
}  // namespace spectralpack
