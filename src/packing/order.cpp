#include "packing/order.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace spectralpack {
namespace {

constexpr double kFullRatio = 1.2;         // appendix A.2
constexpr double kPenaltyWhenFull = 4;     // appendix A.2
constexpr double kPenaltyWhenRoomy = 1e8;  // appendix A.2

}  // namespace

std::vector<PackItem> order_items(const std::vector<PartSize>& parts, Order order, std::uint64_t seed) {
    std::vector<PartSize> sorted = parts;
    if (order == Order::size) {
        std::stable_sort(sorted.begin(), sorted.end(), [](const PartSize& a, const PartSize& b) {
            return a.box_volume > b.box_volume;
        });
    }
    std::vector<PackItem> items;
    for (const PartSize& part : sorted) {
        for (int copy = 0; copy < part.count; ++copy) {
            items.push_back({part.part, copy});
        }
    }
    if (order == Order::random) {
        RandomStream random(seed);
        shuffle(items, random);
    }
    return items;
}

double automatic_height_penalty(const std::vector<PartSize>& parts, double container_volume) {
    double boxes = 0;
    for (const PartSize& part : parts) {
        boxes += part.count * part.box_volume;
    }
    return boxes > kFullRatio * container_volume ? kPenaltyWhenFull : kPenaltyWhenRoomy;
}

}  // namespace spectralpack
