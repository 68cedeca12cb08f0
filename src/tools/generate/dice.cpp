#include "tools/generate/dice.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace spectralpack::tools {

double Dice::mm(double low, double high) { return std::max(1.0, std::floor(10 * between(low, high) + 0.5)) / 10; }

double Dice::quantile(const std::vector<double>& values) {
    const double at = between(0, static_cast<double>(values.size() - 1));
    const auto below = static_cast<std::size_t>(at);
    return values[below] + (at - static_cast<double>(below)) * (values[below + 1] - values[below]);
}

Mat3 Dice::cube_rotation() {
    const int axis = number(0, 2);
    const bool swapped = chance(0.5);
    std::array<int, 3> to{axis, (axis + 1) % 3, (axis + 2) % 3};
    if (swapped) std::swap(to[1], to[2]);
    const double x = chance(0.5) ? 1 : -1, y = chance(0.5) ? 1 : -1;
    const std::array<double, 3> signs{x, y, (swapped ? -1 : 1) * x * y};
    Mat3 matrix{{Vec3{}, Vec3{}, Vec3{}}};
    for (int row = 0; row < 3; ++row) {
        const auto i = static_cast<std::size_t>(row);
        matrix.rows[i][to[i]] = signs[i];
    }
    return matrix;
}

}  // namespace spectralpack::tools
