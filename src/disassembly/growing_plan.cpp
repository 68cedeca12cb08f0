#include "disassembly/growing_plan.hpp"

#include <algorithm>
#include <numeric>

#include "disassembly/moves.hpp"
#include "disassembly/standing_hull.hpp"
#include "geometry/slides_past.hpp"

namespace spectralpack {
namespace {

/// Whose company each part is in while steps are made.
class Companies {
  public:
    explicit Companies(std::size_t parts) : of_(parts, 0) {}

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

std::vector<Box> boxes_of(const std::vector<StandingPart>& parts) {
    std::vector<Box> boxes;
    for (const StandingPart& part : parts) {
        boxes.push_back(part.box());
    }
    return boxes;
}

/// Clear of the other in some direction.
bool outside(const Box& box, const Box& others) {
    for (int d = 0; d < BlockingGraph::kDirections; ++d) {
        if (way_past(box, others, BlockingGraph::direction(d)) <= -kClearance / 2) return true;
    }
    return false;
}

Box at_end(Box box, const std::vector<Vec3>& path) {
    for (const Vec3& move : path) {
        box = moved(box, move);
    }
    return box;
}

}  // namespace

struct GrowingPlan::Trial {
    Members waiting;         ///< go last
    std::vector<bool> waits; ///< by part
    StandingHull standing;   ///< those waiting included
    StandingHull going;      ///< those not, but those that are out: they may come in again

    void wait(std::size_t part) {
        waits[part] = true;
        waiting.push_back(part);
    }
};

GrowingPlan::GrowingPlan(const DisassemblySetup& setup, std::vector<StandingPart> parts,
                         const std::vector<RemovalStep>& steps, std::vector<std::size_t> discarded_after)
    : setup_(setup), parts_(std::move(parts)), names_(parts_.size()), discarded_after_(std::move(discarded_after)) {
    std::iota(names_.begin(), names_.end(), 0);
    for (const RemovalStep& step : steps) {
        steps_.push_back({step, next_number_++});
    }
}

std::vector<RemovalStep> GrowingPlan::steps() const {
    std::vector<RemovalStep> steps;
    for (const Step& step : steps_) {
        steps.push_back(step.step);
        for (int& i : steps.back().placements) {
            i = names_[static_cast<std::size_t>(i)];
        }
    }
    return steps;
}

void GrowingPlan::put_first(int name, StandingPart part, Path path) {
    const auto i = static_cast<int>(parts_.size());
    parts_.push_back(std::move(part));
    names_.push_back(name);
    discarded_after_.push_back(kStayed);
    steps_.insert(steps_.begin(), {{{i}, std::move(path)}, 0});
}

bool GrowingPlan::let_in(int name, StandingPart part, std::size_t most) {
    parts_.push_back(std::move(part));
    names_.push_back(name);
    discarded_after_.push_back(0);
    if (let(parts_.size() - 1, most, false)) return true;
    parts_.pop_back();
    names_.pop_back();
    discarded_after_.pop_back();
    return false;
}

bool GrowingPlan::let_back(int part, std::size_t most) { return let(static_cast<std::size_t>(part), most, true); }

double GrowingPlan::weight(std::size_t part) const { return static_cast<double>(parts_[part].object.solid->count()); }

GrowingPlan::Members GrowingPlan::movers(const RemovalStep& step) const {
    Members members;
    for (const int i : step.placements) {
        const auto part = static_cast<std::size_t>(i);
        if (!is_out(part)) members.push_back(part);
    }
    return members;
}

/// Along `path` the movers meet none of the others.
bool GrowingPlan::free_of(const Members& movers, const Path& path, const Members& others) const {
    for (const std::size_t member : movers) {
        const StandingPart& moving = parts_[member];
        Vec3 from;
        for (const Vec3& move : path) {
            const AxisDirection direction = direction_of(move);
            const double way = std::abs(move[direction.axis]);
            const Box box = swept(moved(moving.box(), from), direction, way);
            for (const std::size_t other : others) {
                const StandingPart& still = parts_[other];
                if (!meet(box, still.box())) continue;
                const Vec3 offset = moving.offset + from - still.offset;
                if (!slides_past(*moving.surface, offset, *still.surface, direction, kGraze, way)) return false;
            }
            from = from + move;
        }
    }
    return true;
}

/// `path`, on which the movers leave those that go as planned, gone on with until they leave those that wait as well; none
/// where those are in the way.
std::optional<GrowingPlan::Path> GrowingPlan::past(const Members& movers, Path path, const Trial& trial) const {
    if (path.empty()) return std::nullopt;  // nobody else was left
    Box own;
    for (const std::size_t member : movers) {
        own.add(parts_[member].box());
    }
    own = at_end(own, path);
    const Box standing = trial.standing.without(movers);
    if (!outside(own, standing)) {
        // Going on away from the box of those that go meets none of them.
        const Box going = trial.going.without(movers);
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
    if (!free_of(movers, path, trial.waiting)) return std::nullopt;
    return path;
}

std::vector<StandingPart> GrowingPlan::parts_of(const Members& members) const {
    std::vector<StandingPart> parts;
    for (const std::size_t i : members) {
        parts.push_back(parts_[i]);
    }
    return parts;
}

/// For members named by their index in `members`, which is to outlive it.
DisassemblySetup GrowingPlan::setup_of(const Members& members) const {
    DisassemblySetup setup = setup_;
    setup.on_grid = [this, &members](int i) { return setup_.on_grid(names_[members[static_cast<std::size_t>(i)]]); };
    return setup;
}

/// Of one that stands with the others.
std::optional<GrowingPlan::Path> GrowingPlan::way_out(std::size_t part, const Members& standing) {
    const DisassemblySetup setup = setup_of(standing);
    std::vector<int> names(standing.size());
    std::iota(names.begin(), names.end(), 0);
    const Company company(setup, std::move(names), parts_of(standing));
    ++fills_;
    return company.any_way_out(static_cast<std::size_t>(std::ranges::find(standing, part) - standing.begin()));
}

/// Of those that hold each other, by index into `members`, one that could go, but for `part`.
std::optional<int> GrowingPlan::lightest_of(const std::vector<std::vector<int>>& stuck, const Members& members,
                                            std::size_t part) const {
    std::optional<int> lightest;
    double least = Box::kInfinity;
    for (const std::vector<int>& set : stuck) {
        for (const int i : set) {
            const std::size_t member = members[static_cast<std::size_t>(i)];
            if (member == part || parts_[member].object.fixed || weight(member) >= least) continue;
            lightest = i;
            least = weight(member);
        }
    }
    return lightest;
}

/// Plans for members that stand by themselves. Where they hold each other, those that are lighter than `part` together are
/// discarded if that helps and may be done `instead`.
std::optional<GrowingPlan::Apart> GrowingPlan::take_apart(const Members& members, std::size_t part, bool instead) {
    const DisassemblySetup setup = setup_of(members);
    Disassembler disassembler(setup, parts_of(members), [](int, int) {});
    Apart apart;
    double discarded = 0;
    bool all = false;
    for (;;) {
        disassembler.run();
        all = disassembler.standing() == 0;
        if (all || !instead || setup_.stop.stopped()) break;
        const std::optional<int> lightest = lightest_of(disassembler.stuck(), members, part);
        if (!lightest) break;
        const std::size_t member = members[static_cast<std::size_t>(*lightest)];
        discarded += weight(member);
        if (discarded >= weight(part)) break;
        disassembler.discard(*lightest);
        apart.discarded.emplace_back(member, disassembler.steps().size());
    }
    fills_ += disassembler.counts().fills;
    if (!all) return std::nullopt;
    apart.steps = disassembler.steps();
    for (RemovalStep& step : apart.steps) {
        for (int& i : step.placements) {
            i = static_cast<int>(members[static_cast<std::size_t>(i)]);
        }
    }
    return apart;
}

bool GrowingPlan::let(std::size_t part, std::size_t most, bool instead) {
    const std::size_t after = discarded_after_[part];
    Companies companies(parts_.size());
    std::vector<Step> plan;
    std::size_t k = 0;
    for (; k < steps_.size() && steps_[k].number < after; ++k) {
        companies.make(steps_[k].step);
        plan.push_back(steps_[k]);
    }
    const int company = companies.of(part);
    const std::vector<Box> boxes = boxes_of(parts_);
    Trial trial{{}, std::vector<bool>(parts_.size(), false), StandingHull(boxes), StandingHull(boxes)};
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool member = companies.of(i) == company;
        if (!member || i == part) trial.going.remove(i);
        if (!member || (is_out(i) && i != part)) trial.standing.remove(i);
    }
    const auto standing = [&] {
        Members members;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (companies.of(i) == company && (!is_out(i) || i == part)) members.push_back(i);
        }
        return members;
    };
    trial.wait(part);
    bool early = false;  // it left before the others' end
    std::vector<Since> unknown_from;  // of those that are out: steps from that number on know nothing of them any more
    for (; k < steps_.size(); ++k) {
        const Step& planned = steps_[k];
        if (early || companies.of(planned.step) != company) {
            companies.make(planned.step);
            plan.push_back(planned);
            continue;
        }
        const Members moving = movers(planned.step);
        const bool waits = std::any_of(moving.begin(), moving.end(), [&](std::size_t i) { return trial.waits[i]; });
        std::optional<Path> path = planned.step.path;
        if (!moving.empty()) path = waits ? std::nullopt : past(moving, *path, trial);
        if (!path && trial.waiting.size() == 1) {
            if (std::optional<Path> way = way_out(part, standing())) {
                for (std::size_t i = 0; i < parts_.size(); ++i) {
                    const bool clear = outside(at_end(boxes[part], *way), boxes[i]) && free_of({part}, *way, {i});
                    if (is_out(i) && i != part && companies.of(i) == company && !clear) {
                        unknown_from.emplace_back(i, planned.number);
                    }
                }
                plan.push_back({{{static_cast<int>(part)}, std::move(*way)}, planned.number});
                trial.waiting.clear();
                early = true;
                --k;
                continue;
            }
        }
        for (const int i : planned.step.placements) {
            const auto member = static_cast<std::size_t>(i);
            if (is_out(member) && (!path || !free_of({member}, *path, trial.waiting))) {
                unknown_from.emplace_back(member, planned.number);
            }
        }
        for (const std::size_t i : moving) {
            if (trial.waits[i]) continue;
            trial.going.remove(i);
            if (path) {
                trial.standing.remove(i);
            } else {
                trial.wait(i);
            }
        }
        if (trial.waiting.size() > most) return false;
        if (!path) continue;
        companies.make(planned.step);
        plan.push_back({{planned.step.placements, std::move(*path)}, planned.number});
    }

    std::vector<Since> discarded;
    if (!early) {
        // Those that wait are taken apart by themselves.
        Members members = trial.waiting;
        std::sort(members.begin(), members.end());
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (parts_[i].object.fixed && companies.of(i) == company) members.push_back(i);
        }
        std::optional<Apart> apart = take_apart(members, part, instead);
        if (!apart) return false;
        for (const auto& [member, steps] : apart->discarded) {
            discarded.emplace_back(member, next_number_ + steps);
        }
        for (RemovalStep& step : apart->steps) {
            plan.push_back({std::move(step), next_number_++});
        }
    }
    steps_ = std::move(plan);
    discarded_after_[part] = kStayed;
    for (const auto& [member, number] : unknown_from) {
        discarded_after_[member] = std::min(discarded_after_[member], number);
    }
    for (const auto& [member, number] : discarded) {
        discarded_after_[member] = number;
    }
    return true;
}

}  // namespace spectralpack
