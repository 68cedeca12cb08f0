#include "disassembly/standing_hull.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

double reach(const Box& box, std::size_t side) {
    const int axis = static_cast<int>(side / 2);
    return side % 2 == 0 ? -box.min[axis] : box.max[axis];
}

}  // namespace

StandingHull::StandingHull(const std::vector<Box>& boxes) : present_(boxes.size(), true) {
    for (std::size_t side = 0; side < kSides; ++side) {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            sides_[side].push_back({reach(boxes[i], side), i});
        }
        std::sort(sides_[side].begin(), sides_[side].end());
    }
}

void StandingHull::add(const Box& box) {
    for (std::size_t side = 0; side < kSides; ++side) {
        const Side added{reach(box, side), present_.size()};
        sides_[side].insert(std::upper_bound(sides_[side].begin(), sides_[side].end(), added), added);
    }
    present_.push_back(true);
}

void StandingHull::remove(std::size_t i) {
    present_[i] = false;
    for (std::vector<Side>& side : sides_) {
        while (!side.empty() && !present_[side.back().of])
            side.pop_back();
    }
}

Box StandingHull::without(const std::vector<std::size_t>& members) const {
    Box box;
    for (std::size_t side = 0; side < kSides; ++side) {
        const auto outermost = std::find_if(sides_[side].rbegin(), sides_[side].rend(), [&](const Side& s) {
            return present_[s.of] && !std::binary_search(members.begin(), members.end(), s.of);
        });
        if (outermost == sides_[side].rend()) return Box{};
        const int axis = static_cast<int>(side / 2);
        (side % 2 == 0 ? box.min : box.max)[axis] = side % 2 == 0 ? -outermost->reach : outermost->reach;
    }
    return box;
}

}  // namespace spectralpack
