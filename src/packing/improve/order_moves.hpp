#pragma once
/// Orders near to an order: some copies go earlier, or elsewhere.

#include <functional>
#include <vector>

#include "core/random.hpp"
#include "packing/tray/placed_copy.hpp"

namespace spectralpack {

struct OrderMoves {
    /// How much it would help that the copy at this place of the order went earlier: the largest, but for some noise,
    /// is the one that does.
    std::function<double(std::size_t place)> urge;
    double noise = 0;  ///< standard deviation of what is added to urges
    /// Whether the first may go before the second, which it is behind.
    std::function<bool(const Copy&, const Copy&)> may_pass;
};

/// `order` with one to three copies elsewhere. Copies of a part keep their numbers' order, so that orders which differ
/// in nothing but those are equal.
std::vector<Copy> moved_order(const std::vector<Copy>& order, const OrderMoves& moves, RandomStream& random);

}  // namespace spectralpack
