#include "disassembly/moves.hpp"

namespace spectralpack {

std::vector<Vec3> merged(const std::vector<Vec3>& path) {
    std::vector<Vec3> result;
    for (const Vec3& move : path) {
        if (!(length(move) > 0)) continue;
        if (!result.empty() && direction_of(result.back()).axis == direction_of(move).axis) {
            result.back() = result.back() + move;
            if (!(length(result.back()) > 0)) result.pop_back();
        } else {
            result.push_back(move);
        }
    }
    return result;
}

}  // namespace spectralpack
