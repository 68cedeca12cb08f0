#pragma once
/// Plots as SVG.

#include <string>
#include <utility>
#include <vector>

namespace spectralpack::tools {

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< x ascending, y above 0
};

/// Lines over one another, y on a logarithmic scale. Empty where there is nothing to draw.
std::string svg_plot(const std::vector<Curve>& curves, const std::string& x_label, const std::string& y_label);

}  // namespace spectralpack::tools
