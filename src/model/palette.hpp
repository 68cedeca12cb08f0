#pragma once
/// Colours of parts and copies, the same in pictures and on the operator's sheet. Chosen in OKLCH (Ottosson, "A
/// perceptual color space for image processing", 2020), where equal steps look equal.

#include <cstdint>
#include <string>

#include "spectralpack/geometry.hpp"

namespace spectralpack {

/// Linear sRGB, each in [0, 1]; `lightness` in [0, 1], `hue` in degrees. Colours beyond the
/// screen's gamut lose chroma until they are in it.
Vec3 from_oklch(double lightness, double chroma, double hue);

/// A linear intensity as an sRGB byte; out of range is clamped.
std::uint8_t to_srgb(double linear);

/// The colour of a part by its place in the part list (linear sRGB). Consecutive ones differ in hue and lightness, also
/// to eyes that cannot tell red from green. From the 17th on the round starts again, turned and darker.
Vec3 part_colour(int part);

/// That colour for style sheets: "#69a3cb".
std::string part_colour_text(int part);

/// A copy's own shade of its part's colour (linear sRGB).
Vec3 copy_colour(int part, int copy);

}  // namespace spectralpack
