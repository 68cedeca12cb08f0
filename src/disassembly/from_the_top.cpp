#include <algorithm>
#include <utility>

#include "disassembly/dismantler.hpp"

/// Taking a tray apart as one digs (docs/algorithm/disassembly.md, step 9): upwards, between walls that stand.

namespace spectralpack {
namespace {

// A way of more is one to be found by hand: what else can go, goes before.
constexpr std::size_t kFewMoves = 6;
// Copies that come out as one.
constexpr std::size_t kHeldAtOnce = 20;

}  // namespace

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

/// Takes out what is least trouble: one copy straight or by few moves; a group that can be held; one copy by many
/// moves.
bool Disassembler::Dismantler::leave_by_hand() {
    if (from_the_top_ ? leave_from_the_top() : leave_straight() || leave_by_few_moves(standing_by_turn())) return true;
    return leave_as_group(kHeldAtOnce) || leave_by_a_winding_way();
}

/// Takes out one copy: the uppermost that goes straight up; or before it, by a way with corners, one that is all above
/// it and that none of those who go straight up is in the way of, nor of whom that waits for: it will never do so.
bool Disassembler::Dismantler::leave_from_the_top() {
    find_ways_up();
    Members straight, others;
    for (const std::size_t i : standing_by_turn()) {
        (up_[i] ? straight : others).push_back(i);
    }
    if (!straight.empty()) {
        const double top = subassembly_.part(straight.front()).box().max.z;
        std::erase_if(others, [&](std::size_t i) { return subassembly_.part(i).box().min.z < top; });
        if (!others.empty()) {
            const std::vector<bool> waits = graph_.behind(straight, BlockingGraph::direction(0));
            std::erase_if(others, [&](std::size_t i) { return waits[i]; });
        }
    }
    if (leave_by_few_moves(others)) return true;
    if (straight.empty() || owner_.options_.stop.stopped()) return false;
    const std::size_t uppermost = straight.front();
    leave({uppermost}, *std::exchange(up_[uppermost], std::nullopt));
    ++owner_.counts_.straight;
    return true;
}

Disassembler::Dismantler::Members Disassembler::Dismantler::standing_by_turn() const {
    Members members;
    for (const std::size_t i : turns_) {
        if (subassembly_.movable(i)) members.push_back(i);
    }
    return members;
}

/// Asks for the way of the first of these, and of some that come next. False: stopped.
bool Disassembler::Dismantler::know(Members::const_iterator begin, Members::const_iterator end) {
    if (known_[*begin]) return true;
    Members unknown;
    for (auto at = begin; at != end && unknown.size() < kBatch; ++at) {
        if (!known_[*at]) unknown.push_back(*at);
    }
    return flood(unknown);
}

/// The first of these that has such a way.
bool Disassembler::Dismantler::leave_by_few_moves(const Members& members) {
    for (auto next = members.begin(); next != members.end(); ++next) {
        if (!know(next, members.end())) return false;
        if (stuck(*next) || known_[*next]->path->size() > kFewMoves) continue;
        leave({*next}, std::move(*known_[*next]->path));
        ++owner_.counts_.flooded;
        return true;
    }
    return false;
}

/// Whoever has the way of fewest.
bool Disassembler::Dismantler::leave_by_a_winding_way() {
    const auto moves = [&](std::size_t i) { return known_[i]->path->size(); };
    const Members members = standing_by_turn();
    std::optional<std::size_t> best;
    for (auto next = members.begin(); next != members.end(); ++next) {
        if (!know(next, members.end())) return false;
        if (!stuck(*next) && (!best || moves(*next) < moves(*best))) best = *next;
    }
    if (!best) return false;
    leave({*best}, std::move(*known_[*best]->path));
    ++owner_.counts_.flooded;
    return true;
}

/// Takes out what has no other way than one that the walls are in: one copy straight, or else as told.
bool Disassembler::Dismantler::leave_through_the_walls() {
    subassembly_.set_aside(walls_);
    const bool left = leave_straight_through_the_walls() || leave_as_told();
    subassembly_.set_aside(std::nullopt);
    return left;
}

/// One copy, the uppermost that can.
bool Disassembler::Dismantler::leave_straight_through_the_walls() {
    struct Try {
        std::size_t i;
        AxisDirection direction;
    };
    std::vector<Try> tries;
    for (const std::size_t i : standing_by_turn()) {
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
