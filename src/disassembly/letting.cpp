#include "disassembly/letting.hpp"

#include <algorithm>

#include "disassembly/ways/moves.hpp"

namespace spectralpack {
namespace {

/// Clear of the other in some direction.
bool outside(const Box& box, const Box& others) {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        if (way_past(box, others, BlockingGraph::direction(d)) <= -kClearance / 2) return true;
    }
    return false;
}

}  // namespace

PlanRepair::Letting::Letting(PlanRepair& plan, std::size_t part)
    : plan_(plan),
      part_(part),
      subassemblies_(plan.parts_.size()),
      waiting_{part},
      waits_(plan.parts_.size(), false),
      standing_(boxes_of(plan.parts_)),
      going_(standing_) {
    for (; next_ < plan_.steps_.size() && plan_.steps_[next_].number < plan_.discarded_after_[part]; ++next_) {
        keep(plan_.steps_[next_]);
    }
    subassembly_ = subassemblies_.of(part);
    waits_[part] = true;
    for (std::size_t i = 0; i < plan_.parts_.size(); ++i) {
        if (!member(i) || i == part) going_.remove(i);
        if (!member(i) || (plan_.is_out(i) && i != part)) standing_.remove(i);
    }
}

void PlanRepair::Letting::keep(Step step) {
    subassemblies_.make(step.step);
    steps_.push_back(std::move(step));
}

/// `path`, on which the movers leave those that go as planned, gone on with until they leave those that wait as well;
/// none where those are in the way.
std::optional<PlanRepair::Path> PlanRepair::Letting::past(const Members& movers, Path path) const {
    if (path.empty()) return std::nullopt;  // nobody else was left
    Box own;
    for (const std::size_t member : movers) {
        own.add(plan_.parts_[member].box());
    }
    own = at_end(own, path);
    const Box standing = standing_.without(movers);
    if (!outside(own, standing)) {
        // Going on away from the box of those that go meets none of them.
        const Box going = going_.without(movers);
        std::optional<AxisDirection> on;
        double least = Box::kInfinity;
        for (int d = 0; d < BlockingGraph::kDirections; ++d) {
            const AxisDirection direction = BlockingGraph::direction(d);
            const double way = way_past(own, standing, direction);
            if ((!going.empty() && way_past(own, going, direction) > 0) || way >= least) continue;
            on = direction;
            least = way;
        }
        if (!on) return std::nullopt;
        path.push_back(along(*on, least + kClearance));
        path = merged(path);
    }
    if (!plan_.free_of(movers, path, waiting_)) return std::nullopt;
    return path;
}

/// The part leaves before that step, if it has a way out then. All later steps hold.
bool PlanRepair::Letting::leaves_before(const Step& planned) {
    Members standing;
    for (std::size_t i = 0; i < plan_.parts_.size(); ++i) {
        if (member(i) && (!plan_.is_out(i) || i == part_)) standing.push_back(i);
    }
    std::optional<Path> way = plan_.way_out(part_, standing);
    if (!way) return false;
    const Box end = at_end(plan_.parts_[part_].box(), *way);
    for (std::size_t i = 0; i < plan_.parts_.size(); ++i) {
        if (!plan_.is_out(i) || i == part_ || !member(i)) continue;
        const bool clear = outside(end, plan_.parts_[i].box()) && plan_.free_of({part_}, *way, {i});
        if (!clear) unknown_from_.emplace_back(i, planned.number);
    }
    steps_.push_back({{{static_cast<int>(part_)}, std::move(*way)}, planned.number});
    return true;
}

/// Keeps a step that its movers can make with those waiting where they are; where they cannot they wait as well.
void PlanRepair::Letting::go_on(const Step& planned, const Members& movers, std::optional<Path> path) {
    for (const int i : planned.step.placements) {
        const auto out = static_cast<std::size_t>(i);
        if (plan_.is_out(out) && (!path || !plan_.free_of({out}, *path, waiting_))) {
            unknown_from_.emplace_back(out, planned.number);
        }
    }
    for (const std::size_t i : movers) {
        if (waits_[i]) continue;
        going_.remove(i);
        if (path) {
            standing_.remove(i);
        } else {
            waits_[i] = true;
            waiting_.push_back(i);
        }
    }
    if (path) keep({{planned.step.placements, std::move(*path)}, planned.number});
}

/// Whether the part is held by those that held the last one for which no plan was found: many copies are tried in the
/// same hole, and a few of those around it are asked sooner than all that wait.
bool PlanRepair::Letting::still_stuck() {
    Members few = plan_.last_stuck_;
    if (few.empty() || !std::ranges::all_of(few, [&](std::size_t i) { return waits_[i]; })) return false;
    few.push_back(part_);
    std::sort(few.begin(), few.end());
    return few.size() < waiting_.size() && !plan_.take_apart(few, part_, false);
}

/// By themselves, after all others have left.
bool PlanRepair::Letting::take_apart_those_waiting(bool instead) {
    if (!instead && still_stuck()) return false;
    Members members = waiting_;
    std::sort(members.begin(), members.end());
    for (std::size_t i = 0; i < plan_.parts_.size(); ++i) {
        if (plan_.parts_[i].object.fixed && member(i)) members.push_back(i);
    }
    std::optional<TakenApart> apart = plan_.take_apart(members, part_, instead);
    if (!apart) return false;
    for (const auto& [member, steps] : apart->discarded) {
        discarded_.emplace_back(member, plan_.next_number_ + steps);
    }
    for (RemovalStep& step : apart->steps) {
        steps_.push_back({std::move(step), plan_.next_number_++});
    }
    return true;
}

bool PlanRepair::Letting::run(std::size_t most, bool instead) {
    bool left = false;
    for (; next_ < plan_.steps_.size(); ++next_) {
        const Step& planned = plan_.steps_[next_];
        if (!left && subassemblies_.of(planned.step) == subassembly_) {
            const Members movers = plan_.movers(planned.step);
            std::optional<Path> path = planned.step.path;
            if (std::ranges::any_of(movers, [&](std::size_t i) { return waits_[i]; })) {
                path.reset();
            } else if (!movers.empty()) {
                path = past(movers, std::move(*path));
            }
            left = !path && waiting_.size() == 1 && leaves_before(planned);
            if (!left) {
                go_on(planned, movers, std::move(path));
                if (waiting_.size() > most) return false;
                continue;
            }
        }
        keep(planned);
    }
    if (!left && !take_apart_those_waiting(instead)) return false;
    plan_.steps_ = std::move(steps_);
    plan_.discarded_after_[part_] = kStayed;
    for (const auto& [out, number] : unknown_from_) {
        plan_.discarded_after_[out] = std::min(plan_.discarded_after_[out], number);
    }
    for (const auto& [out, number] : discarded_) {
        plan_.discarded_after_[out] = number;
    }
    return true;
}

}  // namespace spectralpack
