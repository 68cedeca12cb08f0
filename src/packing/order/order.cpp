#include "packing/order/order.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

constexpr double kLeastBox = 1e-9;  // mm^3
constexpr double kFarthest = 0.2;   // of all copies, that one goes back

/// What an order by size sorts by, largest first.
double size_of(const PartSize& part, Order order) {
    switch (order) {
        case Order::size:
            return part.box_volume;
        case Order::volume:
            return part.volume;
        case Order::mixed:
            return std::sqrt(part.box_volume * std::max(0.0, part.volume));
        case Order::input:
        case Order::random:
            break;
    }
    return 0;
}

/// All copies, those of parts with the largest `key` first.
template <class Key>
std::vector<Copy> sorted_copies(const std::vector<PartSize>& parts, const Key& key) {
    std::vector<PartSize> sorted = parts;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const PartSize& a, const PartSize& b) { return key(a) > key(b); });
    std::vector<Copy> copies;
    for (const PartSize& part : sorted) {
        for (int copy = 0; copy < part.count; ++copy) {
            copies.push_back({part.part, copy});
        }
    }
    return copies;
}

void put_urgent_first(std::vector<Copy>& copies, const std::vector<PartSize>& parts) {
    std::map<int, const PartSize*> by_part;
    for (const PartSize& part : parts) {
        by_part[part.part] = &part;
    }
    std::stable_sort(copies.begin(), copies.end(), [&](const Copy& a, const Copy& b) {
        return goes_before(*by_part.at(a.part), *by_part.at(b.part));
    });
}

}  // namespace

std::vector<Copy> without(const std::vector<Copy>& copies, const std::set<Copy>& out) {
    std::vector<Copy> rest;
    for (const Copy& copy : copies) {
        if (!out.contains(copy)) rest.push_back(copy);
    }
    return rest;
}

std::vector<Copy> order_of(const std::vector<PlacedCopy>& placed) {
    std::vector<Copy> copies;
    for (const PlacedCopy& copy : placed) {
        copies.push_back(copy.copy);
    }
    return copies;
}

std::set<Copy> copies_in(const std::vector<PlacedCopy>& placed) {
    const std::vector<Copy> copies = order_of(placed);
    return {copies.begin(), copies.end()};
}

std::vector<Copy> order_copies(const std::vector<PartSize>& parts, Order order, std::uint64_t seed) {
    std::vector<Copy> copies = sorted_copies(parts, [&](const PartSize& part) { return size_of(part, order); });
    if (order == Order::random) {
        RandomStream random(seed);
        shuffle(copies, random);
    }
    put_urgent_first(copies, parts);
    return copies;
}

std::vector<Copy> order_copies(const std::vector<PartSize>& parts, Goal goal) {
    std::vector<Copy> copies = sorted_copies(parts, [&](const PartSize& part) {
        switch (goal) {
            case Goal::fair:
                return part.box_volume;
            case Goal::volume:
                return part.volume;
            case Goal::copies:
                return -part.box_volume;
            case Goal::value:
                return part.value / std::max(part.box_volume, kLeastBox);
        }
        return 0.0;
    });
    put_urgent_first(copies, parts);
    return copies;
}

std::vector<int> urgency_ranks(const std::vector<PartSize>& parts) {
    std::vector<const PartSize*> sorted;
    std::size_t most = 0;
    for (const PartSize& part : parts) {
        sorted.push_back(&part);
        most = std::max(most, static_cast<std::size_t>(part.part) + 1);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const PartSize* a, const PartSize* b) { return goes_before(*a, *b); });
    std::vector<int> ranks(most, 0);
    int rank = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i > 0 && goes_before(*sorted[i - 1], *sorted[i])) ++rank;
        ranks[static_cast<std::size_t>(sorted[i]->part)] = rank;
    }
    return ranks;
}

std::vector<Copy> perturbed(const std::vector<Copy>& copies, const std::vector<int>& ranks, RandomStream& random) {
    struct Moved {
        Copy copy;
        int rank;
        double place;
    };
    const double farthest = kFarthest * static_cast<double>(copies.size());
    std::vector<Moved> moved;
    for (const Copy& copy : copies) {
        const double place = static_cast<double>(moved.size()) + farthest * random.unit();
        moved.push_back({copy, ranks[static_cast<std::size_t>(copy.part)], place});
    }
    std::stable_sort(moved.begin(), moved.end(), [](const Moved& a, const Moved& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.place < b.place;
    });
    std::vector<Copy> order;
    for (const Moved& one : moved) {
        order.push_back(one.copy);
    }
    return order;
}

double automatic_height_penalty(const std::vector<PartSize>& parts, double container_volume) {
    double boxes = 0;
    for (const PartSize& part : parts) {
        boxes += part.count * part.box_volume;
    }
    return boxes > kFullRatio * container_volume ? kPenaltyWhenFull : kPenaltyWhenRoomy;
}

}  // namespace spectralpack
