#include "tools/bench/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spectralpack::tools {
namespace {

constexpr double kWidth = 720, kHeight = 400, kLeft = 64, kRight = 16, kTop = 16, kBottom = 44;
constexpr std::array kColours{"#1f6f8b", "#c8553d", "#5b8c3e", "#6c4f9e", "#a67c00", "#555555"};
constexpr int kTicks = 5;  // on the x axis

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<') {
            safe += "&lt;";
        } else if (c == '&') {
            safe += "&amp;";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace

std::string svg_plot(const std::vector<Curve>& curves, const std::string& x_label, const std::string& y_label) {
    double most_x = 0, least_y = 1e300, most_y = 0;
    for (const Curve& curve : curves) {
        for (const auto& [x, y] : curve.points) {
            most_x = std::max(most_x, x);
            least_y = std::min(least_y, y);
            most_y = std::max(most_y, y);
        }
    }
    if (!(most_x > 0)) return "";
    const double low = std::floor(std::log10(least_y)), high = std::max(low + 1, std::ceil(std::log10(most_y)));
    const auto at_x = [&](double x) { return kLeft + (kWidth - kLeft - kRight) * x / most_x; };
    const auto at_y = [&](double y) {
        return kTop + (kHeight - kTop - kBottom) * (high - std::log10(y)) / (high - low);
    };

    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        kWidth, kHeight);
    for (double power = low; power <= high; ++power) {
        const double y = at_y(std::pow(10, power));
        svg += fmt::format(
            "<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n",
            kLeft, y, kWidth - kRight, kLeft - 6, y + 4, std::pow(10, power));
    }
    for (int tick = 0; tick < kTicks; ++tick) {
        const double x = std::round(most_x * tick / (kTicks - 1));
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>\n", at_x(x),
                           kHeight - kBottom + 16, x);
    }
    svg += fmt::format(
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
        "<text x=\"14\" y=\"{}\" text-anchor=\"middle\" transform=\"rotate(-90 14 {})\">{}</text>\n",
        kWidth / 2, kHeight - 8, escaped(x_label), kHeight / 2, kHeight / 2, escaped(y_label));
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const char* colour = kColours[k % kColours.size()];
        svg += "<polyline points=\"";
        for (const auto& [x, y] : curves[k].points) {
            svg += fmt::format("{:.1f},{:.1f} ", at_x(x), at_y(y));
        }
        svg += fmt::format(
            "\" fill=\"none\" stroke=\"{0}\" stroke-width=\"1.5\"/>\n"
            "<text x=\"{1}\" y=\"{2}\" text-anchor=\"end\" fill=\"{0}\">{3}</text>\n",
            colour, kWidth - kRight - 8, kTop + 16 * static_cast<double>(k + 1), escaped(curves[k].name));
    }
    return svg + "</svg>\n";
}

}  // namespace spectralpack::tools
