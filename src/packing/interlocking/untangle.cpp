#include "packing/interlocking/untangle.hpp"

#include <algorithm>
#include <utility>

#include "core/stopwatch.hpp"
#include "disassembly/plan_repair.hpp"
#include "disassembly/remaining_steps.hpp"
#include "packing/interlocking/put_back.hpp"
#include "packing/tray/decisions_fit.hpp"
#include "refine/refiner.hpp"

namespace spectralpack {
namespace {

// SelectRemove of Algorithm 4: until their boxes are more than this share of all.
constexpr double kShareToRemove = 0.1;

/// Those of `set`, which hold each other, that are taken out before trying again. Fixed copies stay.
std::vector<int> select_remove(const std::vector<int>& set, const std::vector<Body>& bodies, TakeOut rule) {
    struct Candidate {
        int index;
        double box, solid;  // volumes
    };
    std::vector<Candidate> candidates;
    double boxes = 0;
    for (const int i : set) {
        const Body& body = bodies[static_cast<std::size_t>(i)];
        if (body.object.fixed) continue;
        candidates.push_back({i, body.box().volume(), static_cast<double>(body.object.solid->count())});
        boxes += candidates.back().box;
    }
    if (candidates.empty()) return {};
    const auto rank = [&](const Candidate& of) {
        return rule == TakeOut::smallest ? of.box : rule == TakeOut::lightest ? of.solid : of.solid / of.box;
    };
    const auto before = [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); };
    if (rule != TakeOut::smallest) {
        return {std::min_element(candidates.begin(), candidates.end(), before)->index};
    }
    std::stable_sort(candidates.begin(), candidates.end(), before);
    std::vector<int> removed;
    double sum = 0;
    for (const Candidate& candidate : candidates) {
        if (sum > kShareToRemove * boxes) break;
        removed.push_back(candidate.index);
        sum += candidate.box;
    }
    return removed;
}

class Untangling {
  public:
    Untangling(Tray& tray, std::vector<PlacedCopy>& placed, const TrayContext& context, const UntangleOptions& options)
        : tray_(tray), placed_(placed), context_(context), options_(options), bodies_(options, tray, placed, context) {}

    Untangled run() {
        const Stopwatch disassembling;
        const bool open = tray_.setup().ceiling == Ceiling::open;
        const double before = open ? height() : 0;
        const std::vector<PlacedCopy> removed = disassemble();
        result_.report.disassemble_seconds = disassembling.seconds();
        const Stopwatch reinserting;
        const double voxelizing = context_.shapes.seconds();
        if (!options_.repair) {
            for (const PlacedCopy& placed : removed) {
                result_.interlocked.push_back(placed.copy);
            }
        } else if (!removed.empty()) {
            put_back_what_was(removed);
            if (open && height() > before + options_.voxel_size) pack_anew_if_lower();
            result_.report.changed = true;
            if (options_.measure_gap) result_.report.least_gap = least_gap();
        }
        result_.report.reinsert_seconds = reinserting.seconds() - (context_.shapes.seconds() - voxelizing);
        return std::move(result_);
    }

  private:
    std::optional<double> least_gap() {
        Refiner refiner(RefineOptions{tray_.setup().size});
        std::vector<Body> bodies = bodies_.placed();
        bodies_.add_fixed(bodies);
        for (const Body& body : bodies) {
            refiner.add({body.surface, body.offset});
        }
        return refiner.least_gap(context_.workers);
    }

    /// Plans, and takes out what is in the way of that. Returns it, in the order in which it was placed.
    std::vector<PlacedCopy> disassemble() {
        std::optional<TakenApart> known;
        if (context_.decisions) known = context_.decisions->recall_taken_apart();
        if (known) {
            require_fit(known->out, placed_.size());
            require_fit(known->plan, placed_.size() - known->out.size(), options_.fixed.size() + 1);  // walls
        }
        TakenApart apart = known ? std::move(*known) : take_apart();
        if (context_.decisions && !known && !context_.stop.stopped()) context_.decisions->keep(apart);
        result_.report.counts = apart.counts;
        result_.plan = std::move(apart.plan);
        std::vector<PlacedCopy> kept, out;
        auto next_out = apart.out.begin();
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const bool is_out = next_out != apart.out.end() && static_cast<std::size_t>(*next_out) == i;
            if (!is_out) {
                kept.push_back(placed_[i]);
                continue;
            }
            ++next_out;
            freed_.push_back(tray_.object(placed_[i].object).box());
            remove_from_tray(placed_[i]);
            out.push_back(placed_[i]);
        }
        placed_ = std::move(kept);
        for (const PlacedCopy& placed : out) {
            if (context_.observer) context_.observer->copy_taken_out(placed);
        }
        return out;
    }

    TakenApart take_apart() {
        std::vector<Body> bodies = bodies_.placed();
        const std::size_t movable = bodies.size();
        bodies_.add_what_stays(bodies);
        std::vector<std::size_t> discarded_after(bodies.size(), PlanRepair::kStayed);
        Disassembler disassembler(bodies_.disassembly(), bodies, options_.left);
        for (;;) {
            disassembler.run();
            if (context_.stop.stopped()) break;
            const std::vector<std::vector<int>> sets = disassembler.stuck();
            if (sets.empty()) break;
            for (const std::vector<int>& set : sets) {
                for (const int i : select_remove(set, bodies, options_.take_out)) {
                    disassembler.discard(i);
                    discarded_after[static_cast<std::size_t>(i)] = disassembler.steps().size();
                }
            }
        }
        PlanRepair plan(bodies_.disassembly(), bodies, disassembler.steps(), std::move(discarded_after));
        let_back(plan, bodies);
        TakenApart apart;
        apart.counts = disassembler.counts();
        apart.counts.fills += plan.fills();
        apart.plan.complete = disassembler.standing() == 0;
        std::vector<int> renumbered(bodies.size(), -1);
        int kept = 0;
        for (std::size_t i = 0; i < movable; ++i) {
            if (plan.out(static_cast<int>(i))) {
                apart.out.push_back(static_cast<int>(i));
            } else {
                renumbered[i] = kept++;
            }
        }
        apart.counts.removed += static_cast<int>(apart.out.size());
        apart.plan.steps = remaining_steps(plan.steps(), renumbered, bodies.size() - movable);
        return apart;
    }

    /// Lets stand what may after all of what was taken out, the heaviest first.
    void let_back(PlanRepair& plan, const std::vector<Body>& bodies) {
        struct Out {
            int index;
            std::int64_t voxels;
        };
        std::vector<Out> all;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (plan.out(static_cast<int>(i))) all.push_back({static_cast<int>(i), bodies[i].object.solid->count()});
        }
        std::ranges::stable_sort(all, std::ranges::greater{}, &Out::voxels);
        for (std::size_t k = 0; k < all.size() && !context_.stop.stopped(); ++k) {
            plan.let_back(all[k].index);
            options_.to_put_back(static_cast<int>(all.size() - k - 1), static_cast<int>(all.size()));
        }
    }

    /// mm, of what was placed.
    double height() {
        double top = 0;
        for (const Body& body : bodies_.placed()) {
            top = std::max(top, body.box().max.z);
        }
        return top;
    }

    void remove_from_tray(const PlacedCopy& placed) {
        if (Caps* caps = context_.limits.caps) caps->remove(placed.copy.part, placed.orientation, placed.offset);
        tray_.remove(placed.object);
    }

    void put_back_what_was(const std::vector<PlacedCopy>& removed) {
        std::vector<Copy> copies = order_of(removed);
        const std::set<Copy> taken_out(copies.begin(), copies.end());
        copies.insert(copies.end(), options_.waiting.begin(), options_.waiting.end());
        put_in({std::move(copies), taken_out, freed_, result_.plan.steps}, context_);
    }

    void put_in(PutBackWish wish, const TrayContext& context) {
        PutBackResult result = put_back({tray_, placed_, context, options_, bodies_}, std::move(wish));
        result_.plan.steps = std::move(result.steps);
        for (const Copy& copy : result.interlocked) {
            result_.interlocked.push_back(copy);
        }
        InterlockCounts& counts = result_.report.counts;
        counts.reinserted += result.put_back;
        counts.added += result.added;
        counts.fills += result.fills;
    }

    /// Under an open ceiling what was taken out always finds a place, if only on top of all. Where that made the
    /// packing higher, all is packed once more, each copy where it comes out from among those before it; the lower one
    /// stays. The observer is told of what stays in the end.
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
        (options_.best ? *options_.best : context_.search).forget();
        TrayContext unobserved = context_;
        unobserved.observer = nullptr;
        try {
            put_in({options_.order, {}, freed_, {}}, unobserved);
        } catch (...) {
            tell_anew();
            throw;
        }
        if (!context_.stop.stopped() && placed_.size() >= placed.size() && height() < height_now) {
            result_.report.counts = {.fills = repaired.report.counts.fills + result_.report.counts.fills};
            result_.report.disassemble_seconds = repaired.report.disassemble_seconds;
            tell_anew();
            return;
        }
        for (const PlacedCopy& copy : placed_) {
            remove_from_tray(copy);
        }
        placed_ = placed;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            PlacedCopy& copy = placed_[i];
            if (Caps* caps = context_.limits.caps) caps->add(copy.copy.part, copy.orientation, copy.offset);
            copy.object = tray_.add(std::move(objects[i]));
        }
        result_ = std::move(repaired);
    }

    void tell_anew() const {
        if (context_.observer) spectralpack::tell_anew(*context_.observer, context_.number, placed_);
    }

    Tray& tray_;
    std::vector<PlacedCopy>& placed_;
    const TrayContext& context_;
    const UntangleOptions& options_;
    PlacedBodies bodies_;
    std::vector<VoxelBox> freed_;  // where copies were taken out
    Untangled result_;
};

}  // namespace

Untangled untangle(Tray& tray, std::vector<PlacedCopy>& placed, const TrayContext& context,
                   const UntangleOptions& options) {
    return Untangling(tray, placed, context, options).run();
}

}  // namespace spectralpack
