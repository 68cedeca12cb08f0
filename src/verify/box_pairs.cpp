#include "verify/box_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace spectralpack {

std::vector<BoxPair> near_pairs(const std::vector<Box>& boxes, double from, double to) {
    Box all;
    for (const Box& box : boxes) {
        all.add(box);
    }
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
        if (all.size()[other] > all.size()[axis]) axis = other;
    }
    std::vector<std::int32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](std::int32_t i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return std::tuple(at(a).min[axis], a) < std::tuple(at(b).min[axis], b);
    });
    std::vector<BoxPair> pairs;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box& box = at(order[i]);
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            if (at(order[j]).min[axis] > box.max[axis] + to) break;
            const double apart = distance(box, at(order[j]));
            if (apart > from && apart <= to) {
                pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j]), apart});
            }
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const BoxPair& x, const BoxPair& y) {
        return std::tuple(x.distance, x.a, x.b) < std::tuple(y.distance, y.a, y.b);
    });
    return pairs;
}

}  // namespace spectralpack
