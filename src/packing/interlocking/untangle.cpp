#include "packing/interlocking/untangle.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>

#include "core/stopwatch.hpp"
#include "disassembly/plan_repair.hpp"
#include "disassembly/remaining_steps.hpp"
#include "packing/interlocking/reachable_search.hpp"
#include "packing/interlocking/removable_packing.hpp"
#include "refine/refiner.hpp"

namespace spectralpack {
namespace {

// SelectRemove of Algorithm 4: until their boxes are more than this share of all.
constexpr double kShareToRemove = 0.1;

/// Those of `set`, which hold each other, that are taken out before trying again. Fixed copies stay.
std::vector<int> select_remove(const std::vector<int>& set, const std::vector<Body>& parts, TakeOut rule) {
    struct Candidate {
        int part;
        double box, solid;  // volumes
    };
    std::vector<Candidate> candidates;
    double boxes = 0;
    for (const int i : set) {
        const Body& part = parts[static_cast<std::size_t>(i)];
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

/// A position of an orientation of a shape.
struct Place {
    int index;  ///< in Shape::orientations
    VoxelIndex position;
};
using Places = std::vector<Place>;

// Where a copy does not come out it is tried elsewhere, up to so many places in all. More find none that these do not.
constexpr int kPlacesTried = 4;

/// Whether a copy's boxes there have their centres less than half a box apart along every axis: in the same hole.
bool near(const Shape& shape, const Place& a, const Place& b) {
    const Extent& at_a = shape.orientations[static_cast<std::size_t>(a.index)].solid.extent();
    const Extent& at_b = shape.orientations[static_cast<std::size_t>(b.index)].solid.extent();
    for (int axis = 0; axis < 3; ++axis) {
        const int twice = 2 * (a.position[axis] - b.position[axis]) + at_a[axis] - at_b[axis];
        if (std::abs(twice) >= std::min(at_a[axis], at_b[axis])) return false;
    }
    return true;
}

class Untangling {
  public:
    Untangling(Tray& tray, PlacementSearch& search, std::vector<PlacedCopy>& placed, const UntangleOptions& options,
               const StopToken& stop)
        : tray_(tray),
          search_(search),
          placed_(placed),
          options_(options),
          stop_(stop),
          standing_(options, tray, placed, search, stop) {}

    Untangled run() {
        const Stopwatch disassembling;
        const bool open = tray_.setup().ceiling == Ceiling::open;
        const double before = open ? height() : 0;
        const std::vector<PlacedCopy> removed = disassemble();
        result_.report.disassemble_seconds = disassembling.seconds();
        const Stopwatch reinserting;
        const double voxelizing = options_.shapes->seconds();
        if (!removed.empty()) {
            put_back(removed);
            if (open && height() > before + options_.voxel_size) pack_anew_if_lower();
            result_.report.changed = true;
            if (options_.measure_gap) result_.report.least_gap = least_gap();
        }
        result_.report.reinsert_seconds = reinserting.seconds() - (options_.shapes->seconds() - voxelizing);
        return std::move(result_);
    }

  private:
    std::optional<double> least_gap() {
        Refiner refiner(RefineOptions{tray_.setup().size});
        std::vector<Body> parts = standing_.placed();
        standing_.add_fixed(parts);
        for (const Body& part : parts) {
            refiner.add({part.surface, part.offset});
        }
        return refiner.least_gap(options_.workers);
    }

    /// Plans, and takes out what is in the way of that. Returns it, in the order in which it was placed.
    std::vector<PlacedCopy> disassemble() {
        std::vector<Body> parts = standing_.placed();
        const std::size_t movable = parts.size();
        standing_.add_what_stays(parts);
        std::vector<std::size_t> discarded_after(parts.size(), PlanRepair::kStayed);
        Disassembler disassembler(standing_.disassembly(), parts, options_.left);
        for (;;) {
            disassembler.run();
            if (stop_.stopped()) break;
            const std::vector<std::vector<int>> sets = disassembler.stuck();
            if (sets.empty()) break;
            for (const std::vector<int>& set : sets) {
                for (const int i : select_remove(set, parts, options_.take_out)) {
                    disassembler.discard(i);
                    discarded_after[static_cast<std::size_t>(i)] = disassembler.steps().size();
                }
            }
        }
        PlanRepair plan(standing_.disassembly(), parts, disassembler.steps(), std::move(discarded_after));
        let_back(plan, parts);
        result_.report.counts = disassembler.counts();
        result_.report.counts.fills += plan.fills();
        result_.plan.complete = disassembler.standing() == 0;
        std::vector<PlacedCopy> kept, out;
        std::vector<int> renumbered(parts.size(), -1);
        for (std::size_t i = 0; i < movable; ++i) {
            if (plan.out(static_cast<int>(i))) {
                ++result_.report.counts.removed;
                freed_.push_back(tray_.object(placed_[i].object).box());
                remove_from_tray(placed_[i]);
                out.push_back(placed_[i]);
            } else {
                renumbered[i] = static_cast<int>(kept.size());
                kept.push_back(placed_[i]);
            }
        }
        result_.plan.steps = remaining_steps(plan.steps(), renumbered, parts.size() - movable);
        placed_ = std::move(kept);
        return out;
    }

    /// Lets stand what may after all of what was taken out, the heaviest first.
    void let_back(PlanRepair& plan, const std::vector<Body>& parts) {
        struct Out {
            int part;
            std::int64_t voxels;
        };
        std::vector<Out> all;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (plan.out(static_cast<int>(i))) all.push_back({static_cast<int>(i), parts[i].object.solid->count()});
        }
        std::ranges::stable_sort(all, std::ranges::greater{}, &Out::voxels);
        for (std::size_t k = 0; k < all.size() && !stop_.stopped(); ++k) {
            plan.let_back(all[k].part);
            options_.to_put_back(static_cast<int>(all.size() - k - 1), static_cast<int>(all.size()));
        }
    }

    /// mm, of what was placed.
    double height() {
        double top = 0;
        for (const Body& part : standing_.placed()) {
            top = std::max(top, part.box().max.z);
        }
        return top;
    }

    /// Tells where copies are tried first.
    PlacementSearch& best_search() { return options_.best ? *options_.best : search_; }

    void remove_from_tray(const PlacedCopy& copy) {
        if (Caps* caps = options_.limits.caps) caps->remove(copy.number.part, copy.orientation, copy.offset);
        tray_.remove(copy.object);
    }

    void put_back(const std::vector<PlacedCopy>& removed) {
        std::vector<Copy> copies;
        for (const PlacedCopy& copy : removed) {
            copies.push_back(copy.number);
        }
        const std::set<Copy> taken_out(copies.begin(), copies.end());
        copies.insert(copies.end(), options_.waiting.begin(), options_.waiting.end());
        put_in(std::move(copies), taken_out);
    }

    /// Under an open ceiling what was taken out always finds a place, if only on top of all. Where that made the
    /// packing higher, all is packed once more, each copy where it comes out from among those before it; the lower one
    /// stays.
    void pack_anew_if_lower() {
        const double height_now = height();
        Untangled repaired = std::exchange(result_, {});
        const std::vector<PlacedCopy> placed = std::exchange(placed_, {});
        std::vector<TrayObject> objects;
        for (const PlacedCopy& copy : placed) {
            objects.push_back(tray_.object(copy.object));
            remove_from_tray(copy);
        }
        result_.plan.complete = true;
        best_search().forget();
        put_in(options_.order, {});
        if (!stop_.stopped() && placed_.size() >= placed.size() && height() < height_now) {
            result_.report.counts = {.fills = repaired.report.counts.fills + result_.report.counts.fills};
            result_.report.disassemble_seconds = repaired.report.disassemble_seconds;
            return;
        }
        for (const PlacedCopy& copy : placed_) {
            remove_from_tray(copy);
        }
        placed_ = placed;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (Caps* caps = options_.limits.caps)
                caps->add(placed_[i].copy.part, placed_[i].orientation, placed_[i].offset);
            placed_[i].object = tray_.add(std::move(objects[i]));
        }
        result_ = std::move(repaired);
    }

    /// What goes on while copies are put in.
    struct Pass {
        RemovablePacking packing;
        ReachableSearch reachable;
        std::map<int, Places> refused;  ///< by part: where one copy did not come out, another does not
        int most_places;                ///< tried of each copy; where it is 1, none are called refused
    };

    /// In the order of the job.
    void put_in(std::vector<Copy> copies, const std::set<Copy>& taken_out) {
        std::map<Copy, std::size_t> rank;
        for (const Copy& copy : options_.order) {
            rank.emplace(copy, rank.size());
        }
        std::stable_sort(copies.begin(), copies.end(), [&](const Copy& a, const Copy& b) { return rank[a] < rank[b]; });
        // Without a ceiling there is always one that can be reached, and others take long to find.
        const int places = tray_.setup().ceiling == Ceiling::open ? 1 : kPlacesTried;
        Pass pass{
            RemovablePacking(standing_, result_.plan.steps), ReachableSearch(search_, options_.walls), {}, places};
        ShapeStore& shapes = *options_.shapes;
        shapes.start_tray(copies, ShapeStore::kAheadOfWays);
        std::unordered_set<int> hopeless;
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const bool was_taken_out = taken_out.contains(copies[i]);
            const bool again = !stop_.stopped() && !hopeless.contains(copies[i].part) &&
                               put_in(copies[i], asked(shapes.at(i), was_taken_out), pass);
            if (!again) {
                hopeless.insert(copies[i].part);
                if (was_taken_out && !stop_.stopped()) result_.interlocked.push_back(copies[i]);
            } else {
                ++(was_taken_out ? result_.report.counts.reinserted : result_.report.counts.added);
            }
            shapes.release(i, again);
            options_.to_put_back(static_cast<int>(copies.size() - i - 1), static_cast<int>(copies.size()));
        }
        result_.plan.steps = pass.packing.steps();
        result_.report.counts.fills += pass.packing.fills();
    }

    /// A copy that had no room before has some only where something was taken out, unless caps or a ceiling that goes
    /// up make room elsewhere.
    Shape asked(const Shape& shape, bool was_taken_out) const {
        Shape asked = shape;
        const bool full =
            options_.waiting_had_no_room && !options_.limits.caps && tray_.setup().ceiling == Ceiling::closed;
        if (full && !was_taken_out) asked.only_near = freed_;
        return asked;
    }

    /// At the best place from which it comes out once its turn comes, of the first few that are not near one another,
    /// or else at the best that is reachable now.
    bool put_in(const Copy& copy, const Shape& shape, Pass& pass) {
        const Caps* caps = options_.limits.caps;
        if (caps && !caps->why_not(copy.part).empty()) return false;
        const auto place_of = [&](PlacementSearch& search, const Shape& asked) {
            return find_place(tray_, search, options_.model, copy, asked, options_.limits, stop_).best;
        };
        Places& refused = pass.refused[copy.part];
        Shape elsewhere = shape;
        elsewhere.admits = [&](int index, const VoxelIndex& q) {
            return std::ranges::none_of(refused, [&](const Place& place) { return near(shape, place, {index, q}); });
        };
        int tried = 0;
        for (; tried < pass.most_places; ++tried) {
            const std::optional<BestPlacement> best = place_of(best_search(), refused.empty() ? shape : elsewhere);
            if (!best) break;
            if (put_at(*best, copy, shape, pass.packing)) return true;
            if (pass.most_places > 1) refused.push_back({best->index, best->position});
        }
        if (tried == 0 && refused.empty()) return false;  // there is no place at all
        const std::optional<BestPlacement> best = place_of(pass.reachable, shape);
        return best && put_at(*best, copy, shape, pass.packing);
    }

    bool put_at(const BestPlacement& place, const Copy& copy, const Shape& shape, RemovablePacking& packing) {
        Settled standing = settle_on_grid(shape, place, options_.voxel_size, tray_.detail(), options_.wall_gap);
        const int orientation = shape.orientations[static_cast<std::size_t>(place.index)].orientation;
        PlacedCopy placed{copy, orientation, place.position, standing.offset, 0, place.cost};
        placed_.push_back(placed);
        if (!packing.admit(placed, standing.object)) {
            placed_.pop_back();
            return false;
        }
        // Not before: engines keep what they know while objects are only added.
        placed_.back().object = tray_.add(std::move(standing.object));
        if (Caps* caps = options_.limits.caps) caps->add(copy.part, orientation, placed.offset);
        return true;
    }

    Tray& tray_;
    PlacementSearch& search_;
    std::vector<PlacedCopy>& placed_;
    const UntangleOptions& options_;
    StopToken stop_;
    PlacedBodies standing_;
    std::vector<VoxelBox> freed_;  // where copies were taken out
    Untangled result_;
};

}  // namespace

Untangled untangle(Tray& tray, PlacementSearch& search, std::vector<PlacedCopy>& placed, const UntangleOptions& options,
                   const StopToken& stop) {
    return Untangling(tray, search, placed, options, stop).run();
}

Disassembly plan_disassembly(const DisassemblyOptions& options, std::vector<Body> parts, std::size_t copies,
                             const Disassembler::Left& left, const std::vector<RemovalStep>* told) {
    Disassembler disassembler(options, std::move(parts), left, told);
    disassembler.run();
    Disassembly plan;
    plan.steps = disassembler.steps();
    if (!options.stop.stopped()) plan.interlocked = disassembler.stuck();
    for (std::vector<int>& set : plan.interlocked) {
        std::erase_if(set, [&](int part) { return static_cast<std::size_t>(part) >= copies; });
    }
    plan.complete = disassembler.standing() == 0;
    return plan;
}

}  // namespace spectralpack
