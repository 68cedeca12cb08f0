#pragma once
/// Lines and text in pictures, in dark ink; text with a white rim.

#include "render/marks.hpp"

namespace spectralpack {

struct TextStyle {
    double size = 24;  ///< height of a line, pixels
    double rim = 0.2;  ///< white round each letter, of the size
};

void draw_line(Image& image, const PictureLine& line, double width);

/// Letters, digits, space and full stop; anything else is left out.
void draw_text(Image& image, const PictureText& text, const TextStyle& style);

}  // namespace spectralpack
