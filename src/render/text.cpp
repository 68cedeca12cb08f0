#include "render/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// A single header whose functions we do not all use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wcast-qual"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

#include "model/palette.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// DejaVu Sans Bold, letters and digits only (src/render/font/README.md).
constexpr unsigned char kFont[] = {
#include <label_font.inc>  // made by CMake
};

constexpr std::array<std::uint8_t, 3> kInk{0x11, 0x15, 0x1a}, kWhite{255, 255, 255};

const stbtt_fontinfo& font() {
    static const stbtt_fontinfo info = [] {
        stbtt_fontinfo made;
        if (stbtt_InitFont(&made, kFont, 0) == 0) throw InternalError("the font of pictures cannot be read");
        return made;
    }();
    return info;
}

void blend(Image& image, int x, int y, const std::array<std::uint8_t, 3>& colour, double share) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    std::uint8_t* at = &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(x))];
    for (std::size_t i = 0; i < 3; ++i) {
        at[i] = static_cast<std::uint8_t>(std::lround((1 - share) * at[i] + share * colour[i]));
    }
}

/// How much of each pixel a text covers, with room round it for the rim.
struct Coverage {
    int width = 0, height = 0;
    std::vector<float> share;
    float& at(int x, int y) { return share[static_cast<std::size_t>(y * width + x)]; }
    float at(int x, int y) const { return share[static_cast<std::size_t>(y * width + x)]; }
};

Coverage cover(const std::string& text, double size, int rim) {
    const stbtt_fontinfo& info = font();
    const float scale = stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
    int digit_x0, digit_y0, digit_x1, digit_y1;
    stbtt_GetCodepointBox(&info, '0', &digit_x0, &digit_y0, &digit_x1, &digit_y1);
    const auto height = static_cast<int>(std::ceil(scale * static_cast<float>(digit_y1)));
    float length = 0;
    for (const char c : text) {
        int advance, bearing;
        stbtt_GetCodepointHMetrics(&info, c, &advance, &bearing);
        length += scale * static_cast<float>(advance);
    }
    const int below = height / 3;  // what hangs under the line
    Coverage result{static_cast<int>(std::ceil(length)) + 2 * rim + 2, height + 2 * (rim + below), {}};
    result.share.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
    float pen = static_cast<float>(rim) + 1;
    for (const char c : text) {
        int advance, bearing, width = 0, rows = 0, left = 0, top = 0;
        stbtt_GetCodepointHMetrics(&info, c, &advance, &bearing);
        const float whole = std::floor(pen);
        unsigned char* bitmap =
            stbtt_GetCodepointBitmapSubpixel(&info, scale, scale, pen - whole, 0, c, &width, &rows, &left, &top);
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < width; ++x) {
                const int px = static_cast<int>(whole) + left + x, py = rim + below + height + top + y;
                if (px < 0 || py < 0 || px >= result.width || py >= result.height) continue;
                result.at(px, py) = std::max(result.at(px, py), static_cast<float>(bitmap[y * width + x]) / 255);
            }
        }
        stbtt_FreeBitmap(bitmap, nullptr);
        pen += scale * static_cast<float>(advance);
    }
    return result;
}

}  // namespace

void draw_text(Image& image, const PictureText& text, const TextStyle& style) {
    const double reach = style.rim * style.size / 2 + 0.5;
    const auto rim = static_cast<int>(std::ceil(reach));
    const Coverage letters = cover(text.text, style.size, rim);
    const auto left = static_cast<int>(std::lround(text.x - letters.width / 2.0));
    const auto top = static_cast<int>(std::lround(text.y - letters.height / 2.0));
    for (int y = 0; y < letters.height; ++y) {
        for (int x = 0; x < letters.width; ++x) {
            double white = 0;
            for (int dy = -rim; dy <= rim; ++dy) {
                for (int dx = -rim; dx <= rim; ++dx) {
                    const int nx = x + dx, ny = y + dy;
                    if (nx < 0 || ny < 0 || nx >= letters.width || ny >= letters.height) continue;
                    const double within = std::clamp(reach + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
                    white = std::max(white, within * static_cast<double>(letters.at(nx, ny)));
                }
            }
            blend(image, left + x, top + y, kWhite, white);
        }
    }
    for (int y = 0; y < letters.height; ++y) {
        for (int x = 0; x < letters.width; ++x) {
            blend(image, left + x, top + y, kInk, static_cast<double>(letters.at(x, y)));
        }
    }
}

void draw_line(Image& image, const PictureLine& line, double width) {
    const double dx = line.x1 - line.x0, dy = line.y1 - line.y0, length = std::hypot(dx, dy);
    if (!(length > 0)) return;
    const double reach = width / 2 + 1;
    const auto [left, right] = std::minmax(line.x0, line.x1);
    const auto [top, bottom] = std::minmax(line.y0, line.y1);
    for (int y = static_cast<int>(top - reach); y <= static_cast<int>(bottom + reach); ++y) {
        for (int x = static_cast<int>(left - reach); x <= static_cast<int>(right + reach); ++x) {
            const double px = x + 0.5 - line.x0, py = y + 0.5 - line.y0;
            const double t = std::clamp((px * dx + py * dy) / (length * length), 0.0, 1.0);
            const double off = std::hypot(px - t * dx, py - t * dy);
            blend(image, x, y, kInk, std::clamp(width / 2 + 0.5 - off, 0.0, 1.0));
        }
    }
}

}  // namespace spectralpack
