#pragma once
/// Colours of copies, chosen in OKLCH (Ottosson, "A perceptual color space for image processing",
/// 2020), where equal steps look equal.

#include <cstdint>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// Linear sRGB, each in [0, 1]; `lightness` in [0, 1], `hue` in degrees. Colours beyond the
/// screen's gamut lose chroma until they are in it.
Vec3 from_oklch(double lightness, double chroma, double hue);

/// A linear intensity as an sRGB byte; out of range is clamped.
std::uint8_t to_srgb(double linear);

/// The colour of a copy (linear sRGB): its part's hue, its own shade. `parts` is how many parts
/// share the picture: the fewer, the further the shades of one may spread.
Vec3 copy_colour(int part, int copy, int parts);

}  // namespace spectralpack
