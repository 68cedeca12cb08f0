#include <png.h>

#include <string>

#include "core/atomic_file.hpp"
#include "render/render.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

std::string encode_png(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    const bool done = png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) != 0;
    if (!done) throw ResourceError(std::string("cannot make a PNG: ") + png.message);
    bytes.resize(size);
    return bytes;
}

void write_png(const Image& image, const std::filesystem::path& path) {
    replace_file(path, encode_png(image));  // appears whole or not at all
}

}  // namespace spectralpack
