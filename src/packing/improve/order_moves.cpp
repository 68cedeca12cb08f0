#include "packing/improve/order_moves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spectralpack {
namespace {

constexpr int kMostMoves = 3;
constexpr double kUrged = 0.6;     // of moves are of the copy that urges most
constexpr double kEarlier = 0.75;  // of moves lead to an earlier place, others anywhere

/// Normal, of mean 0 and standard deviation 1 (Box and Muller).
double normal(RandomStream& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
    return radius * std::cos(2 * std::numbers::pi * random.unit());
}

std::size_t most_urgent(const std::vector<std::size_t>& places, const OrderMoves& moves, RandomStream& random) {
    std::size_t most = 0;
    double greatest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double urge = moves.urge(places[i]) + moves.noise * normal(random);
        if (urge <= greatest) continue;
        greatest = urge;
        most = i;
    }
    return most;
}

/// As near to `to` as the copy at `from` may go, one place after the other.
std::size_t allowed_place(const std::vector<Copy>& order, std::size_t from, std::size_t to, const OrderMoves& moves) {
    std::size_t at = from;
    while (at > to && moves.may_pass(order[from], order[at - 1])) {
        --at;
    }
    while (at < to && moves.may_pass(order[at + 1], order[from])) {
        ++at;
    }
    return at;
}

void number_in_order(std::vector<Copy>& order) {
    std::map<int, std::vector<int>> numbers;  // by part
    for (const Copy& copy : order) {
        numbers[copy.part].push_back(copy.number);
    }
    std::map<int, std::size_t> next;
    for (auto& [part, list] : numbers) {
        std::ranges::sort(list);
    }
    for (Copy& copy : order) {
        copy.number = numbers[copy.part][next[copy.part]++];
    }
}

}  // namespace

std::vector<Copy> moved_order(const std::vector<Copy>& order, const OrderMoves& moves, RandomStream& random) {
    std::vector<Copy> moved = order;
    std::vector<std::size_t> places(order.size());  // in `order`, of those in `moved`
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = i;
    }
    if (order.size() < 2) return moved;
    const std::uint64_t count = 1 + random.below(kMostMoves);
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::size_t from =
            random.unit() < kUrged ? most_urgent(places, moves, random) : random.below(order.size());
        const std::size_t wish = random.unit() < kEarlier ? random.below(from + 1) : random.below(order.size());
        const std::size_t to = allowed_place(moved, from, wish, moves);
        const auto shift = [&](auto& list) {
            const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
            if (to < from) std::rotate(at(to), at(from), at(from + 1));
            if (to > from) std::rotate(at(from), at(from + 1), at(to + 1));
        };
        shift(moved);
        shift(places);
    }
    number_in_order(moved);
    return moved;
}

}  // namespace spectralpack
