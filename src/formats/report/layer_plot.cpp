#include <algorithm>
#include <cmath>

#include "formats/report/pages.hpp"

namespace spectralpack {
namespace {

// In units of the drawing, of which 55 are the width of the column, 50 mm.
constexpr double kMillimetre = 55.0 / 50, kWidth = 31, kCutEnd = 40, kLetter = 6.4;

/// Round steps up the axis: about three of them.
double step_for(double size) {
    for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
        if (size / step <= 4) return step;
    }
    return 1000;
}

}  // namespace

std::string layer_plot(const SheetInput& sheet, std::size_t index, double height) {
    const TrayPacking& tray = sheet.packing.trays[index];
    const std::vector<double>& area = tray.layers.area;
    const Vec3& size = sheet.packing.container.size;
    const double plot = std::clamp(height * kMillimetre - 12, 30.0, 146.0), floor_area = size.x * size.y;
    const double up = plot / std::max(size.z, tray.height);  // units a millimetre
    double most = 0;
    for (const double layer : area) {
        most = std::max(most, layer / floor_area);
    }
    const double full = std::max(0.1, std::ceil(most * 10 - 1e-9) / 10);  // the scale ends on a full 10 %
    Html html;
    html.add("<svg viewBox=\"-9 -4 55 {:.1f}\" class=\"lay\" role=\"img\" aria-label=\"Filled area of each layer\">",
             plot + 12);
    for (int i = 0; i <= 2; ++i) {
        html.add(
            "<path d=\"M{0:g} 0V{1:.1f}\" class=\"grid\"/><text x=\"{0:g}\" y=\"{2:.1f}\" class=\"axm\" "
            "text-anchor=\"middle\">{3:g}{4}</text>",
            kWidth * i / 2, plot, plot + 4.6, 50 * full * i, i == 2 ? "\u202f%" : "");
    }
    html.add("<path d=\"M0 {:.1f}", plot);
    for (std::size_t i = 0; i < area.size(); ++i) {
        const double top = std::max(0.0, plot - up * tray.layers.thickness * static_cast<double>(i + 1));
        html.add("H{:.2f}V{:.2f}", kWidth * std::clamp(area[i] / floor_area / full, 0.0, 1.0), top);
    }
    html.add("H0Z\" class=\"area\"/>");
    const double step = step_for(size.z);
    for (double at = 0; at <= size.z + 1e-9; at += step) {
        html.add("<text x=\"-1.6\" y=\"{:.1f}\" class=\"axm\" text-anchor=\"end\">{:g}</text>", plot - up * at + 1.2,
                 at);
    }
    const std::vector<Slab>& slabs = sheet.contents.layout[index].slabs;
    for (std::size_t i = 0; i < slabs.size(); ++i) {
        const double low = plot - up * slabs[i].low, middle = plot - up * (slabs[i].low + slabs[i].high) / 2;
        if (i + 1 < slabs.size()) html.add("<path d=\"M0 {:.2f}H{:g}\" class=\"cut\"/>", low, kCutEnd);
        const double letter = std::min(kLetter, 0.9 * up * (slabs[i].high - slabs[i].low));
        html.add(
            "<rect x=\"{0:.2f}\" y=\"{1:.2f}\" width=\"{2:.2f}\" height=\"{2:.2f}\" rx=\"1.2\" class=\"lbx\"/>"
            "<text x=\"38.2\" y=\"{3:.2f}\" font-size=\"{4:.2f}\" class=\"lbl\" text-anchor=\"middle\">{5}</text>",
            38.2 - letter / 2, middle - letter / 2, letter, middle + 0.24 * letter, 0.69 * letter, slab_name(i));
    }
    html.add("<path d=\"M-2 {:.2f}H{:g}\" class=\"top\"/></svg>\n", plot - up * tray.height, kCutEnd);
    return html.take();
}

}  // namespace spectralpack
