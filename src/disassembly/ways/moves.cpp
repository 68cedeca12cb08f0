#include "disassembly/ways/moves.hpp"

#include <algorithm>
#include <array>

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

std::vector<Vec3> shortened(std::vector<Vec3> path, const FreeMove& free) {
    const auto place = [&](std::size_t k) {
        Vec3 at;
        for (std::size_t i = 0; i < k; ++i) {
            at = at + path[i];
        }
        return at;
    };
    for (std::size_t k = 0; k + 2 < path.size();) {
        const Vec3 from = place(k), both = path[k] + path[k + 2], between = path[k + 1];
        const std::array orders{std::array{both, between}, std::array{between, both}};
        const auto* order = orders.end();
        if (direction_of(path[k]).axis == direction_of(path[k + 2]).axis) {
            order = std::find_if(orders.begin(), orders.end(), [&](const std::array<Vec3, 2>& moves) {
                return free(from, moves[0]) && free(from + moves[0], moves[1]);
            });
        }
        if (order == orders.end()) {
            ++k;
            continue;
        }
        std::vector<Vec3> shorter(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(k));
        shorter.insert(shorter.end(), order->begin(), order->end());
        shorter.insert(shorter.end(), path.begin() + static_cast<std::ptrdiff_t>(k + 3), path.end());
        shorter = merged(shorter);
        // What was tried of the moves before is as it was, up to the first that is another.
        const auto other = std::mismatch(shorter.begin(), shorter.end(), path.begin(), path.end()).first;
        const auto same = static_cast<std::size_t>(other - shorter.begin());
        k = std::min(k, same < 2 ? 0 : same - 2);
        path = std::move(shorter);
    }
    return path;
}

}  // namespace spectralpack
