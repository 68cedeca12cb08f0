#include <algorithm>
#include <utility>

#include "disassembly/dismantler.hpp"

/// Taking a tray apart as one digs (docs/algorithm.md, section 9): upwards, between walls that stand.

namespace spectralpack {

std::size_t Disassembler::Dismantler::standing() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < subassembly_.size(); ++i) {
        count += subassembly_.present(i) && i != walls_ ? 1 : 0;
    }
    return count;
}

/// Sweeps whoever is not known to meet anyone above. What is found holds for good: who leaves is in nobody's way.
void Disassembler::Dismantler::find_ways_up() {
    const AxisDirection up = BlockingGraph::direction(0);
    Members members;
    for (const std::size_t i : turns_) {
        if (subassembly_.movable(i) && !up_[i] && graph_.blockers(i, up) == 0) members.push_back(i);
    }
    std::vector<Subassembly::Straight> ways(members.size());
    owner_.options_.workers.for_each(std::ssize(members), [&](std::int64_t k) {
        const auto at = static_cast<std::size_t>(k);
        ways[at] = subassembly_.straight_way({members[at]}, up, &graph_);
    });
    for (std::size_t k = 0; k < members.size(); ++k) {
        learn(ways[k], up);
        if (!ways[k].met) up_[members[k]] = std::move(ways[k].path);
    }
}

/// Takes out one copy: the uppermost that goes straight up; before it, by ways with corners, those that are all above
/// it, since nobody who rises now can be in their way.
bool Disassembler::Dismantler::leave_from_the_top() {
    find_ways_up();
    std::optional<std::size_t> straight;
    Members others;
    for (const std::size_t i : turns_) {
        if (!subassembly_.movable(i)) continue;
        if (up_[i]) {
            straight = i;
            break;
        }
        others.push_back(i);
    }
    if (straight) {
        const double top = subassembly_.part(*straight).box().max.z;
        std::erase_if(others, [&](std::size_t i) { return subassembly_.part(i).box().min.z < top; });
    }
    if (leave_by_any_of(others)) return true;
    if (!straight || owner_.options_.stop.stopped()) return false;
    leave({*straight}, *std::exchange(up_[*straight], std::nullopt));
    ++owner_.counts_.straight;
    return true;
}

/// The first of these that has a way.
bool Disassembler::Dismantler::leave_by_any_of(const Members& members) {
    for (auto next = members.begin(); next != members.end(); ++next) {
        if (!known_[*next]) {
            Members unknown;
            for (auto at = next; at != members.end() && unknown.size() < kBatch; ++at) {
                if (!known_[*at]) unknown.push_back(*at);
            }
            if (!flood(unknown)) return false;
        }
        if (stuck(*next)) continue;
        leave({*next}, std::move(*known_[*next]->path));
        ++owner_.counts_.flooded;
        return true;
    }
    return false;
}

/// Takes out what has no other way than one that the walls are in: one copy straight, or else as told.
bool Disassembler::Dismantler::leave_through_the_walls() {
    subassembly_.set_aside(walls_);
    const bool left = leave_straight_through_the_walls() || leave_as_told();
    subassembly_.set_aside(std::nullopt);
    return left;
}

bool Disassembler::Dismantler::leave_straight_through_the_walls() {
    struct Try {
        std::size_t i;
        AxisDirection direction;
    };
    std::vector<Try> tries;
    for (const std::size_t i : turns_) {
        if (!subassembly_.movable(i)) continue;
        for (int d = 0; d < BlockingGraph::kDirections; ++d) {
            const AxisDirection direction = BlockingGraph::direction(d);
            const int walls = graph_.meets(i, direction, *walls_) ? 1 : 0;
            if (graph_.blockers(i, direction) == walls) tries.push_back({i, direction});
        }
    }
    for (std::size_t begin = 0; begin < tries.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch, tries.size() - begin);
        std::vector<Subassembly::Straight> ways(count);
        owner_.options_.workers.for_each(static_cast<std::int64_t>(count), [&](std::int64_t k) {
            const Try& one = tries[begin + static_cast<std::size_t>(k)];
            ways[static_cast<std::size_t>(k)] = subassembly_.straight_way({one.i}, one.direction, &graph_);
        });
        for (std::size_t k = 0; k < count; ++k) {
            learn(ways[k], tries[begin + k].direction);
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (ways[k].met) continue;
            leave({tries[begin + k].i}, std::move(ways[k].path));
            ++owner_.counts_.straight;
            return true;
        }
    }
    return false;
}

}  // namespace spectralpack
