#pragma once
/// What is written into pictures, and where: a scale bar, the z arrow, the sides' names, the copies' numbers.

#include <span>
#include <string>
#include <vector>

#include "render/stage.hpp"
#include "render/tile_painter.hpp"

namespace spectralpack {

struct PictureLine {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< pixels
};

struct PictureText {
    double x = 0, y = 0;  ///< of its middle
    std::string text;
};

struct PictureMarks {
    PictureLine bar, arrow;  ///< the arrow points to its second end
    std::vector<PictureText> texts;
};

/// Of the first tray: a bar of 50 mm (less beside small trays) along its lower front, an arrow up, and the names of the
/// two sides that the camera sees.
PictureMarks marks_of(const Stage& stage);

/// A copy's number where the copy can be seen.
struct NumberPlace {
    int copy = 0;  ///< index into Stage::copies
    double x = 0, y = 0;
};

struct NumberSizes {
    double strong = 24, pale = 24;  ///< heights of text, pixels
};

/// Places for the numbers of those copies that have room for it, none over another: the largest areas in sight first,
/// strong ones before pale ones.
std::vector<NumberPlace> number_places(const Stage& stage, const Picture& picture, const NumberSizes& sizes);

void draw_marks(const PictureMarks& marks, Image& image);
void draw_numbers(const Stage& stage, Picture& picture);

}  // namespace spectralpack
