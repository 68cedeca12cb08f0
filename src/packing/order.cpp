#include "packing/order.hpp"

#include <algorithm>
#include <map>

#include "core/random.hpp"

namespace spectralpack {
namespace {

constexpr double kFullRatio = 1.2;         // appendix A.2
constexpr double kPenaltyWhenFull = 4;     // appendix A.2
constexpr double kPenaltyWhenRoomy = 1e8;  // appendix A.2

/// Whatever their sizes.
bool goes_before(const PartSize& a, const PartSize& b) {
    if (a.priority != b.priority) return a.priority > b.priority;
    if (a.due.empty() || b.due.empty()) return !a.due.empty() && b.due.empty();
    return a.due < b.due;
}

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
    std::map<int, const PartSize*> by_part;
    for (const PartSize& part : parts) {
        by_part[part.part] = &part;
    }
    std::stable_sort(items.begin(), items.end(), [&](const PackItem& a, const PackItem& b) {
        return goes_before(*by_part.at(a.part), *by_part.at(b.part));
    });
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
