#include "model/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spectralpack {
namespace {

struct Oklch {
    double lightness, chroma, hue;
};

// steel, amber, teal, coral, violet, lime, pink, sky, rust, mint, ink, sand, plum, green, lilac, slate
constexpr std::array<std::uint32_t, 16> kColours{0x69a3cb, 0xedc06b, 0x3e9790, 0xe7917a, 0x826bb3, 0xc7d787,
                                                 0xe496b5, 0x99d6e3, 0xa6603a, 0xa9e4ca, 0x48658b, 0xe5d6b6,
                                                 0x955b85, 0x609562, 0xcab7e3, 0x7d8792};
constexpr double kTurn = 19, kDarker = 0.05;                // of further rounds: degrees, each by more; lightness
constexpr double kHueSpread = 4, kLightnessSpread = 0.025;  // of a part's copies, to both sides

Vec3 unclipped(const Oklch& colour) {
    const double angle = colour.hue * std::numbers::pi / 180;
    const double a = colour.chroma * std::cos(angle), b = colour.chroma * std::sin(angle);
    const double l_root = colour.lightness + 0.3963377774 * a + 0.2158037573 * b;
    const double m_root = colour.lightness - 0.1055613458 * a - 0.0638541728 * b;
    const double s_root = colour.lightness - 0.0894841775 * a - 1.2914855480 * b;
    const double l = l_root * l_root * l_root, m = m_root * m_root * m_root, s = s_root * s_root * s_root;
    return {+4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

double to_linear(std::uint32_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Oklch to_oklch(std::uint32_t hex) {
    const double r = to_linear(hex >> 16 & 255), g = to_linear(hex >> 8 & 255), b = to_linear(hex & 255);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    const double across = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const double along = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, std::hypot(across, along),
            std::atan2(along, across) * 180 / std::numbers::pi};
}

bool in_gamut(const Vec3& c) { return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x <= 1 && c.y <= 1 && c.z <= 1; }

/// The fractional part of 0.5 + i step; with the steps below consecutive ones are far apart.
double spread(int i, double step) { return std::fmod(0.5 + i * step, 1.0); }

Oklch colour_of(int part) {
    const auto colours = static_cast<int>(kColours.size());
    Oklch colour = to_oklch(kColours[static_cast<std::size_t>(part % colours)]);
    const int round = part / colours;
    colour.hue += kTurn * round;
    if (round > 0) colour.lightness -= kDarker;
    return colour;
}

}  // namespace

Vec3 from_oklch(double lightness, double chroma, double hue) {
    Vec3 colour = unclipped({lightness, chroma, hue});
    if (!in_gamut(colour)) {
        double inside = 0, outside = chroma;
        for (int i = 0; i < 20; ++i) {
            const double middle = (inside + outside) / 2;
            (in_gamut(unclipped({lightness, middle, hue})) ? inside : outside) = middle;
        }
        colour = unclipped({lightness, inside, hue});
    }
    return max(Vec3{}, min(Vec3{1, 1, 1}, colour));
}

std::uint8_t to_srgb(double linear) {
    const double c = std::min(1.0, std::max(0.0, linear));
    const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(255 * encoded + 0.5);
}

Vec3 part_colour(int part) {
    const Oklch colour = colour_of(part);
    return from_oklch(colour.lightness, colour.chroma, colour.hue);
}

std::string part_colour_text(int part) {
    static constexpr char kDigits[] = "0123456789abcdef";
    const Vec3 colour = part_colour(part);
    std::string text = "#";
    for (int i = 0; i < 3; ++i) {
        const std::uint8_t byte = to_srgb(colour[i]);
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

Vec3 copy_colour(int part, int copy) {
    Oklch colour = colour_of(part);
    colour.hue += kHueSpread * (2 * spread(copy, 0.618033988749895) - 1);
    colour.lightness += kLightnessSpread * (2 * spread(copy, 0.754877666246693) - 1);
    return from_oklch(colour.lightness, colour.chroma, colour.hue);
}

}  // namespace spectralpack
