#include "render/marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/palette.hpp"
#include "scenes.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

using test::SmallScene;

/// Two cubes apart and a third behind them, of two parts.
SmallScene cubes() {
    SmallScene scene = test::empty_scene({90, 60, 40});
    const int small = scene.add_part(test::cube_mesh(20)), other = scene.add_part(test::cube_mesh(15));
    scene.packing.parts[0].count = 2;
    scene.place(small, {Mat3{}, {0, 0, 0}}, 0);
    scene.place(small, {Mat3{}, {60, 0, 0}}, 1);
    scene.place(other, {Mat3{}, {40, 40, 0}}, 0);
    return scene;
}

struct Drawn {
    Stage stage;
    Picture picture;
};

Drawn drawn(const SmallScene& scene, const View& view) {
    Drawn result{set_stage(scene.packing, scene.meshes, view), {}};
    RayMeshes meshes;
    meshes.add(result.stage.meshes, Workers(1));
    result.picture = paint(result.stage, meshes, 1, Workers(2));
    return result;
}

View top_view() {
    View view;
    view.lens = Lens::parallel;
    view.margin = 0;
    view.backdrop = Backdrop::white;
    view.outlines = false;
    view.options = {.width = 360, .height = 240, .azimuth = 0, .elevation = 90, .tray = 0};
    return view;
}

int seen_at(const Drawn& drawn, int x, int y) {
    return drawn.picture.seen[static_cast<std::size_t>(y * drawn.picture.image.width + x)];
}

TEST(Marks, TopViewsAreToScaleWithTheFrontBelow) {
    const Drawn view = drawn(cubes(), top_view());  // 4 pixels a millimetre
    EXPECT_EQ(seen_at(view, 40, 200), 0);
    EXPECT_EQ(seen_at(view, 280, 200), 1);
    EXPECT_EQ(seen_at(view, 190, 50), 2);
    EXPECT_LT(seen_at(view, 40, 40), 0);
    EXPECT_EQ(test::pixel(view.picture.image, 40, 40), (Vec3{255, 255, 255}));
}

TEST(Marks, NumbersStandOnTheirCopiesAndNotOnEachOther) {
    const Drawn view = drawn(cubes(), top_view());
    const auto places = number_places(view.stage, view.picture, {22, 22});
    ASSERT_EQ(places.size(), 3u);
    for (const NumberPlace& place : places) {
        EXPECT_EQ(seen_at(view, static_cast<int>(place.x), static_cast<int>(place.y)), place.copy);
        EXPECT_EQ(view.stage.copies[static_cast<std::size_t>(place.copy)].number, place.copy + 1);
    }
    EXPECT_TRUE(number_places(view.stage, view.picture, {200, 200}).empty());  // no room for such large ones
}

TEST(Marks, ASlabShowsWhatItHolds) {
    SmallScene scene = cubes();
    scene.place(0, {Mat3{}, {0, 0, 20}}, 2);  // on top of the first
    View view = top_view();
    view.slab = {0, 19.5};
    view.looks = {Look::strong, Look::pale, Look::gone, Look::strong};
    const Drawn slab = drawn(scene, view);
    EXPECT_EQ(seen_at(slab, 40, 200), 0);  // what stands on it is cut away
    EXPECT_LT(seen_at(slab, 190, 50), 0);
    const Vec3 strong = test::pixel(slab.picture.image, 40, 200), pale = test::pixel(slab.picture.image, 280, 200);
    EXPECT_GT(pale.x, strong.x + 30);
}

TEST(Marks, TheBarIsFiftyMillimetresLong) {
    View view = top_view();
    view.options.elevation = 30;
    view.options.azimuth = 20;
    view.margin = 0.1;
    const Stage stage = set_stage(cubes().packing, cubes().meshes, view);
    const PictureMarks marks = marks_of(stage);
    const double along = std::hypot(marks.bar.x1 - marks.bar.x0, marks.bar.y1 - marks.bar.y0);
    const PicturePoint a = stage.camera.project({0, 0, 0});
    const PicturePoint b = stage.camera.project({50 * stage.millimetre, 0, 0});
    EXPECT_NEAR(along, std::hypot(b.x - a.x, b.y - a.y), 1e-6);
    EXPECT_LT(marks.arrow.y1, marks.arrow.y0);
    std::vector<std::string> texts;
    for (const PictureText& text : marks.texts) {
        texts.push_back(text.text);
    }
    std::sort(texts.begin(), texts.end());
    EXPECT_EQ(texts, (std::vector<std::string>{"50 mm", "Z", "front", "right"}));
}

TEST(Marks, PicturesCarryThemUnlessTheyShallNot) {
    const SmallScene scene = cubes();
    RenderOptions options = test::small_picture(600, 450);
    const Image marked = test::picture(scene, options);
    options.marks = options.numbers = false;
    const Image plain = test::picture(scene, options);
    const auto dark = [](const Image& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            count += image.rgb[i] < 30 && image.rgb[i + 1] < 30 && image.rgb[i + 2] < 35;
        }
        return count;
    };
    EXPECT_GT(dark(marked), dark(plain) + 300);  // ink of bar, arrow and letters
}

/// How many pixels are about as blue as the first part, and not as the second.
int of_hue(const Image& image, int part) {
    const Vec3 mine = part_colour(part), other = part_colour(1 - part);
    int count = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const Vec3 c{std::pow(image.rgb[i] / 255.0, 2.2), std::pow(image.rgb[i + 1] / 255.0, 2.2),
                     std::pow(image.rgb[i + 2] / 255.0, 2.2)};
        if (length(c) < 0.05 || length(c) > 1.2) continue;
        const auto off = [&](const Vec3& colour) { return length(1 / length(c) * c - 1 / length(colour) * colour); };
        count += off(mine) < 0.2 && off(mine) < off(other);
    }
    return count;
}

TEST(Section, ShowsWhatIsInsideAndHatchesWhatItCuts) {
    SmallScene scene = test::empty_scene({60, 60, 60});
    const int shell = scene.add_part(test::box_mesh({0, 0, 0}, {60, 30, 60}));  // hides all behind it
    const int inner = scene.add_part(test::cube_mesh(20));
    scene.place(shell, {Mat3{}, {0, 0, 0}});
    scene.place(inner, {Mat3{}, {20, 35, 0}});
    RenderOptions options = test::small_picture(300, 300);
    options.azimuth = 0;
    options.elevation = 5;
    EXPECT_EQ(of_hue(test::picture(scene, options), inner), 0);
    options.section = Section{1, 32};
    const Image behind = test::picture(scene, options);
    EXPECT_EQ(of_hue(behind, shell), 0);
    EXPECT_GT(of_hue(behind, inner), 500);
    options.section = Section{1, 15};
    const Image cut = test::picture(scene, options);
    EXPECT_GT(of_hue(cut, shell), 3000);
    // Light and dark stripes along a line across the cut.
    int changes = 0;
    for (int x = 100; x < 200; ++x) {
        changes += std::abs(test::pixel(cut, x, 150).y - test::pixel(cut, x - 1, 150).y) > 8;
    }
    EXPECT_GT(changes, 10);
    options.section = Section{1, 90};
    EXPECT_THROW(test::picture(scene, options), UsageError);
}

TEST(Section, CutsMeshesThatAreInsideOutOrMirroredAlike) {
    SmallScene scene = test::empty_scene({40, 40, 40});
    const int part = scene.add_part(test::cube_mesh(40));
    Transform mirror;
    mirror.linear.rows[0] = -mirror.linear.rows[0];
    mirror.translation = {40, 0, 0};
    RenderOptions options = test::small_picture();
    options.section = Section{1, 20};
    const Image plain = [&] {
        SmallScene one = scene;
        one.place(part, {});
        return test::picture(one, options);
    }();
    SmallScene mirrored = scene, turned = scene;
    mirrored.place(part, mirror);
    turned.place(part, {});
    turned.meshes[0] = std::make_shared<const Mesh>(test::turned_inside_out(*turned.meshes[0]));
    EXPECT_EQ(test::picture(mirrored, options).rgb, plain.rgb);
    EXPECT_EQ(test::picture(turned, options).rgb, plain.rgb);
}

TEST(KeepOuts, AreHatchedAndHideNothing) {
    SmallScene scene = cubes();
    const RenderOptions options = test::small_picture(300, 225);
    const Image without = test::picture(scene, options);
    scene.packing.container.keep_out.push_back({{{20, 0, 0}, {60, 30, 30}}});
    const Image with = test::picture(scene, options);
    int darker = 0;
    for (std::size_t i = 0; i < with.rgb.size(); i += 3) {
        darker += with.rgb[i] + 10 < without.rgb[i];
    }
    EXPECT_GT(darker, 1000);
    View view;
    view.options = options;
    const Drawn seen = drawn(scene, view);
    for (int copy = 0; copy < 3; ++copy) {
        EXPECT_GT(std::count(seen.picture.seen.begin(), seen.picture.seen.end(), copy), 100) << copy;
    }
}

TEST(KeepOuts, AreHatchedInTopViewsWhereTheSlabCutsThem) {
    SmallScene scene = cubes();
    scene.packing.container.keep_out.push_back({{{25, 0, 0}, {55, 20, 40}}});
    View view = top_view();
    for (const auto& slab : {std::pair{0.0, 15.0}, {10.0, 20.0}, {15.0, 40.0}}) {
        view.slab = slab;
        const Drawn seen = drawn(scene, view);
        int darker = 0;
        for (int y = 170; y < 230; ++y) {
            for (int x = 110; x < 210; ++x) {
                darker += test::pixel(seen.picture.image, x, y).x < 250;
            }
        }
        EXPECT_GT(darker, 5000) << slab.first;  // of 6000: lines, and a shade between them
        EXPECT_EQ(test::pixel(seen.picture.image, 300, 60), (Vec3{255, 255, 255}));
    }
}

TEST(FixedCopies, HaveADottedOutline) {
    SmallScene scene = cubes();
    const RenderOptions options = test::small_picture(300, 225);
    const Image before = test::picture(scene, options);
    scene.packing.trays[0].placements[0].fixed = true;
    EXPECT_NE(test::picture(scene, options).rgb, before.rgb);
}

}  // namespace
}  // namespace spectralpack
