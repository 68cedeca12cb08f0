#include "render/palette.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace spectralpack {
namespace {

struct Oklch {
    double lightness, chroma, hue;
};

// Neighbours in this order are far apart in hue; all are light enough to carry shading and an ink
// line.
constexpr std::array<Oklch, 12> kHues{{{0.70, 0.100, 238},
                                       {0.75, 0.115, 42},
                                       {0.79, 0.085, 168},
                                       {0.84, 0.115, 86},
                                       {0.69, 0.100, 292},
                                       {0.76, 0.100, 135},
                                       {0.73, 0.115, 14},
                                       {0.79, 0.075, 205},
                                       {0.79, 0.115, 64},
                                       {0.64, 0.110, 264},
                                       {0.82, 0.105, 112},
                                       {0.73, 0.100, 340}}};

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

bool in_gamut(const Vec3& c) { return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x <= 1 && c.y <= 1 && c.z <= 1; }

/// The fractional part of start + i step; with the steps below consecutive ones are far apart.
double spread(double start, int i, double step) { return std::fmod(start + i * step, 1.0); }

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

Vec3 copy_colour(int part, int copy, int parts) {
    const auto hues = static_cast<int>(kHues.size());
    Oklch colour = kHues[static_cast<std::size_t>(part % hues)];
    // Parts beyond the first dozen: the same round again, turned and a little lighter or darker.
    const int round = part / hues;
    colour.hue += 30 * spread(0, round, 0.618033988749895);
    colour.lightness += 0.10 * (spread(0.5, round, 0.754877666246693) - 0.5);
    const double width = std::min(52.0, std::max(20.0, 200.0 / std::max(1, parts)));
    colour.hue += width * (spread(0.5, copy, 0.618033988749895) - 0.5);
    colour.lightness += 0.13 * (spread(0.5, copy, 0.754877666246693) - 0.5);
    colour.chroma *= 1 + 0.3 * (spread(0.5, copy, 0.569840290998053) - 0.5);
    return from_oklch(colour.lightness, colour.chroma, colour.hue);
}

}  // namespace spectralpack
