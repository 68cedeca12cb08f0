#include "disassembly/dismantler.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "disassembly/graph/rays.hpp"

namespace spectralpack {

Disassembler::Dismantler::Dismantler(Disassembler& owner, std::vector<int> names, std::vector<Body> parts,
                                     Unpack unpack)
    : owner_(owner),
      subassembly_(Subassembly::closed(owner.options_, std::move(names), std::move(parts))),
      graph_(subassembly_.size()),
      known_(subassembly_.size()),
      few_moves_first_(unpack == Unpack::top),
      from_the_top_(unpack == Unpack::top),
      up_(subassembly_.size()) {
    std::vector<const Body*> standing;
    for (std::size_t i = 0; i < subassembly_.size(); ++i) {
        standing.push_back(&subassembly_.part(i));
        if (owner.rules_.walls == i) walls_ = i;
    }
    cast_rays(standing, owner.options_.ray_spacing, graph_, owner.options_.workers);
    turns_ = highest_first(subassembly_.movable());
}

Disassembler::Dismantler::Dismantler(const Dismantler& founder, const Members& members,
                                     std::vector<std::optional<Flooded>> known)
    : owner_(founder.owner_),
      subassembly_(founder.subassembly_, members),
      graph_(founder.graph_.among(members)),
      known_(std::move(known)),
      turns_(highest_first(subassembly_.movable())),
      few_moves_first_(founder.few_moves_first_) {}

void Disassembler::Dismantler::run() {
    while (!owner_.options_.stop.stopped()) {
        if (few_moves_first_ && leave_by_hand()) continue;
        if (!few_moves_first_ && (leave_straight() || leave_by_flood())) continue;
        if (leave_as_group(subassembly_.size()) || leave_as_told() || leave_beside_the_grid()) continue;
        if (walls_ && leave_through_the_walls()) continue;
        return;
    }
}

bool Disassembler::Dismantler::discard(int name) {
    for (std::size_t i = 0; i < subassembly_.size(); ++i) {
        if (subassembly_.name(i) != name || !subassembly_.present(i)) continue;
        remove(i);
        return true;
    }
    return false;
}

void Disassembler::Dismantler::remove(std::size_t i) {
    const TrayObject& gone = subassembly_.part(i).object;
    subassembly_.remove(i);
    graph_.remove(i);
    if (!up_.empty()) up_[i].reset();
    known_[i].reset();
    for (std::optional<Flooded>& known : known_) {
        if (known && known->closed_region && known->closed_region->touches(gone)) known.reset();
    }
}

void Disassembler::Dismantler::leave(const Members& members, Subassembly::Path path) {
    if (subassembly_.aside()) owner_.through_walls_.push_back(static_cast<int>(owner_.steps_.size()));
    RemovalStep step{{}, std::move(path)};
    for (const std::size_t i : members) {
        step.placements.push_back(subassembly_.name(i));
        remove(i);
    }
    owner_.steps_.push_back(std::move(step));
    if (members.size() == 1) {
        --owner_.standing_;
        owner_.left_(owner_.standing_, owner_.all_);
    }
}

Disassembler::Dismantler::Members Disassembler::Dismantler::ready(AxisDirection direction) const {
    Members members;
    for (const std::size_t i : subassembly_.movable()) {
        if (graph_.blockers(i, direction) == 0) members.push_back(i);
    }
    return highest_first(std::move(members));
}

Disassembler::Dismantler::Members Disassembler::Dismantler::highest_first(Members members) const {
    std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
        return subassembly_.part(a).box().max.z > subassembly_.part(b).box().max.z;
    });
    return members;
}

void Disassembler::Dismantler::learn(const Subassembly::Straight& way, AxisDirection direction) {
    for (const auto& [member, other] : way.passed) {
        graph_.add_passed(member, direction, other);
    }
    // It may have left just now: then the edge says nothing any more.
    if (way.met && subassembly_.present(way.met->other)) graph_.add(way.met->member, direction, way.met->other);
}

/// Takes out all that leave by straight ways, upwards where they can. True when some did.
bool Disassembler::Dismantler::leave_straight() {
    bool any = false;
    for (int d = 0; d < BlockingGraph::kDirections && !owner_.options_.stop.stopped();) {
        // Upwards everything that can; sideways or down one at a time, since others may now go up.
        const bool moved = leave_straight(BlockingGraph::direction(d), d == 0);
        any = any || moved;
        d = moved ? 0 : d + 1;
    }
    return any;
}

bool Disassembler::Dismantler::leave_straight(AxisDirection direction, bool all) {
    const Members members = ready(direction);
    const std::size_t batch = all ? members.size() : kBatch;
    bool moved = false;
    for (std::size_t begin = 0; begin < members.size() && (all || !moved); begin += batch) {
        const std::size_t count = std::min(batch, members.size() - begin);
        std::vector<Subassembly::Straight> ways(count);
        owner_.options_.workers.for_each(static_cast<std::int64_t>(count), [&](std::int64_t k) {
            const auto i = static_cast<std::size_t>(k);
            ways[i] = subassembly_.straight_way({members[begin + i]}, direction, &graph_);
        });
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = members[begin + k];
            learn(ways[k], direction);
            if (ways[k].met || (moved && !all)) continue;
            leave({i}, std::move(ways[k].path));
            ++owner_.counts_.straight;
            moved = true;
        }
    }
    return moved;
}

/// Takes out one copy by a way with corners. Whoever was not tried for longest is tried first: what left meanwhile
/// may have opened the way of others, and more so the longer one waits. Some that come next are tried with it: what
/// is found of them holds until their turn, a way for good and a closed region until somebody in it leaves.
bool Disassembler::Dismantler::leave_by_flood() {
    struct Try {
        std::size_t turn, i;
    };
    std::vector<Try> tries;
    for (std::size_t k = 0; k < turns_.size(); ++k) {
        const std::size_t i = turns_[(turn_ + k) % turns_.size()];
        if (subassembly_.movable(i) && !stuck(i)) tries.push_back({k, i});
    }
    for (auto next = tries.begin(); next != tries.end(); ++next) {
        if (!known_[next->i]) {
            Members unknown;
            for (auto at = next; at != tries.end() && unknown.size() < kBatch; ++at) {
                if (!known_[at->i]) unknown.push_back(at->i);
            }
            if (!flood(unknown)) return false;
        }
        if (stuck(next->i)) continue;
        turn_ = (turn_ + next->turn + 1) % turns_.size();
        leave({next->i}, std::move(*known_[next->i]->path));
        ++owner_.counts_.flooded;
        return true;
    }
    return false;
}

bool Disassembler::Dismantler::flood(const Members& members) {
    const StopToken& stop = owner_.options_.stop;
    std::vector<Flooded> flooded(members.size());
    owner_.options_.workers.for_each_in_order(std::ssize(members), [&](std::int64_t k) {
        if (stop.stopped()) return;
        const auto at = static_cast<std::size_t>(k);
        Subassembly::Flood flood = subassembly_.flood(members[at]);
        flooded[at] = way_out(subassembly_, flood);
    });
    if (stop.stopped()) return false;
    for (std::size_t k = 0; k < members.size(); ++k) {
        known_[members[k]] = std::move(flooded[k]);
    }
    owner_.counts_.fills += static_cast<int>(members.size());
    return true;
}

/// Takes out one group, as the blocking graphs suggest; it becomes a subassembly of its own.
bool Disassembler::Dismantler::leave_as_group(std::size_t most) {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        const AxisDirection direction = BlockingGraph::direction(d);
        for (bool learned = true; learned;) {
            learned = false;
            for (const Members& group : graph_.groups(direction)) {
                if (owner_.options_.stop.stopped()) return false;
                if (group.size() > most || (walls_ && group.size() == standing())) continue;
                if (!std::all_of(group.begin(), group.end(), [&](std::size_t i) { return subassembly_.movable(i); })) {
                    continue;
                }
                Subassembly::Straight way = subassembly_.straight_way(group, direction, &graph_);
                learn(way, direction);
                if (!way.met) {
                    found_subassembly(group, std::move(way.path));
                    return true;
                }
                learned = true;
            }
        }
    }
    return false;
}

/// Takes out whom the first step that says something of those present does. What was in the way once and is gone
/// changes nothing, so it holds if it did.
bool Disassembler::Dismantler::leave_as_told() {
    if (owner_.rules_.told == nullptr) return false;
    std::map<int, std::size_t> present;
    for (std::size_t i = 0; i < subassembly_.size(); ++i) {
        if (subassembly_.present(i) && i != walls_) present.emplace(subassembly_.name(i), i);
    }
    for (const RemovalStep& step : *owner_.rules_.told) {
        Members members;
        for (const int name : step.placements) {
            if (const auto known = present.find(name); known != present.end()) members.push_back(known->second);
        }
        std::sort(members.begin(), members.end());
        if (members.empty() || members.size() == present.size()) continue;
        if (!subassembly_.leads_out(members, step.path)) return false;
        if (members.size() > 1) {
            found_subassembly(members, step.path);
        } else {
            leave(members, step.path);
            ++(step.path.size() == 1 ? owner_.counts_.straight : owner_.counts_.flooded);
        }
        return true;
    }
    return false;
}

/// Takes out one copy that no flood fill could begin with, the highest first.
bool Disassembler::Dismantler::leave_beside_the_grid() {
    Members members;
    for (const std::size_t i : highest_first(subassembly_.movable())) {
        if (stuck(i) && !known_[i]->began) members.push_back(i);
    }
    std::vector<std::optional<Subassembly::Path>> ways(members.size());
    const std::int64_t first = owner_.options_.workers.first(std::ssize(members), [&](std::int64_t k) {
        const auto at = static_cast<std::size_t>(k);
        if (!owner_.options_.stop.stopped()) ways[at] = way_beside_the_grid(subassembly_, members[at]);
        return ways[at].has_value();
    });
    if (first == std::ssize(members)) return false;
    const auto at = static_cast<std::size_t>(first);
    leave({members[at]}, std::move(*ways[at]));
    ++owner_.counts_.flooded;
    return true;
}

void Disassembler::Dismantler::found_subassembly(const Members& group, Subassembly::Path path) {
    // A closed region that only they close stays closed.
    std::vector<std::optional<Flooded>> known(group.size());
    for (std::size_t k = 0; k < group.size(); ++k) {
        if (!stuck(group[k])) continue;
        known[k] = known_[group[k]];
        for (std::size_t other = 0; known[k] && other < subassembly_.size(); ++other) {
            if (!subassembly_.present(other) || std::binary_search(group.begin(), group.end(), other)) continue;
            if (known[k]->closed_region->touches(subassembly_.part(other).object)) known[k].reset();
        }
    }
    const auto dismantler = owner_.dismantlers_.emplace(owner_.dismantlers_.end(), *this, group, std::move(known));
    leave(group, std::move(path));
    ++owner_.counts_.groups;
    dismantler->run();
    if (dismantler->subassembly().movable().empty()) owner_.dismantlers_.erase(dismantler);
}

}  // namespace spectralpack
