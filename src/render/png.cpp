#include <png.h>

#include <string>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "render/render.hpp"

namespace spectralpack {

void write_png(const Image& image, const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    // Written to memory so that the file appears whole or not at all, whatever goes wrong.
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    const bool done =
        png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) != 0;
    if (!done) throw ResourceError("cannot write " + path.string() + ": " + png.message);
    bytes.resize(size);
    replace_file(path, bytes);
}

}  // namespace spectralpack
