#pragma once
/// A picture with what is written over it, so that text stays sharp in print.

#include <string>

#include "formats/report/report.hpp"

namespace spectralpack {

/// `style`: its class. `label`: what it shows, for those who cannot see it.
std::string picture_svg(const SheetPicture& picture, const char* style, const std::string& label);

/// The numbers alone, `scale` units of the drawing to a pixel.
std::string number_texts(const SheetPicture& picture, double scale);

}  // namespace spectralpack
