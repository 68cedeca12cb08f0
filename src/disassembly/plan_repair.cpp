#include "disassembly/plan_repair.hpp"

#include <algorithm>
#include <numeric>

#include "disassembly/standing_hull.hpp"
#include "disassembly/ways/moves.hpp"
#include "geometry/slides_past.hpp"

namespace spectralpack {
namespace {

/// Whose subassembly each part is in while steps are made.
class Subassemblies {
  public:
    explicit Subassemblies(std::size_t parts) : of_(parts, 0) {}

    int of(std::size_t part) const { return of_[part]; }
    int of(const RemovalStep& step) const { return of_[static_cast<std::size_t>(step.placements.front())]; }
    void make(const RemovalStep& step) {
        constexpr int kLeft = -1;
        const int to = step.placements.size() > 1 ? founded_++ : kLeft;
        for (const int part : step.placements) {
            of_[static_cast<std::size_t>(part)] = to;
        }
    }

  private:
    std::vector<int> of_;
    int founded_ = 1;
};

constexpr std::size_t kMostChanged = 2;  // more than one in so many, and the subassembly is made anew

double weight(const Body& part) { return static_cast<double>(part.object.solid->count()); }

/// Clear of the other in some direction.
bool outside(const Box& box, const Box& others) {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        if (way_past(box, others, BlockingGraph::direction(d)) <= -kClearance / 2) return true;
    }
    return false;
}

}  // namespace

/// Lets one part in: goes through the steps of its subassembly from when it was discarded on.
class PlanRepair::Letting {
  public:
    Letting(PlanRepair& plan, std::size_t part);
    /// Changes the plan if it is true.
    bool run(std::size_t most, bool instead);

  private:
    bool member(std::size_t i) const { return subassemblies_.of(i) == subassembly_; }
    void keep(Step step);
    std::optional<Path> past(const Members& movers, Path path) const;
    bool leaves_before(const Step& planned);
    void go_on(const Step& planned, const Members& movers, std::optional<Path> path);
    bool still_stuck();
    bool take_apart_those_waiting(bool instead);

    PlanRepair& plan_;
    const std::size_t part_;
    std::size_t next_ = 0;             // of the plan's steps
    std::vector<Step> steps_;          // the new plan, so far
    Subassemblies subassemblies_;      // after those
    int subassembly_ = 0;              // the part's
    Members waiting_;                  // go last
    std::vector<bool> waits_;          // by part
    StandingHull standing_;            // those waiting included
    StandingHull going_;               // those not, but those that are out: they may come in again
    std::vector<Since> unknown_from_;  // of those that are out: steps from that number on know nothing of them any more
    std::vector<Since> discarded_;     // instead of the part
};

PlanRepair::PlanRepair(const DisassemblyOptions& options, std::vector<Body> parts,
                       const std::vector<RemovalStep>& steps, std::vector<std::size_t> discarded_after)
    : options_(options),
      parts_(std::move(parts)),
      names_(parts_.size()),
      discarded_after_(std::move(discarded_after)),
      by_index_(options),
      places_(parts_.size(), kAway) {
    by_index_.on_grid = [this](int i) { return options_.on_grid(names_[static_cast<std::size_t>(i)]); };
    std::iota(names_.begin(), names_.end(), 0);
    for (const Body& part : parts_) {
        weights_.push_back(weight(part));
    }
    for (const RemovalStep& step : steps) {
        steps_.push_back({step, next_number_++});
    }
}

std::vector<RemovalStep> PlanRepair::steps() const {
    std::vector<RemovalStep> steps;
    for (const Step& step : steps_) {
        steps.push_back(step.step);
        for (int& i : steps.back().placements) {
            i = names_[static_cast<std::size_t>(i)];
        }
    }
    return steps;
}

void PlanRepair::put_first(int name, Body part, Path path) {
    const auto i = static_cast<int>(parts_.size());
    add(name, std::move(part), kStayed);
    steps_.insert(steps_.begin(), {{{i}, std::move(path)}, 0});
}

bool PlanRepair::let_in(int name, Body part, std::size_t most) {
    add(name, std::move(part), 0);
    if (let(parts_.size() - 1, most, false)) return true;
    remove_last();
    return false;
}

void PlanRepair::add(int name, Body part, std::size_t discarded_after) {
    weights_.push_back(weight(part));
    parts_.push_back(std::move(part));
    names_.push_back(name);
    discarded_after_.push_back(discarded_after);
    places_.push_back(kAway);
}

void PlanRepair::remove_last() {
    if (places_.back() != kAway) subassembly_->remove(places_.back());
    weights_.pop_back();
    parts_.pop_back();
    names_.pop_back();
    discarded_after_.pop_back();
    places_.pop_back();
}

bool PlanRepair::let_back(int part, std::size_t most) { return let(static_cast<std::size_t>(part), most, true); }

PlanRepair::Members PlanRepair::movers(const RemovalStep& step) const {
    Members members;
    for (const int i : step.placements) {
        const auto part = static_cast<std::size_t>(i);
        if (!is_out(part)) members.push_back(part);
    }
    return members;
}

/// Along `path` the movers meet none of the others.
bool PlanRepair::free_of(const Members& movers, const Path& path, const Members& others) const {
    for (const std::size_t member : movers) {
        const Body& moving = parts_[member];
        Vec3 from;
        for (const Vec3& move : path) {
            const AxisDirection direction = direction_of(move);
            const double way = std::abs(move[direction.axis]);
            const Box box = swept(moved(moving.box(), from), direction, way);
            for (const std::size_t other : others) {
                const Body& still = parts_[other];
                if (!meet(box, still.box())) continue;
                const Vec3 offset = moving.offset + from - still.offset;
                if (!slides_past(*moving.surface, offset, *still.surface, direction, kGraze, way)) return false;
            }
            from = from + move;
        }
    }
    return true;
}

std::vector<Body> PlanRepair::parts_of(const Members& members) const {
    std::vector<Body> parts;
    for (const std::size_t i : members) {
        parts.push_back(parts_[i]);
    }
    return parts;
}

/// For members named by their index in `members`, which is to outlive it.
DisassemblyOptions PlanRepair::options_of(const Members& members) const {
    DisassemblyOptions options = options_;
    options.on_grid = [this, &members](int i) {
        return options_.on_grid(names_[members[static_cast<std::size_t>(i)]]);
    };
    return options;
}

/// Makes the subassembly that of `standing`, ascending: by those that came and went, where they are few. To make it
/// anew takes as long as to fill a tray with all.
void PlanRepair::gather(const Members& standing) {
    Members came, went;
    auto next = standing.begin();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool stands = next != standing.end() && *next == i;
        if (stands) ++next;
        if (stands && places_[i] == kAway) came.push_back(i);
        if (!stands && places_[i] != kAway) went.push_back(i);
    }
    if (subassembly_ && kMostChanged * (came.size() + went.size()) < standing.size() &&
        subassembly_->size() + came.size() <= 2 * standing.size()) {
        for (const std::size_t i : went) {
            subassembly_->remove(std::exchange(places_[i], kAway));
        }
        for (const std::size_t i : came) {
            places_[i] = subassembly_->add(static_cast<int>(i), parts_[i]);
        }
        return;
    }
    subassembly_.emplace(by_index_, std::vector<int>(standing.begin(), standing.end()), parts_of(standing));
    std::ranges::fill(places_, kAway);
    for (std::size_t k = 0; k < standing.size(); ++k) {
        places_[standing[k]] = k;
    }
}

/// Of one that stands with the others.
std::optional<PlanRepair::Path> PlanRepair::way_out(std::size_t part, const Members& standing) {
    gather(standing);
    ++fills_;
    return subassembly_->any_way_out(places_[part]);
}

/// Of those that hold each other, by index into `members`, one that could go, but for `part`.
std::optional<int> PlanRepair::lightest_of(const std::vector<std::vector<int>>& stuck, const Members& members,
                                           std::size_t part) const {
    std::optional<int> lightest;
    double least = Box::kInfinity;
    for (const std::vector<int>& set : stuck) {
        for (const int i : set) {
            const std::size_t member = members[static_cast<std::size_t>(i)];
            if (member == part || parts_[member].object.fixed || weights_[member] >= least) continue;
            lightest = i;
            least = weights_[member];
        }
    }
    return lightest;
}

/// Plans for members that stand by themselves. Where they hold each other, those that are lighter than `part` together
/// are discarded if that helps and may be done `instead`.
std::optional<PlanRepair::TakenApart> PlanRepair::take_apart(const Members& members, std::size_t part, bool instead) {
    const DisassemblyOptions options = options_of(members);
    Disassembler disassembler(options, parts_of(members), [](int, int) {});
    TakenApart apart;
    double discarded = 0;
    bool all = false;
    for (;;) {
        disassembler.run();
        all = disassembler.standing() == 0;
        if (all || !instead || options_.stop.stopped()) break;
        const std::optional<int> lightest = lightest_of(disassembler.stuck(), members, part);
        if (!lightest) break;
        const std::size_t member = members[static_cast<std::size_t>(*lightest)];
        discarded += weights_[member];
        if (discarded >= weights_[part]) break;
        disassembler.discard(*lightest);
        apart.discarded.emplace_back(member, disassembler.steps().size());
    }
    fills_ += disassembler.counts().fills;
    if (!all) {
        last_stuck_.clear();
        for (const std::vector<int>& set : disassembler.stuck()) {
            for (const int i : set) {
                const std::size_t member = members[static_cast<std::size_t>(i)];
                if (member != part) last_stuck_.push_back(member);
            }
        }
        return std::nullopt;
    }
    apart.steps = disassembler.steps();
    for (RemovalStep& step : apart.steps) {
        for (int& i : step.placements) {
            i = static_cast<int>(members[static_cast<std::size_t>(i)]);
        }
    }
    return apart;
}

bool PlanRepair::let(std::size_t part, std::size_t most, bool instead) {
    return Letting(*this, part).run(most, instead);
}

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
