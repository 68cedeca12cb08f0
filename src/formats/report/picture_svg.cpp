#include "formats/report/picture_svg.hpp"

#include "formats/report/html.hpp"

namespace spectralpack {

std::string number_texts(const SheetPicture& picture, double scale) {
    constexpr double kBelowMiddle = 0.36;  // of the text's height: its line
    Html html;
    for (const SheetPicture::Number& number : picture.numbers) {
        const double size = (number.strong ? kNumberSize : kPaleNumberSize) * picture.millimetre * scale;
        html.add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.2f}\" class=\"no{}\">{}</text>", number.x * scale,
                 number.y * scale + kBelowMiddle * size, size, number.strong ? "" : " thin", number.number);
    }
    return html.take();
}

std::string picture_svg(const SheetPicture& picture, const char* style, const std::string& label) {
    constexpr double kNameSize = 2.6, kBar = 0.7, kArrow = 0.4, kHead = 2;  // mm in print
    if (picture.png.empty()) return "<em>left out for time</em>";
    const double mm = picture.millimetre;
    Html html;
    html.add(
        "<svg viewBox=\"0 0 {0:g} {1:g}\" class=\"{2}\" role=\"img\" aria-label=\"{3}\"><image href=\"{4}\" "
        "width=\"{0:g}\" height=\"{1:g}\"/>",
        picture.width, picture.height, style, escaped(label), picture_link(picture.png));
    html.add("{}", number_texts(picture, 1));
    if (picture.bar) {
        html.add("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"bar\" stroke-width=\"{:.2f}\"/>", picture.bar->x0,
                 picture.bar->y0, picture.bar->x1, picture.bar->y1, kBar * mm);
    }
    if (picture.arrow) {
        const SheetPicture::Line& arrow = *picture.arrow;
        html.add(
            "<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}m{4:.1f} {5:.1f}l{6:.1f} -{5:.1f}l{6:.1f} {5:.1f}\" class=\"zar\" "
            "stroke-width=\"{7:.2f}\"/>",
            arrow.x0, arrow.y0, arrow.x1, arrow.y1, -kHead / 2 * mm, kHead * mm, kHead / 2 * mm, kArrow * mm);
    }
    for (const SheetPicture::Text& text : picture.texts) {
        html.add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" class=\"ax\">{}</text>", text.x,
                 text.y + 0.36 * kNameSize * mm, kNameSize * mm, escaped(text.text));
    }
    html.add("</svg>");
    return html.take();
}

}  // namespace spectralpack
