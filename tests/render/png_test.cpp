#include <gtest/gtest.h>
#include <png.h>

#include <fstream>
#include <iterator>

#include "core/random.hpp"
#include "render/render.hpp"
#include "spectralpack/error.hpp"
#include "support/process.hpp"

namespace spectralpack {
namespace {

Image noise(int width, int height) {
    Image image{width, height, {}};
    RandomStream random(3);
    for (int i = 0; i < 3 * width * height; ++i) {
        image.rgb.push_back(static_cast<std::uint8_t>(random.next()));
    }
    return image;
}

Image read_back(const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, path.c_str())) return {};
    EXPECT_EQ(png.format & PNG_FORMAT_FLAG_ALPHA, 0u);
    png.format = PNG_FORMAT_RGB;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) return {};
    return image;
}

TEST(Png, HoldsEveryPixel) {
    const test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {37, 5}, {5, 37}, {200, 150}}) {
        const Image image = noise(width, height);
        write_png(image, folder / "a.png");
        const Image back = read_back(folder / "a.png");
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.rgb, image.rgb);
    }
}

TEST(Png, ReplacesAFileAndLeavesNothingBeside) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.png") << "older";
    write_png(noise(9, 7), folder / "a.png");
    write_png(noise(9, 7), folder / "b.png");
    EXPECT_EQ(test::read_text(folder / "a.png"), test::read_text(folder / "b.png"));
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

TEST(Png, SaysWhereItCannotBeWritten) {
    const test::TemporaryFolder folder;
    try {
        write_png(noise(2, 2), folder / "missing/a.png");
        FAIL() << "written into a folder that is not there";
    } catch (const ResourceError& error) {
        EXPECT_NE(std::string(error.what()).find("missing/a.png"), std::string::npos);
    }
}

}  // namespace
}  // namespace spectralpack
