#include "disassembly/plan_repair.hpp"

#include <algorithm>
#include <numeric>

#include "disassembly/letting.hpp"
#include "disassembly/ways/moves.hpp"
#include "disassembly/ways_out.hpp"
#include "geometry/slides_past.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kMostChanged = 2;  // more than one in so many, and the subassembly is made anew

double weight(const Body& part) { return static_cast<double>(part.object.solid->count()); }

}  // namespace

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
    return any_way_out(*subassembly_, places_[part]);
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

}  // namespace spectralpack
