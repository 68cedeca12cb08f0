#include "packing/interlocking.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <set>
#include <unordered_set>
#include <utility>

#include "disassembly/blocking_graph.hpp"
#include "packing/reachable_search.hpp"
#include "refine/refiner.hpp"
#include "voxel/voxelize.hpp"

namespace spectralpack {
namespace {

using Clock = std::chrono::steady_clock;

// SelectRemove of Algorithm 4: until their boxes are more than this share of all.
constexpr double kShareToRemove = 0.1;
// Rays per voxel and axis: every copy of a voxel or more is seen.
constexpr double kRaysPerVoxel = 1;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Those of `set`, which hold each other, that are taken out before trying again. Fixed copies stay.
std::vector<int> select_remove(const std::vector<int>& set, const std::vector<StandingPart>& parts, TakeOut rule) {
    struct Candidate {
        int part;
        double box, solid;  // volumes
    };
    std::vector<Candidate> candidates;
    double boxes = 0;
    for (const int i : set) {
        const StandingPart& part = parts[static_cast<std::size_t>(i)];
        if (part.object.fixed) continue;
        candidates.push_back({i, part.box().volume(), static_cast<double>(part.object.solid->count())});
        boxes += candidates.back().box;
    }
    if (candidates.empty()) return {};
    const auto rank = [&](const Candidate& of) {
        return rule == TakeOut::smallest ? of.box : rule == TakeOut::lightest ? of.solid : of.solid / of.box;
    };
    const auto before = [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); };
    if (rule != TakeOut::smallest) {
        return {std::min_element(candidates.begin(), candidates.end(), before)->part};
    }
    std::stable_sort(candidates.begin(), candidates.end(), before);
    std::vector<int> removed;
    double sum = 0;
    for (const Candidate& candidate : candidates) {
        if (sum > kShareToRemove * boxes) break;
        removed.push_back(candidate.part);
        sum += candidate.box;
    }
    return removed;
}

/// The steps without the copies that are not there any more, `renumbered` to -1. Groups that are one copy then, or all
/// that is left of their company, are groups no more: a copy's first step alone is its own. `fixed` more copies stand with
/// all, and never leave.
std::vector<RemovalStep> remaining_steps(const std::vector<RemovalStep>& steps, const std::vector<int>& renumbered,
                                         std::size_t fixed) {
    constexpr int kOut = -1;
    std::vector<int> company(renumbered.size(), kOut);
    std::vector<std::size_t> standing(1, fixed);  // by company
    for (std::size_t i = 0; i < renumbered.size(); ++i) {
        if (renumbered[i] < 0) continue;
        company[i] = 0;
        ++standing[0];
    }
    std::vector<RemovalStep> result;
    for (const RemovalStep& step : steps) {
        std::vector<std::size_t> members;
        RemovalStep rest{{}, step.path};
        for (const int i : step.placements) {
            if (company[static_cast<std::size_t>(i)] == kOut) continue;
            members.push_back(static_cast<std::size_t>(i));
            rest.placements.push_back(renumbered[static_cast<std::size_t>(i)]);
        }
        if (members.empty()) continue;
        const auto from = static_cast<std::size_t>(company[members.front()]);
        if (members.size() > 1 && members.size() == standing[from]) continue;
        int to = kOut;
        if (members.size() > 1) {
            to = static_cast<int>(standing.size());
            standing.push_back(members.size());
        }
        standing[from] -= members.size();
        for (const std::size_t i : members) {
            company[i] = to;
        }
        if (standing[from] == 0) rest.path.clear();
        result.push_back(std::move(rest));
    }
    return result;
}

class Untangling {
  public:
    Untangling(Tray& tray, PlacementSearch& search, std::vector<PlacedItem>& placed, const InterlockSetup& setup,
               const StopToken& stop)
        : tray_(tray), search_(search), placed_(placed), setup_(setup), stop_(stop) {
        disassembly_.search = &search;
        disassembly_.grid = setup.walls ? setup.walls->grid : finest_setup(tray.setup());
        disassembly_.corner =
            setup.walls ? setup.walls->corner : Vec3{setup.wall_gap, setup.wall_gap, setup.wall_gap};
        disassembly_.ray_spacing = disassembly_.grid.voxel_size / kRaysPerVoxel;
        disassembly_.on_grid = [this](int i) {
            const PlacedItem& item = placed_[static_cast<std::size_t>(i)];
            const Mesh mesh = setup_.surfaces->turned_mesh(item.item.part, item.orientation);
            return std::make_shared<const BitGrid>(voxelize(mesh, disassembly_.grid.voxel_size, setup_.workers));
        };
        disassembly_.workers = setup.workers;
        disassembly_.stop = stop;
    }

    Untangled run() {
        const auto start = Clock::now();
        const std::vector<PlacedItem> removed = disassemble();
        result_.report.disassemble_seconds = seconds_since(start);
        const auto reinserting = Clock::now();
        if (!removed.empty()) {
            put_back(removed);
            result_.report.least_gap = least_gap();
        }
        result_.report.reinsert_seconds = seconds_since(reinserting);
        return std::move(result_);
    }

  private:
    std::vector<StandingPart> standing() {
        std::vector<TurnedPart> wanted;
        for (const PlacedItem& item : placed_) {
            wanted.push_back({item.item.part, item.orientation});
        }
        setup_.surfaces->make(wanted);
        std::vector<StandingPart> parts;
        for (const PlacedItem& item : placed_) {
            parts.push_back(as_standing(item));
        }
        return parts;
    }

    StandingPart as_standing(const PlacedItem& item) {
        return {setup_.surfaces->at(item.item.part, item.orientation), item.offset,
                in_grid(tray_.object(item.object))};
    }

    /// An object of the tray in the grid that ways out are looked for in.
    TrayObject in_grid(const TrayObject& object) const {
        return setup_.walls ? setup_.walls->moved(on_finest(object)) : on_finest(object);
    }

    /// The fixed ones come after all others, so that names are indices into `placed`.
    void add_fixed(std::vector<StandingPart>& parts) const {
        for (StandingPart part : setup_.fixed) {
            part.object = in_grid(part.object);
            part.object.fixed = true;
            parts.push_back(std::move(part));
        }
    }

    /// All that stays: fixed copies, and the walls of a physical container.
    void add_what_stays(std::vector<StandingPart>& parts) const {
        add_fixed(parts);
        if (setup_.walls) parts.push_back(setup_.walls->part);
    }

    std::optional<double> least_gap() {
        Refiner refiner(RefineSetup{tray_.setup().size});
        std::vector<StandingPart> parts = standing();
        add_fixed(parts);
        for (const StandingPart& part : parts) {
            refiner.add({part.surface, part.offset});
        }
        return refiner.least_gap();
    }

    /// Plans, and takes out what is in the way of that. Returns it, in the order in which it was placed.
    std::vector<PlacedItem> disassemble() {
        std::vector<StandingPart> parts = standing();
        const std::size_t movable = parts.size();
        add_what_stays(parts);
        std::vector<bool> removed(parts.size(), false);
        Disassembler disassembler(disassembly_, parts, setup_.left);
        for (;;) {
            disassembler.run();
            if (stop_.stopped()) break;
            const std::vector<std::vector<int>> sets = disassembler.stuck();
            if (sets.empty()) break;
            for (const std::vector<int>& set : sets) {
                for (const int i : select_remove(set, parts, setup_.take_out)) {
                    disassembler.discard(i);
                    removed[static_cast<std::size_t>(i)] = true;
                }
            }
        }
        result_.report.counts = disassembler.counts();
        result_.report.counts.removed = static_cast<int>(std::count(removed.begin(), removed.end(), true));
        result_.plan.complete = disassembler.standing() == 0;
        std::vector<PlacedItem> kept, out;
        std::vector<int> renumbered(parts.size(), -1);
        for (std::size_t i = 0; i < movable; ++i) {
            if (removed[i]) {
                if (Caps* caps = setup_.limits.caps) {
                    caps->remove(placed_[i].item.part, placed_[i].orientation, placed_[i].offset);
                }
                tray_.remove(placed_[i].object);
                out.push_back(placed_[i]);
            } else {
                renumbered[i] = static_cast<int>(kept.size());
                kept.push_back(placed_[i]);
            }
        }
        result_.plan.steps = remaining_steps(disassembler.steps(), renumbered, parts.size() - movable);
        placed_ = std::move(kept);
        return out;
    }

    void put_back(const std::vector<PlacedItem>& removed) {
        std::vector<PackItem> items;
        for (const PlacedItem& item : removed) {
            items.push_back(item.item);
        }
        const std::set<PackItem> taken_out(items.begin(), items.end());
        items.insert(items.end(), setup_.waiting.begin(), setup_.waiting.end());
        std::map<PackItem, std::size_t> rank;
        for (const PackItem& item : setup_.order) {
            rank.emplace(item, rank.size());
        }
        std::stable_sort(items.begin(), items.end(),
                         [&](const PackItem& a, const PackItem& b) { return rank[a] < rank[b]; });
        std::vector<StandingPart> parts = standing();
        std::vector<int> names(parts.size());
        std::iota(names.begin(), names.end(), 0);
        add_what_stays(parts);
        names.resize(parts.size(), -1);
        Company company(disassembly_, names, parts);
        ShapeStore& shapes = *setup_.shapes;
        shapes.start_tray(items);
        ReachableSearch reachable(search_, setup_.walls);
        std::unordered_set<int> hopeless;
        std::vector<RemovalStep> steps;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const bool again = !stop_.stopped() && !hopeless.contains(items[i].part) &&
                               put_in(items[i], shapes.at(i), reachable, company, steps);
            const bool was_taken_out = taken_out.contains(items[i]);
            if (!again) {
                hopeless.insert(items[i].part);
                if (was_taken_out && !stop_.stopped()) result_.interlocked.push_back(items[i]);
            } else {
                ++(was_taken_out ? result_.report.counts.reinserted : result_.report.counts.added);
            }
            shapes.release(i, again);
            setup_.to_put_back(static_cast<int>(items.size() - i - 1), static_cast<int>(items.size()));
        }
        // The last one put in comes out first.
        std::reverse(steps.begin(), steps.end());
        result_.plan.steps.insert(result_.plan.steps.begin(), std::make_move_iterator(steps.begin()),
                                  std::make_move_iterator(steps.end()));
    }

    bool put_in(const PackItem& item, const Shape& shape, ReachableSearch& reachable, Company& company,
                std::vector<RemovalStep>& steps) {
        Caps* caps = setup_.limits.caps;
        if (caps && !caps->why_not(item.part).empty()) return false;
        const SearchResult found =
            find_place(tray_, reachable, setup_.model, item, shape, setup_.limits, stop_);
        if (!found.best) return false;
        Standing standing =
            stand_on_grid(shape, *found.best, setup_.voxel_size, tray_.detail(), setup_.wall_gap);
        const int orientation = shape.orientations[static_cast<std::size_t>(found.best->index)].orientation;
        PlacedItem placed{item, orientation, found.best->position, standing.offset, 0, found.best->cost};
        placed.object = tray_.add(std::move(standing.object));
        placed_.push_back(placed);
        const int name = static_cast<int>(placed_.size()) - 1;
        const std::size_t i = company.add(name, as_standing(placed));
        std::optional<Company::Path> path = way_out(company, i);
        if (!path) {
            company.remove(i);
            tray_.remove(placed.object);
            placed_.pop_back();
            return false;
        }
        if (caps) caps->add(item.part, orientation, placed.offset);
        steps.push_back({{name}, std::move(*path)});
        return true;
    }

    static std::optional<Company::Path> way_out(const Company& company, std::size_t i) {
        for (int d = 0; d < BlockingGraph::kDirections; ++d) {
            Company::Straight straight = company.straight_way({i}, BlockingGraph::direction(d));
            if (!straight.met) return std::move(straight.path);
        }
        return company.way_out(i).path;
    }

    Tray& tray_;
    PlacementSearch& search_;
    std::vector<PlacedItem>& placed_;
    const InterlockSetup& setup_;
    StopToken stop_;
    DisassemblySetup disassembly_;
    Untangled result_;
};

}  // namespace

Untangled untangle(Tray& tray, PlacementSearch& search, std::vector<PlacedItem>& placed, const InterlockSetup& setup,
                   const StopToken& stop) {
    return Untangling(tray, search, placed, setup, stop).run();
}

Disassembly plan_disassembly(const DisassemblySetup& setup, std::vector<StandingPart> parts, std::size_t copies,
                             const Disassembler::Left& left) {
    Disassembler disassembler(setup, std::move(parts), left);
    disassembler.run();
    Disassembly plan;
    plan.steps = disassembler.steps();
    if (!setup.stop.stopped()) plan.interlocked = disassembler.stuck();
    for (std::vector<int>& set : plan.interlocked) {
        std::erase_if(set, [&](int part) { return static_cast<std::size_t>(part) >= copies; });
    }
    plan.complete = disassembler.standing() == 0;
    return plan;
}

}  // namespace spectralpack
