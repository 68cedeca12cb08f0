#include "voxel/axis_turns.hpp"

#include <algorithm>
#include <cmath>

namespace spectralpack {

std::optional<AxisTurn> axis_turn(const Mat3& rotation) {
    AxisTurn turn{{-1, -1, -1}, {}};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const double entry = rotation.rows[row][static_cast<int>(column)];
            if (entry == 0) continue;
            if (std::abs(entry) != 1 || turn.axes[row] != -1) return std::nullopt;
            turn.axes[row] = static_cast<int>(column);
            turn.reversed[column] = entry < 0;
        }
    }
    if (!std::ranges::is_permutation(turn.axes, std::array{0, 1, 2})) return std::nullopt;
    return turn;
}

SignPatterns::SignPatterns(const std::vector<Mat3>& rotations) {
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        turns.push_back(axis_turn(rotations[i]));
        std::size_t pattern = 0;
        if (turns[i]) {
            while (pattern < first_of.size() && signs(pattern) != turns[i]->reversed) {
                ++pattern;
            }
            if (pattern == first_of.size()) first_of.push_back(i);
        }
        pattern_of.push_back(pattern);
    }
}

}  // namespace spectralpack
